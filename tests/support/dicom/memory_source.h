#pragma once
/// A source of DICOM objects in memory for tests.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "dicom/series_source.h"

namespace pdr::test {

/// Objects by name. Names are relative, so that notes show them as they are.
class MemorySource : public dicom::SeriesSource {
  public:
    using Bytes = std::vector<std::uint8_t>;

    void add(const std::filesystem::path& name, Bytes bytes) {
        objects_[name] = std::make_shared<const Bytes>(std::move(bytes));
    }
    void remove(const std::filesystem::path& name) { objects_.erase(name); }

    std::filesystem::path root() const override { return {}; }

    Result<Listing> list(const Progress&) const override {
        Listing found;
        for (const auto& [name, bytes] : objects_)
            found.names.push_back(name);
        return found;
    }

    Result<NamedBytes> open(const std::filesystem::path& name) const override {
        const auto object = objects_.find(name);
        if (object == objects_.end())
            return Error{"it is gone", name.string(), ""};
        return NamedBytes{name, object->second};
    }

  private:
    std::map<std::filesystem::path, std::shared_ptr<const Bytes>> objects_;
};

/// Returns the bytes of all plain files below `folder`, under their names as seen from it.
inline std::shared_ptr<MemorySource> inMemory(const std::filesystem::path& folder) {
    const auto source = std::make_shared<MemorySource>();
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file())
            continue;
        std::ifstream in(entry.path(), std::ios::binary);
        source->add(entry.path().lexically_relative(folder), {std::istreambuf_iterator<char>(in), {}});
    }
    return source;
}

}  // namespace pdr::test
