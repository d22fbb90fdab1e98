/// Writes slices on any planes for tests/oracle/check_slices.py.
///   oblique_slices made|sheared|FOLDER PLANES.json OUT
/// OUT holds the HU of all planes of the list, one after the other, as float32; NaN outside the volume.

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "dicom/import.h"
#include "render/slice/reslice.h"
#include "tests/support/oracle_plane.h"
#include "tests/support/scenes/made_volume.h"

namespace {

std::optional<pdr::Volume> volumeOf(const std::string& name) {
    if (name == "made")
        return pdr::test::madeVolume();
    if (name == "sheared")
        return pdr::test::shearedVolume();
    const auto scan = pdr::dicom::scanFolder(name, pdr::noProgress);
    if (!scan || scan->series.empty())
        return std::nullopt;
    auto volume = pdr::dicom::loadSeries(scan->series.front(), pdr::dicom::Padding::maskAsAir, pdr::noProgress);
    return volume ? std::optional(*std::move(volume)) : std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
    const std::optional<pdr::Volume> volume = argc == 4 ? volumeOf(argv[1]) : std::nullopt;
    if (!volume) {
        std::fprintf(stderr, "usage: oblique_slices made|sheared|FOLDER PLANES.json OUT\n");
        return 2;
    }
    std::ifstream planes(argv[2]);
    std::ofstream out(argv[3], std::ios::binary);
    for (const nlohmann::json& plane : nlohmann::json::parse(planes)) {
        const auto image = pdr::reslice(*volume, pdr::test::planeOf(plane));
        out.write(reinterpret_cast<const char*>(image->hu.data()), std::streamsize(image->hu.size() * sizeof(float)));
    }
    return out.good() ? 0 : 1;
}
