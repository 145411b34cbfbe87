// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesPerThread_h
#define vtkRidgesPerThread_h

#include <map>
#include <memory>
#include <mutex>
#include <thread>

/**
 * Scratch memory, one object per thread, made when the thread first needs it. Private to the
 * module. Not a vtkSMPThreadLocal: GCC 14 warns of a vector<bool> in that of VTK 9.3.
 */
template <typename Scratch>
class vtkRidgesPerThread
{
public:
  /// The object of this thread; `make` returns a shared pointer to a new one. To be called once for
  /// a range, as threads wait for each other here.
  template <typename Make>
  Scratch& Get(const Make& make)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    std::shared_ptr<Scratch>& scratch = this->Objects[std::this_thread::get_id()];
    if (!scratch)
    {
      scratch = make();
    }
    return *scratch;
  }

  /// Calls visit(object) for each, in any order, when no thread works.
  template <typename Visit>
  void ForEach(const Visit& visit)
  {
    for (const auto& object : this->Objects)
    {
      visit(*object.second);
    }
  }

private:
  std::mutex Mutex;
  std::map<std::thread::id, std::shared_ptr<Scratch>> Objects;
};

#endif
