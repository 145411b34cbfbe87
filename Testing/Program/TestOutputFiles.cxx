// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Console.h"
#include "MeshFiles.h"
#include "OutputFiles.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace
{

namespace fs = std::filesystem;

class OutputFilesTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Directory = ScratchPath("output-files");
    fs::remove_all(this->Directory);
    fs::create_directory(this->Directory);
  }
  void TearDown() override { fs::remove_all(this->Directory); }

  std::string PathOf(const char* name) const { return (this->Directory / name).string(); }

  std::string Read(const char* name) const
  {
    std::ifstream file(this->PathOf(name), std::ios::binary);
    return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  }

  std::size_t CountFiles() const
  {
    return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(this->Directory), fs::directory_iterator()));
  }

  fs::path Directory;
};

TEST_F(OutputFilesTest, WritesAllFilesOnceTheyAreComplete)
{
  std::ofstream(this->PathOf("old")) << "before";
  program::OutputFiles files;
  files.Add(this->PathOf("old"), "after", 5);
  files.Add(this->PathOf("new"), "a\0b", 3);
  EXPECT_EQ(this->Read("old"), "before");
  EXPECT_FALSE(fs::exists(this->PathOf("new")));
  files.Complete();
  EXPECT_EQ(this->Read("old"), "after");
  EXPECT_EQ(this->Read("new"), std::string("a\0b", 3));
  EXPECT_EQ(this->CountFiles(), 2U);
}

TEST_F(OutputFilesTest, LeavesNothingIfOneFileCannotBeWritten)
{
  {
    program::OutputFiles files;
    files.Add(this->PathOf("one"), "1", 1);
    EXPECT_THROW(files.Add(this->PathOf("none/two"), "2", 1), program::Failure);
  }
  EXPECT_EQ(this->CountFiles(), 0U);
}

TEST_F(OutputFilesTest, WritesThroughALink)
{
  std::ofstream(this->PathOf("target")) << "before";
  fs::create_symlink(this->PathOf("target"), this->PathOf("link"));
  program::OutputFiles files;
  files.Add(this->PathOf("link"), "after", 5);
  files.Complete();
  EXPECT_TRUE(fs::is_symlink(this->PathOf("link")));
  EXPECT_EQ(this->Read("target"), "after");
}

TEST_F(OutputFilesTest, GivesTheReasonWhenTheDiskIsFull)
{
  if (!fs::exists("/dev/full"))
  {
    GTEST_SKIP() << "no /dev/full here";
  }
  fs::create_symlink("/dev/full", this->PathOf("full"));
  program::OutputFiles files;
  try
  {
    files.Add(this->PathOf("full"), "bytes", 5);
    FAIL() << "no failure";
  }
  catch (const program::Failure& failure)
  {
    EXPECT_NE(std::string(failure.what()).find("cannot be written (No space left on device)"),
      std::string::npos)
      << failure.what();
  }
}

} // namespace
