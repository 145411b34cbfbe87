// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The program vtkridges: reads a mesh, and writes its ridges and umbilics and a picture of them.
 */

#include "Program.h"

#include <csignal>

int main(int argc, char* argv[])
{
#ifdef SIGXFSZ
  // A file that grows beyond a limit is an error of the file, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
#endif
  return program::RunProgram(argc, argv);
}
