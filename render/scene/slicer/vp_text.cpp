#include "render/scene/slicer/vp_text.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "render/scene/range.h"

namespace pdr::slicer {
namespace {

constexpr std::size_t kMostBytes = std::size_t(1) << 20;

struct VpError {
    Error error;
};

/// Reads the lines that hold something, one after the other.
class Lines {
  public:
    explicit Lines(std::string_view text) : rest_(text) {}

    /// Returns the numbers of the next line, called `what`; at least `least` of them.
    std::vector<double> numbers(const std::string& what, std::size_t least) {
        std::string_view line;
        do {
            if (rest_.empty())
                throw VpError{{phrase("is missing"), what, ""}};
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            line = withoutRemark(rest_.substr(0, end));
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
        } while (line.empty());
        std::vector<double> numbers;
        while (!line.empty()) {
            const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
            numbers.push_back(number(line.substr(0, end), what));
            line = trimmed(line.substr(end));
        }
        if (numbers.size() < least)
            throw VpError{{phrase("holds too few numbers"), what, ""}};
        return numbers;
    }
    double number(const std::string& what) { return numbers(what, 1)[0]; }
    /// Returns the values of a curve with `width` numbers per point.
    std::vector<double> points(const std::string& what, std::size_t width) {
        std::vector<double> values = numbers(what, 1);
        const double told = values[0];
        values.erase(values.begin());
        if (told != double(values.size()))
            throw VpError{
                {phrase("says it holds %1 values and holds %2", Text::number(numberText(told)), values.size()), what,
                 ""}};
        if (values.size() % width != 0)
            throw VpError{{phrase("holds points of %1 numbers, and one is not whole", width), what, ""}};
        return values;
    }

  private:
    static std::string_view trimmed(std::string_view line) {
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string_view::npos)
            return {};
        return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
    }
    static std::string_view withoutRemark(std::string_view line) {
        return trimmed(line.substr(0, std::min(line.find('#'), line.find("=>"))));
    }
    static double number(std::string_view word, const std::string& what) {
        double value = 0;
        const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (problem != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
            throw VpError{{phrase("holds \"%1\", which is no number", std::string(word.substr(0, 40))), what, ""}};
        return value;
    }

    std::string_view rest_;
};

VolumeProperty read(Lines lines) {
    VolumeProperty property;
    (void)lines.number("interpolation");
    property.shade = lines.number("shade") != 0;
    property.diffuse = lines.number("diffuse");
    property.ambient = lines.number("ambient");
    property.specular = lines.number("specular");
    property.specularPower = lines.number("specular power");
    const std::vector<double> opacity = lines.points("opacity", 2), gradient = lines.points("opacity by gradient", 2),
                              colour = lines.points("colour", 4);
    for (std::size_t i = 0; i < opacity.size(); i += 2)
        property.opacity.push_back({float(opacity[i]), float(opacity[i + 1])});
    for (std::size_t i = 1; i < gradient.size(); i += 2)
        property.simplified |= gradient[i] != 1;
    for (std::size_t i = 0; i < colour.size(); i += 4)
        property.colours.push_back({float(colour[i]), vec3(colour[i + 1], colour[i + 2], colour[i + 3])});
    return property;
}

}  // namespace

Result<VolumeProperty> propertyFromText(std::string_view text, std::string_view where) {
    if (text.size() > kMostBytes)
        return Error{phrase("is too long for a volume property"), std::string(where), ""};
    try {
        return read(Lines(text));
    } catch (const VpError& failure) {
        return Error{failure.error.what, std::string(where) + ", " + failure.error.where, ""};
    }
}

std::string textOf(const VolumeProperty& property) {
    std::string text = property.shade ? "1\n1\n" : "1\n0\n";
    for (const double value : {property.diffuse, property.ambient, property.specular, property.specularPower})
        text.append(numberText(value)).append("\n");
    const auto add = [&](double value) { text.append(" ").append(numberText(value)); };
    text.append(std::to_string(2 * property.opacity.size()));
    for (const CurvePoint& point : property.opacity) {
        add(double(point.hu));
        add(double(point.value));
    }
    text.append("\n4 0 1 255 1\n").append(std::to_string(4 * property.colours.size()));
    for (const ColourStop& stop : property.colours) {
        add(double(stop.hu));
        for (int channel = 0; channel < 3; ++channel)
            add(double(stop.albedo[channel]));
    }
    return text.append("\n");
}

}  // namespace pdr::slicer
