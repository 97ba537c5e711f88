// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's own reader is the outside opinion on our polydata files.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "sightline/viz/vtk_file.hpp"
#include "viz/pictures.hpp"
#include "viz/spaces.hpp"

namespace sightline::viz {
namespace {

struct ReadBack {
    explicit ReadBack(const DrawList& list) {
        std::ostringstream out;
        write_vtp(list, out);
        reader->ReadFromInputStringOn();
        reader->SetInputString(out.str());
        reader->Update();
        data = reader->GetOutput();
    }
    [[nodiscard]] long cell_value(const char* array, vtkIdType cell) const {
        return static_cast<long>(data->GetCellData()->GetArray(array)->GetTuple1(cell));
    }
    [[nodiscard]] std::array<double, 3> corner(vtkIdType cell, vtkIdType i) const {
        std::array<double, 3> p{};
        data->GetPoint(data->GetCell(cell)->GetPointId(static_cast<int>(i)), p.data());
        return p;
    }
    vtkNew<vtkXMLPolyDataReader> reader;
    vtkPolyData* data = nullptr;
};

TEST(VtkFileRoundTrip, CellsComeBackWithLayerAndId) {
    const ReadBack got(small_picture());
    ASSERT_EQ(got.data->GetNumberOfVerts(), 2);
    ASSERT_EQ(got.data->GetNumberOfLines(), 5);
    ASSERT_EQ(got.data->GetNumberOfPolys(), 7);
    // Verts, then lines, then polys, each in the order of the layers.
    EXPECT_EQ(got.cell_value("layer", 0), 3);
    EXPECT_EQ(got.cell_value("id", 1), 1);
    EXPECT_EQ(got.corner(1, 0), (std::array<double, 3>{5, 1, 0}));
    EXPECT_EQ(got.cell_value("layer", 2), 0);
    EXPECT_EQ(got.cell_value("id", 2), 7);
    EXPECT_EQ(got.data->GetCell(2)->GetNumberOfPoints(), 5) << "an outline is closed";
    EXPECT_EQ(got.cell_value("layer", 4), 1);
    EXPECT_EQ(got.cell_value("id", 5), 1);
    EXPECT_EQ(got.corner(5, 1), (std::array<double, 3>{9, 9, 0}));
    EXPECT_EQ(got.cell_value("layer", 6), 2);
    EXPECT_EQ(got.data->GetCell(6)->GetNumberOfPoints(), 3);
    for (vtkIdType cell = 7; cell < 14; ++cell) {
        EXPECT_EQ(got.cell_value("layer", cell), 0);
        EXPECT_EQ(got.cell_value("id", cell), 7);
    }
}

TEST(VtkFileRoundTrip, LayerNamesComeBack) {
    const ReadBack got(small_picture());
    const auto* names =
        vtkStringArray::SafeDownCast(got.data->GetFieldData()->GetAbstractArray("layers"));
    ASSERT_NE(names, nullptr);
    ASSERT_EQ(names->GetNumberOfValues(), 4);
    EXPECT_EQ(const_cast<vtkStringArray*>(names)->GetValue(1), "edges");
}

TEST(VtkFileRoundTrip, CoordinatesComeBackAsTheSameDoubles) {
    DrawList list;
    list.add({.name = "p", .points = {{1.0 / 3, 1e-300, -1e150}}});
    const ReadBack got(list);
    EXPECT_EQ(got.corner(0, 0), (std::array<double, 3>{1.0 / 3, 1e-300, -1e150}));
}

TEST(VtmFileRoundTrip, BlocksAreTheLayersUnderTheirNames) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "sightline-vtm";
    std::filesystem::create_directories(folder);
    const DrawList list = small_space();
    const std::vector<std::string> parts = vtm_parts(list, "s");
    for (std::size_t i = 0; i < parts.size(); ++i) {
        std::ofstream part(folder / parts[i]);
        write_vtm_part(list, i, part);
    }
    {
        std::ofstream index(folder / "s.vtm");
        write_vtm(list, "s", index);
    }
    vtkNew<vtkXMLMultiBlockDataReader> reader;
    reader->SetFileName((folder / "s.vtm").c_str());
    reader->Update();
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
    ASSERT_NE(blocks, nullptr);
    ASSERT_EQ(blocks->GetNumberOfBlocks(), list.layers.size());
    for (unsigned i = 0; i < blocks->GetNumberOfBlocks(); ++i) {
        EXPECT_EQ(blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()), list.layers[i].name);
        EXPECT_NE(vtkPolyData::SafeDownCast(blocks->GetBlock(i)), nullptr);
    }
    EXPECT_EQ(vtkPolyData::SafeDownCast(blocks->GetBlock(0))->GetNumberOfPolys(), 12);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace sightline::viz
