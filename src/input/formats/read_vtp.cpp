// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/formats/vtp.h"

#include "input/standard_input.h"
#include "system/text.h"

#include <vtkCellArray.h>
#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>

namespace idt {
namespace {

// Keeps the first error that VTK would print, from any of its objects.
class Error_keeper : public vtkOutputWindow
{
public:
  static Error_keeper* New();
  vtkTypeMacro(Error_keeper, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    if (error_.empty())
      error_ = text;
  }
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}

  bool has_error() const { return !error_.empty(); }
  // Of "ERROR: In FILE, line N\nCLASS (ADDRESS): TEXT\n\n" the text, on one line.
  std::string error() const
  {
    const std::size_t head = error_.find("): ");
    std::string text = head == std::string::npos ? error_ : error_.substr(head + 3);
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ' || text.back() == '.'))
      text.pop_back();
    // It may repeat contents of the file.
    std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, ' ');
    return text.substr(0, 200);
  }

private:
  std::string error_;
};

vtkStandardNewMacro(Error_keeper);

// While it lives, VTK is silent. VTK's log goes to the standard error separately.
class Silence
{
public:
  Silence() : before_(vtkOutputWindow::GetInstance()), verbosity_(vtkLogger::GetCurrentVerbosityCutoff())
  {
    vtkOutputWindow::SetInstance(keeper_);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~Silence()
  {
    vtkOutputWindow::SetInstance(before_);
    vtkLogger::SetStderrVerbosity(verbosity_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

  const Error_keeper& keeper() const { return *keeper_; }

private:
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkLogger::Verbosity verbosity_;
  vtkSmartPointer<Error_keeper> keeper_ = vtkSmartPointer<Error_keeper>::New();
};

// VTK allocates as much as a piece announces. Compression shrinks data by a factor of about 1000 at most.
void check_numbers(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}}, name = "NumberOf";
  if (text.empty())
    refuse_file(path, "the file is empty");
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::size_t number = text.find_first_of("\"'", at);
    if (number == std::string::npos)
      return;
    const double value = std::strtod(text.c_str() + number + 1, nullptr);
    if (!(value >= 0 && value <= 2000. * static_cast<double>(text.size())))
      refuse_file(path, "the number in " + quoted(text.substr(at, text.find_first_of("\"'", number + 1) - at + 1)) +
                          " does not agree with the size of the file");
  }
}

// A number that is not a vertex, if 32 bits are not enough.
std::uint32_t vertex_number(vtkIdType id)
{
  return id < 0 || id > (std::numeric_limits<std::uint32_t>::max)() ? (std::numeric_limits<std::uint32_t>::max)()
                                                                    : static_cast<std::uint32_t>(id);
}

} // namespace

CGAL::Intrinsic_triangulations::Polygon_soup read_vtp(const std::string& path)
{
  check_numbers(path);
  const Silence silence;
  const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  if (silence.keeper().has_error() || reader->GetErrorCode() != 0)
    refuse_file(path, "the file cannot be read" +
                        (silence.keeper().has_error() ? " (VTK: " + silence.keeper().error() + ")" : std::string()));
  vtkPolyData* const data = reader->GetOutput();
  if (data == nullptr)
    refuse_file(path, "the file holds no polygons");
  if (data->GetNumberOfStrips() != 0)
    refuse_file(path, "the file holds " + std::to_string(data->GetNumberOfStrips()) +
                        " triangle strips, which are not read: turn them into triangles first");
  const vtkIdType others = data->GetNumberOfVerts() + data->GetNumberOfLines();
  if (others != 0 && data->GetNumberOfPolys() == 0)
    refuse_file(path, "the file holds " + std::to_string(others) + " points or lines and no polygon");

  CGAL::Intrinsic_triangulations::Polygon_soup soup;
  soup.points.reserve(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (vtkIdType v = 0; v < data->GetNumberOfPoints(); ++v) {
    std::array<double, 3> point;
    data->GetPoint(v, point.data());
    soup.points.push_back(point);
  }
  vtkCellArray* const cells = data->GetPolys();
  if (cells == nullptr)
    return soup;
  std::vector<std::uint32_t> face;
  for (vtkIdType f = 0; f < cells->GetNumberOfCells(); ++f) {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(f, size, corners);
    face.resize(static_cast<std::size_t>(size));
    std::transform(corners, corners + size, face.begin(), vertex_number);
    soup.add_face(face.data(), face.data() + face.size());
  }
  return soup;
}

} // namespace idt
