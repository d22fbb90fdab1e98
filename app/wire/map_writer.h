#pragma once
/// Writes the map of a message field by field; the counterpart of MapReader. It does not check MapReader's limits, but
/// truncates texts to them.

#include <QCborStreamWriter>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "app/wire/messages.h"

namespace pdr::wire {

class MapWriter {
  public:
    MapWriter() { cbor_.startMap(); }

    template <class Number>
    void number(std::uint64_t key, Number value, std::uint64_t = 0, std::uint64_t = 0) {
        cbor_.append(quint64(key));
        cbor_.append(quint64(value));
    }
    template <class Number, std::size_t n>
    void numbers(std::uint64_t key, const std::array<Number*, n>& values, std::uint64_t = 0, std::uint64_t = 0) {
        cbor_.append(quint64(key));
        cbor_.startArray(n);
        for (const Number* value : values)
            cbor_.append(quint64(*value));
        cbor_.endArray();
    }
    void real(std::uint64_t key, double value, double, double);
    void reals(std::uint64_t key, std::span<const double> values);
    void bytes(std::uint64_t key, std::span<const std::byte> value);
    void text(std::uint64_t key, const std::string& value, std::size_t mostBytes);
    /// Writes `text` in English and, if it has a pattern, its parts (text_parts.h), unless these are too long.
    void phrase(std::uint64_t key, std::uint64_t partsKey, const Text& text);
    template <class T>
    bool optional(std::uint64_t, const std::optional<T>& value) {
        return value.has_value();
    }
    void must(bool, const char*) {}

    Bytes finish();

  private:
    QByteArray map_;
    QCborStreamWriter cbor_{&map_};
};

}  // namespace pdr::wire
