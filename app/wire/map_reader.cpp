#include "app/wire/map_reader.h"

#include "app/wire/line.h"
#include "app/wire/text_parts.h"

namespace pdr::wire {

namespace {

constexpr const char* kDamaged = "its map is damaged, or too deep";

}

MapReader::MapReader(std::span<const std::byte> map)
    : cbor_(reinterpret_cast<const char*>(map.data()), qsizetype(map.size())), mapBytes_(qint64(map.size())) {
    if (cbor_.isMap() && cbor_.enterContainer())
        readKey();
    else
        fail("it holds no map");
}

void MapReader::fail(const char* wrong) {
    if (!failed())
        wrong_ = wrong;
    key_.reset();
}

void MapReader::skip(int depth) {
    if (!failed() && !cbor_.next(depth))
        fail(kDamaged);
}

void MapReader::readKey() {
    const std::optional<std::uint64_t> before = key_;
    key_.reset();
    must(cbor_.lastError() == QCborError::NoError, kDamaged);  // errors of strings appear only here
    if (failed() || !cbor_.hasNext())
        return;
    if (!cbor_.isUnsignedInteger() || ++keys_ > kMostKeys)
        return fail("its map has keys that are no numbers, or too many");
    const std::uint64_t key = cbor_.toUnsignedInteger();
    if (before && key <= *before)
        return fail("a key of its map is there twice, or out of its place");
    skip();
    if (!failed())
        key_ = key;
}

bool MapReader::isNext(std::uint64_t key) {
    while (key_ && *key_ < key) {
        while (!failed() && cbor_.isTag())
            skip();
        skip(kMostDepth - 1);
        readKey();
    }
    return key_ == key;
}

bool MapReader::find(std::uint64_t key) {
    if (!isNext(key))
        fail("something is missing in it");
    return !failed();
}

std::uint64_t MapReader::readNumber(std::uint64_t low, std::uint64_t high) {
    if (failed() || !cbor_.isUnsignedInteger()) {
        fail("a number in it is none");
        return 0;
    }
    const std::uint64_t value = cbor_.toUnsignedInteger();
    if (value < low || value > high)
        fail("a number in it is out of its range");
    skip();
    return failed() ? 0 : value;
}

double MapReader::readReal(double low, double high) {
    if (failed() || !cbor_.isDouble()) {
        fail("a number in it is none");
        return 0;
    }
    const double value = cbor_.toDouble();
    if (!(value >= low && value <= high))
        fail("a number in it is out of its range");
    skip();
    return failed() ? 0 : value;
}

void MapReader::enterArray(std::size_t length) {
    if (!cbor_.isArray() || !cbor_.isLengthKnown() || cbor_.length() != length || !cbor_.enterContainer())
        fail("a list in it has another length");
}

void MapReader::leaveArray() {
    if (!failed())
        must(cbor_.leaveContainer(), kDamaged);
    readKey();
}

void MapReader::real(std::uint64_t key, double& value, double low, double high) {
    if (find(key)) {
        value = readReal(low, high);
        readKey();
    }
}

void MapReader::reals(std::uint64_t key, std::span<double> values) {
    if (!find(key))
        return;
    enterArray(values.size());
    for (double& value : values)
        value = readReal(std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
    leaveArray();
}

std::size_t MapReader::stringBytes(QCborStreamReader::Type type, std::size_t most) {
    if (cbor_.type() == type && cbor_.isLengthKnown() && cbor_.length() <= most)
        return std::size_t(cbor_.length());
    fail("a text or a sequence of bytes in it is too long, or none");
    return 0;
}

void MapReader::readString(void* into, std::size_t bytes) {
    if (failed())
        return;
    const auto part = cbor_.readStringChunk(static_cast<char*>(into), qsizetype(bytes));
    if (part.status != QCborStreamReader::Ok || part.data != qsizetype(bytes) ||
        cbor_.readStringChunk(nullptr, 0).status != QCborStreamReader::EndOfString)
        fail(kDamaged);
}

void MapReader::bytes(std::uint64_t key, std::span<std::byte> value) {
    if (!find(key))
        return;
    must(stringBytes(QCborStreamReader::ByteArray, value.size()) == value.size(), "a sequence of bytes is too short");
    readString(value.data(), value.size());
    readKey();
}

void MapReader::text(std::uint64_t key, std::string& value, std::size_t mostBytes) {
    if (!find(key))
        return;
    value.resize(stringBytes(QCborStreamReader::String, mostBytes));
    readString(value.data(), value.size());
    must(isLine(value), "a text in it is no line");
    readKey();
}

void MapReader::phrase(std::uint64_t key, std::uint64_t partsKey, Text& value) {
    std::string english, parts;
    text(key, english, kMostWordBytes);
    if (!failed() && isNext(partsKey))
        text(partsKey, parts, kMostWordBytes);
    if (!failed())
        value = textOf(english, parts);
}

const char* MapReader::finish() {
    isNext(std::numeric_limits<std::uint64_t>::max());
    if (!failed())
        must(!cbor_.hasNext() && cbor_.leaveContainer() && cbor_.currentOffset() == mapBytes_,
             "there is something behind its map");
    return wrong_;
}

}  // namespace pdr::wire
