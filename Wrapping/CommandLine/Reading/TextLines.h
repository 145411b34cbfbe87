// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TextLines_h
#define TextLines_h

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace program
{

/**
 * Walks over the lines of a text, and over the words of a line. Lines end with LF, CR LF or, if
 * the first line does, with CR. Empty lines and comments are skipped.
 */
class TextLines
{
public:
  /// The text must outlive the object. A byte order mark of UTF-8 is skipped. `comment` is the
  /// character that begins a comment, or 0.
  TextLines(std::string_view text, std::string fileName, char comment);

  /// Goes to the next line that is neither empty nor a comment. False at the end of the text.
  bool NextLine();

  /// Goes past the next line that is empty, or to the end of the text.
  void SkipToEmptyLine();

  /// Goes to the next word, on this line or a later one. False at the end of the text.
  bool NextWord();

  bool AtLineEnd();
  void SkipLine() { this->At = this->End; }

  /// The next word of this line, empty at its end.
  std::string_view PeekWord();

  /// The same, and goes past it.
  std::string_view Word();

  /// The next word as a number, and goes past it; nothing if it is not a number as a whole.
  std::optional<double> Real();
  std::optional<long long> Integer();

  /// Goes past this many bytes after this line; null if there are fewer.
  const char* Bytes(std::size_t count);

  /// Bytes after this line.
  std::size_t BytesLeft() const { return static_cast<std::size_t>(this->TextEnd - this->Next); }

  /// Bytes after the last word.
  std::size_t CharactersLeft() const { return static_cast<std::size_t>(this->TextEnd - this->At); }

  long long LineNumber() const { return this->Number; }

  /// Throws Failure with the name of the file and the number of this or another line.
  [[noreturn]] void Fail(const std::string& what, const std::string& whatToDo) const;
  [[noreturn]] void FailAt(
    long long line, const std::string& what, const std::string& whatToDo) const;

private:
  bool NextRawLine();

  const char* Next; ///< Where the next line begins.
  const char* TextEnd;
  const char* At;
  const char* End; ///< Of this line, or where a comment in it begins.
  long long Number = 0;
  char LineEnd;
  char Comment;
  std::string FileName;
};

/// A word as a number; nothing if it is not one as a whole.
std::optional<double> ToReal(std::string_view word);
std::optional<long long> ToInteger(std::string_view word);

/// A word of a file as it can be printed: in quotes, short, in ASCII.
std::string Quoted(std::string_view word);

/// For numbers of things that a file announces: "4 of 12 faces".
std::string CountOf(unsigned long long done, unsigned long long count, const char* things);

} // namespace program

#endif
