// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reading/TextLines.h"

#include "Console.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>

namespace program
{
namespace
{

/// CR, if the first line ends with it alone.
char FindLineEnd(std::string_view text)
{
  const std::size_t first = text.find_first_of("\r\n");
  const bool isCR = first != std::string_view::npos && text[first] == '\r' &&
    (first + 1 == text.size() || text[first + 1] != '\n');
  return isCR ? '\r' : '\n';
}

const char* Find(const char* begin, const char* end, char c)
{
  const void* found = std::memchr(begin, c, static_cast<std::size_t>(end - begin));
  return found ? static_cast<const char*>(found) : end;
}

/// LF too, which is no line end where CR is.
bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f' || c == '\n';
}

/// Where a number begins: std::from_chars does not accept a plus sign.
const char* WithoutPlus(std::string_view word)
{
  return word.data() + (!word.empty() && word.front() == '+' ? 1 : 0);
}

} // namespace

TextLines::TextLines(std::string_view text, std::string fileName, char comment)
  : Next(text.data())
  , TextEnd(text.data() + text.size())
  , At(text.data())
  , End(text.data())
  , LineEnd(FindLineEnd(text))
  , Comment(comment)
  , FileName(std::move(fileName))
{
  if (text.substr(0, 3) == "\xef\xbb\xbf")
  {
    this->Next += 3;
  }
}

bool TextLines::NextRawLine()
{
  if (this->Next == this->TextEnd)
  {
    this->At = this->TextEnd;
    this->End = this->TextEnd;
    return false;
  }
  ++this->Number;
  this->At = this->Next;
  const char* lineEnd = Find(this->Next, this->TextEnd, this->LineEnd);
  this->Next = lineEnd == this->TextEnd ? lineEnd : lineEnd + 1;
  this->End = this->Comment != '\0' ? Find(this->At, lineEnd, this->Comment) : lineEnd;
  return true;
}

bool TextLines::NextLine()
{
  while (this->NextRawLine())
  {
    if (!this->AtLineEnd())
    {
      return true;
    }
  }
  return false;
}

void TextLines::SkipToEmptyLine()
{
  while (this->NextRawLine() && !this->AtLineEnd())
  {
  }
}

bool TextLines::NextWord()
{
  return !this->AtLineEnd() || this->NextLine();
}

bool TextLines::AtLineEnd()
{
  while (this->At < this->End && IsBlank(*this->At))
  {
    ++this->At;
  }
  return this->At == this->End;
}

std::string_view TextLines::PeekWord()
{
  if (this->AtLineEnd())
  {
    return {};
  }
  const char* end = std::find_if(this->At, this->End, IsBlank);
  return { this->At, static_cast<std::size_t>(end - this->At) };
}

std::string_view TextLines::Word()
{
  const std::string_view word = this->PeekWord();
  this->At += word.size();
  return word;
}

std::optional<double> TextLines::Real()
{
  const std::optional<double> value = ToReal(this->PeekWord());
  this->At += value ? this->PeekWord().size() : 0;
  return value;
}

std::optional<long long> TextLines::Integer()
{
  const std::optional<long long> value = ToInteger(this->PeekWord());
  this->At += value ? this->PeekWord().size() : 0;
  return value;
}

const char* TextLines::Bytes(std::size_t count)
{
  if (count > this->BytesLeft())
  {
    return nullptr;
  }
  const char* bytes = this->Next;
  this->Next += count;
  this->At = this->Next;
  this->End = this->Next;
  return bytes;
}

void TextLines::Fail(const std::string& what, const std::string& whatToDo) const
{
  this->FailAt(this->Number, what, whatToDo);
}

void TextLines::FailAt(long long line, const std::string& what, const std::string& whatToDo) const
{
  throw Failure(this->FileName + ", line " + std::to_string(line) + ": " + what, whatToDo);
}

std::optional<double> ToReal(std::string_view word)
{
  const char* begin = WithoutPlus(word);
  const char* end = word.data() + word.size();
  double value = 0.0;
  const auto [last, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range)
  {
    return std::strtod(std::string(begin, end).c_str(), nullptr); // 0 or infinite
  }
  return error == std::errc() && last == end ? std::optional<double>(value) : std::nullopt;
}

std::optional<long long> ToInteger(std::string_view word)
{
  const char* end = word.data() + word.size();
  long long value = 0;
  const auto [last, error] = std::from_chars(WithoutPlus(word), end, value);
  return error == std::errc() && last == end ? std::optional<long long>(value) : std::nullopt;
}

std::string Quoted(std::string_view word)
{
  constexpr std::size_t most = 20;
  std::string text(word.substr(0, most));
  for (char& c : text)
  {
    c = c >= ' ' && c <= '~' ? c : '?';
  }
  return "'" + text + (word.size() > most ? "...'" : "'");
}

std::string CountOf(unsigned long long done, unsigned long long count, const char* things)
{
  return std::to_string(done) + " of " + std::to_string(count) + " " + things;
}

} // namespace program
