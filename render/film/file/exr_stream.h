#pragma once
/// What all OpenEXR files have in common: the stream that they are written to, and facts as attributes.

#include <ImfDoubleAttribute.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfStringAttribute.h>

#include <cstdint>
#include <ios>
#include <string>
#include <variant>
#include <vector>

#include "render/base/replacing_file.h"
#include "render/film/file/provenance.h"

namespace pdr {

/// An OpenEXR output stream that writes to a ReplacingFile. The library takes exceptions for errors.
class ExrStream : public Imf::OStream {
  public:
    ExrStream(ReplacingFile& file, const std::string& name) : Imf::OStream(name.c_str()), file_(file) {}

    void write(const char bytes[], int count) override {
        if (!file_.write(bytes, std::size_t(count)))
            throw std::ios_base::failure("write");
    }
    std::uint64_t tellp() override { return file_.position(); }
    void seekp(std::uint64_t position) override {
        if (!file_.seek(position))
            throw std::ios_base::failure("seek");
    }

  private:
    ReplacingFile& file_;
};

inline void insertFacts(Imf::Header& header, const std::vector<Fact>& facts) {
    for (const Fact& fact : facts)
        if (const auto* words = std::get_if<std::string>(&fact.value))
            header.insert(fact.name, Imf::StringAttribute(*words));
        else
            header.insert(fact.name, Imf::DoubleAttribute(std::get<double>(fact.value)));
}

}  // namespace pdr
