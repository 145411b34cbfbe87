// SPDX-FileCopyrightText: Copyright (c) vtkRidges contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef XmlVtkReader_h
#define XmlVtkReader_h

#include "Reading/PolygonMesh.h"

#include <string>

namespace program
{

/**
 * Reads a polygonal dataset in VTK's XML format by vtkXMLPolyDataReader, after the checks of
 * CheckXmlVtk. Throws Failure; what the reader reports goes to vtkOutputWindow.
 */
vtkSmartPointer<vtkPolyData> ParseXmlVtk(const std::string& bytes, const std::string& fileName);

/// Polygons and strips of a dataset, but for duplicate and hidden cells. Throws Failure if the
/// cells name points that are not there.
PolygonMesh ToPolygonMesh(vtkPolyData* data, const std::string& fileName);

} // namespace program

#endif
