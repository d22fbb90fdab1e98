#include "app/wire/map_writer.h"

#include "app/wire/line.h"
#include "app/wire/text_parts.h"

namespace pdr::wire {

void MapWriter::real(std::uint64_t key, double value, double, double) {
    cbor_.append(quint64(key));
    cbor_.append(value);
}

void MapWriter::reals(std::uint64_t key, std::span<const double> values) {
    cbor_.append(quint64(key));
    cbor_.startArray(values.size());
    for (const double value : values)
        cbor_.append(value);
    cbor_.endArray();
}

void MapWriter::bytes(std::uint64_t key, std::span<const std::byte> value) {
    cbor_.append(quint64(key));
    cbor_.appendByteString(reinterpret_cast<const char*>(value.data()), qsizetype(value.size()));
}

void MapWriter::text(std::uint64_t key, const std::string& value, std::size_t mostBytes) {
    const std::string line = lineOf(value, mostBytes);
    cbor_.append(quint64(key));
    cbor_.appendTextString(line.data(), qsizetype(line.size()));
}

void MapWriter::phrase(std::uint64_t key, std::uint64_t partsKey, const Text& value) {
    text(key, value, kMostWordBytes);
    if (const std::string parts = partsOf(value); !parts.empty() && parts.size() <= kMostWordBytes)
        text(partsKey, parts, kMostWordBytes);
}

Bytes MapWriter::finish() {
    cbor_.endMap();
    const auto bytes = std::as_bytes(std::span(map_.constData(), std::size_t(map_.size())));
    return {bytes.begin(), bytes.end()};
}

}  // namespace pdr::wire
