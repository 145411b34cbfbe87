// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FileBytes_h
#define FileBytes_h

#include <string>

namespace program
{

/// The bytes of a file. Throws Failure with the reason if it does not exist, is empty, or cannot be
/// read to its end.
std::string ReadBytes(const std::string& fileName);

} // namespace program

#endif
