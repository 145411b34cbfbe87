// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRidgesPerThread_h
#define vtkRidgesPerThread_h

#include "vtkSMPThreadLocal.h"

#include <memory>

/**
 * Scratch memory, one object per thread, made when the thread first needs it. Private to the
 * module.
 */
template <typename Scratch>
class vtkRidgesPerThread
{
public:
  /// The object of this thread; `make` returns a shared pointer to a new one.
  template <typename Make>
  Scratch& Get(const Make& make)
  {
    std::shared_ptr<Scratch>& scratch = this->Local->Local();
    if (!scratch)
    {
      scratch = make();
    }
    return *scratch;
  }

private:
  // Pointers, as vtkSMPThreadLocal copies the value it starts from. On the heap, as GCC 14 warns of
  // a vector<bool> in VTK 9.3 where it sees through the construction.
  using Pointers = vtkSMPThreadLocal<std::shared_ptr<Scratch>>;
  std::shared_ptr<Pointers> Local = std::make_shared<Pointers>();
};

#endif
