// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Program_h
#define Program_h

namespace program
{

/// The whole program, from its arguments to its exit code.
int RunProgram(int argc, char** argv);

} // namespace program

#endif
