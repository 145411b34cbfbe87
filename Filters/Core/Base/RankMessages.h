// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
// Values instead of bytes, between ranks that run on machines of one kind.

#ifndef ridges_RankMessages_h
#define ridges_RankMessages_h

#include "Base/Ranks.h"
#include "Base/Types.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ridges
{

/// Appends the values and how many there are.
template <typename T>
void Pack(Bytes& bytes, const std::vector<T>& values)
{
  static_assert(std::is_trivially_copyable_v<T>, "sent as it is in memory");
  const std::uint64_t count = values.size();
  const std::size_t size = count * sizeof(T);
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof count + size);
  std::memcpy(bytes.data() + at, &count, sizeof count);
  if (size > 0)
  {
    std::memcpy(bytes.data() + at + sizeof count, values.data(), size);
  }
}

inline void PackText(Bytes& bytes, const std::string& text)
{
  Pack(bytes, std::vector<char>(text.begin(), text.end()));
}

/// Takes values in the order in which they were packed. An empty message has none.
class Unpacker
{
public:
  explicit Unpacker(const Bytes& bytes)
    : Bytes_(bytes)
  {
  }

  template <typename T>
  std::vector<T> Take()
  {
    std::uint64_t count = 0;
    if (this->At_ < this->Bytes_.size())
    {
      std::memcpy(&count, this->Bytes_.data() + this->At_, sizeof count);
      this->At_ += sizeof count;
    }
    std::vector<T> values(count);
    if (count > 0)
    {
      std::memcpy(values.data(), this->Bytes_.data() + this->At_, count * sizeof(T));
      this->At_ += count * sizeof(T);
    }
    return values;
  }

  std::string TakeText()
  {
    const std::vector<char> text = this->Take<char>();
    return std::string(text.begin(), text.end());
  }

  /// What was not taken yet.
  const char* Rest() const { return this->Bytes_.data() + this->At_; }

private:
  const Bytes& Bytes_;
  std::size_t At_ = 0;
};

/// Values for each rank; what each rank has for this one. Nothing is kept longer than it is needed.
template <typename T>
std::vector<std::vector<T>> ExchangeValues(Ranks& ranks, std::vector<std::vector<T>> values)
{
  std::vector<Bytes> messages(values.size());
  for (std::size_t rank = 0; rank < values.size(); ++rank)
  {
    Pack(messages[rank], values[rank]);
    values[rank] = std::vector<T>();
  }
  messages = ranks.Exchange(std::move(messages));
  for (std::size_t rank = 0; rank < values.size(); ++rank)
  {
    values[rank] = Unpacker(messages[rank]).Take<T>();
    messages[rank] = Bytes();
  }
  return values;
}

} // namespace ridges

#endif
