#pragma once
/// A temporary folder of slices for tests.

#include <QTemporaryDir>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "dicom/import.h"
#include "tests/support/dicom/slice_file.h"

namespace pdr::test {

class SliceFolder {
  public:
    std::filesystem::path path() const { return folder_.path().toStdString(); }

    /// Adds `count` slices 2 mm apart, called prefix00, ...; `change` may alter the k-th slice.
    void addStack(int count, SliceFile like = {}, const std::string& prefix = "s",
                  const std::function<void(int, SliceFile&)>& change = {}) const {
        for (int k = 0; k < count; ++k) {
            SliceFile slice = like;
            slice.position = {0, 0, 2.0 * k};
            if (change)
                change(k, slice);
            char number[16];
            std::snprintf(number, sizeof number, "%02d", k);
            writeSliceFile(path() / (prefix + number), slice);
        }
    }
    void addText(const std::string& name, const std::string& text) const { std::ofstream(path() / name) << text; }

    /// Scans the folder; returns an empty result if that fails.
    dicom::ScanResult scan() const {
        Result<dicom::ScanResult> result = dicom::scanFolder(path(), noProgress);
        return result ? *std::move(result) : dicom::ScanResult{};
    }

  private:
    QTemporaryDir folder_;
};

}  // namespace pdr::test
