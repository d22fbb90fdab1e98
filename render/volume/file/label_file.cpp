#include "render/volume/file/label_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <new>
#include <optional>
#include <span>

#include "render/base/errors.h"
#include "render/base/free_memory.h"
#include "render/volume/file/label_table.h"
#include "render/volume/file/scan_endings.h"

namespace pdr {
namespace {

Error noLabels(const std::filesystem::path& file, const Text& what) {
    return {what, file.string(), phrase("Choose a label map: whole numbers from 0 on, one for each part."),
            ErrorKind::refused};
}

const char* formatName(const std::filesystem::path& file) {
    const std::string ending = scanEnding(file);
    if (ending.starts_with(".nii"))
        return "NIfTI";
    return ending == ".nrrd" || ending == ".nhdr" ? "NRRD" : "MetaImage";
}

/// Gives each value that occurs a label, in the order in which they occur: 0 is always 0.
class ValueLabels {
  public:
    /// Returns the label of a value, a whole number from 0 on; none if there are too many.
    std::optional<std::uint8_t> of(double value) {
        if (value == 0)
            return std::uint8_t(0);
        if (value == last_)
            return lastLabel_;
        const auto [found, isNew] = labels_.try_emplace(std::int64_t(value), labels_.size() + 1);
        if (isNew && labels_.size() > LabelMap::kMostParts)
            return {};
        last_ = value;
        lastLabel_ = std::uint8_t(found->second);
        return lastLabel_;
    }
    const std::map<std::int64_t, std::size_t>& all() const { return labels_; }

  private:
    std::map<std::int64_t, std::size_t> labels_;
    double last_ = 0;
    std::uint8_t lastLabel_ = 0;
};

/// Reads the samples of a file as labels.
class LabelReading {
  public:
    LabelReading(const GridFile& grid, const Progress& progress) : grid_(grid), progress_(progress) {}

    /// Fills `labels`, in the order in which values occur.
    Result<void> fill(HugePageVector<std::uint8_t>& labels) {
        std::array<double, 8192> piece;
        GridSamples samples(grid_);
        for (std::size_t at = 0; at < labels.size(); at += piece.size()) {
            const std::span<double> values = std::span(piece).first(std::min(piece.size(), labels.size() - at));
            if (auto ok = samples.read(values); !ok)
                return ok;
            if (auto ok = take(values, labels.data() + at); !ok)
                return ok;
            if (!progress_(double(at) / double(labels.size()), "reading labels"))
                return cancelled();
        }
        return {};
    }
    const ValueLabels& values() const { return values_; }

  private:
    Result<void> take(std::span<const double> samples, std::uint8_t* out) {
        for (const double sample : samples) {
            const double value = sample * grid_.slope + grid_.intercept;
            if (!(value >= 0 && value < 9e15) || value != std::floor(value))
                return noLabels(grid_.file, phrase("its value %1 is no label", numberOf(value)));
            const auto label = values_.of(value);
            if (!label)
                return noLabels(grid_.file, phrase("it has more than %1 labels", int(LabelMap::kMostParts)));
            *out++ = *label;
        }
        return {};
    }

    const GridFile& grid_;
    const Progress& progress_;
    ValueLabels values_;
};

/// Sets the parts, numbered by their values, and their names; notes names without voxels.
void nameParts(LabelMap& map, const ValueLabels& values, const GridFile& grid) {
    LabelTable table = labelTable(grid);
    std::array<std::uint8_t, LabelMap::kMostParts + 1> label{};
    for (const auto& [value, found] : values.all()) {
        const StatedPart& stated = table[value];
        map.parts.push_back(
            {stated.name.empty() ? standardName(value) : stated.name, stated.colour.value_or(standardColour(value))});
        label[found] = std::uint8_t(map.parts.size());
    }
    std::ranges::transform(map.labels, map.labels.begin(), [&](std::uint8_t found) { return label[found]; });
    const auto isEmpty = [&](const auto& stated) { return stated.first > 0 && !values.all().contains(stated.first); };
    if (const auto empty = std::ranges::count_if(table, isEmpty))
        map.notes.push_back(emptyPartsNote(empty));
}

}  // namespace

Result<LabelMap> readLabelFile(const std::filesystem::path& file, const Progress& progress, const OpenBytes& open,
                               Unmarked unmarked) {
    const Result<GridFile> grid = readGridFile(file, open);
    if (!grid)
        return grid.error();
    const std::size_t needed = grid->geometry.voxelCount();
    const Error tooLarge = notEnoughMemoryForVoxels(needed, file.string());
    if (needed > freeBytes())
        return tooLarge;
    try {
        LabelMap map;
        map.geometry = grid->geometry;
        map.source = phrase("a label map (%1)", formatName(file));
        map.labels = HugePageVector<std::uint8_t>(needed);
        LabelReading reading(*grid, progress);
        if (auto ok = reading.fill(map.labels); !ok)
            return ok.error();
        nameParts(map, reading.values(), *grid);
        if (map.parts.empty() && unmarked == Unmarked::refused)
            return noLabels(file, phrase("it marks no voxel"));
        return map;
    } catch (const std::bad_alloc&) {
        return tooLarge;
    }
}

}  // namespace pdr
