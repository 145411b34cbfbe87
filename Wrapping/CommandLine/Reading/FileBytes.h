// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FileBytes_h
#define FileBytes_h

#include <string>

namespace program
{

/// Throws Failure if there is no such file, or if it is a directory; then with what is wanted.
void CheckIsFile(const std::string& fileName, const std::string& wanted);

/// With its dot, in small letters.
std::string ExtensionOf(const std::string& fileName);

/// The bytes of a file. Throws Failure with the reason if it does not exist, is empty, or cannot be
/// read to its end.
std::string ReadBytes(const std::string& fileName);

} // namespace program

#endif
