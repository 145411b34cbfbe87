// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MessageRecorder_h
#define MessageRecorder_h

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

/// Collects the errors and warnings of an algorithm, which would be printed, and apart from them
/// the errors of its executive: that a request failed, or that an input is missing.
class MessageRecorder
{
public:
  explicit MessageRecorder(vtkAlgorithm* algorithm)
    : Observed{ vtkSmartPointer<vtkObject>(algorithm),
      vtkSmartPointer<vtkObject>(algorithm->GetExecutive()) }
  {
    for (std::size_t i = 0; i < this->Observed.size(); ++i)
    {
      this->Tags[2 * i] =
        this->Observed[i]->AddObserver(vtkCommand::ErrorEvent, this, &MessageRecorder::Record);
      this->Tags[2 * i + 1] =
        this->Observed[i]->AddObserver(vtkCommand::WarningEvent, this, &MessageRecorder::Record);
    }
  }

  ~MessageRecorder()
  {
    for (std::size_t i = 0; i < this->Tags.size(); ++i)
    {
      this->Observed[i / 2]->RemoveObserver(this->Tags[i]);
    }
  }

  MessageRecorder(const MessageRecorder&) = delete;
  MessageRecorder& operator=(const MessageRecorder&) = delete;

  std::size_t NumberOfErrors() const { return this->Errors.size(); }
  std::size_t NumberOfWarnings() const { return this->Warnings.size(); }

  /// All texts in one, for looking up words in them and for telling what was unexpected.
  std::string ErrorText() const { return Joined(this->Errors); }
  std::string ExecutiveErrorText() const { return Joined(this->ExecutiveErrors); }
  std::string WarningText() const { return Joined(this->Warnings); }

private:
  void Record(vtkObject* caller, unsigned long event, void* text)
  {
    auto& texts = event != vtkCommand::ErrorEvent ? this->Warnings
      : caller == this->Observed[0]               ? this->Errors
                                                  : this->ExecutiveErrors;
    texts.emplace_back(static_cast<const char*>(text));
  }

  static std::string Joined(const std::vector<std::string>& texts)
  {
    std::string all;
    for (const std::string& text : texts)
    {
      all += text;
    }
    return all;
  }

  std::array<vtkSmartPointer<vtkObject>, 2> Observed;
  std::array<unsigned long, 4> Tags{};
  std::vector<std::string> Errors;
  std::vector<std::string> ExecutiveErrors;
  std::vector<std::string> Warnings;
};

#endif
