#pragma once
/// Reader of command-line options as text, numbers and whole numbers, with an error message for a wrong value.

#include <QCommandLineParser>

#include <cstdint>
#include <optional>
#include <string>

#include "render/base/result.h"
#include "render/scene/range.h"

namespace pdr::app {

[[noreturn]] inline void usageError(const QString& option, const std::string& what, const std::string& hint = "") {
    throw Error{what, option.toStdString(), hint};
}

/// Reader of the options of a parsed command line. Returns null for an absent option, and throws an Error that names
/// the first wrong one.
class Reader {
  public:
    explicit Reader(const QCommandLineParser& parser) : parser_(parser) {}

    std::optional<QString> text(const QString& name) const {
        return parser_.isSet(name) ? std::optional(parser_.value(name)) : std::nullopt;
    }

    std::optional<double> number(const QString& name, const Range& range) const {
        if (!parser_.isSet(name))
            return std::nullopt;
        return inRange(name, parser_.value(name), 1, range);
    }

    /// Reads a fraction: a number, or a percentage such as 5%. The range is that of the fraction.
    std::optional<double> fraction(const QString& name, const Range& range) const {
        if (!parser_.isSet(name))
            return std::nullopt;
        QString value = parser_.value(name);
        const bool percent = value.endsWith('%');
        if (percent)
            value.chop(1);
        return inRange(name, value.trimmed(), percent ? 100 : 1, range);
    }

    std::optional<std::uint64_t> whole(const QString& name, std::uint64_t lowest, std::uint64_t highest) const {
        if (!parser_.isSet(name))
            return std::nullopt;
        bool ok = false;
        const std::uint64_t value = parser_.value(name).toULongLong(&ok);
        if (!ok || value < lowest || value > highest)
            usageError("--" + name, "must be a whole number from " + std::to_string(lowest) + " to " +
                                        std::to_string(highest) + ", not \"" + text(name)->toStdString() + "\"");
        return value;
    }

  private:
    double inRange(const QString& name, const QString& number, double divisor, const Range& range) const {
        bool ok = false;
        const double value = number.toDouble(&ok) / divisor;
        if (!ok || !range.holds(value))
            usageError("--" + name, "must be a number " + range.text() + ", not \"" + text(name)->toStdString() + "\"");
        return value;
    }

    const QCommandLineParser& parser_;
};

}  // namespace pdr::app
