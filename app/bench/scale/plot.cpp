#include "app/bench/scale/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace pdr::bench::scale {

namespace {

constexpr double kWidth = 960, kHeight = 420, kLeft = 74, kRight = 250, kTop = 16, kBottom = 46;

/// Colours that readers who confuse red and green can tell apart (Okabe & Ito).
constexpr const char* kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"};

/// Formats a coordinate of the drawing.
std::string at(double place) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", place);
    return text;
}

/// Formats a number beside an axis.
std::string plain(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

/// Escapes a text for XML. Names come from this program, but may contain special characters of XML.
std::string escaped(const std::string& plain) {
    std::string out;
    for (const char letter : plain)
        out += letter == '&' ? "&amp;" : letter == '<' ? "&lt;" : std::string(1, letter);
    return out;
}

class Scale {
  public:
    Scale(double low, double high, double from, double to, bool logarithmic)
        : low_(low), high_(high), from_(from), to_(to), logarithmic_(logarithmic) {}

    bool shows(double value) const { return std::isfinite(value) && (!logarithmic_ || value > 0); }
    double operator()(double value) const {
        const double held = std::clamp(value, low_, high_);
        const double share =
            logarithmic_ ? std::log(held / low_) / std::log(high_ / low_) : (held - low_) / (high_ - low_);
        return from_ + share * (to_ - from_);
    }
    double low() const { return low_; }
    double high() const { return high_; }

  private:
    double low_, high_, from_, to_;
    bool logarithmic_;
};

/// Returns a scale of whole decades around all values.
Scale decades(const Plot& plot, bool across, double from, double to) {
    double low = INFINITY, high = 0;
    for (const Curve& curve : plot.curves)
        for (const auto& [nodes, value] : curve.points)
            if (const double one = across ? nodes : value; one > 0 && std::isfinite(one))
                low = std::min(low, one), high = std::max(high, one);
    if (!(low <= high))
        low = high = 1;
    const double first = std::floor(std::log10(low)), last = std::max(first + 1, std::ceil(std::log10(high)));
    return {std::pow(10, first), std::pow(10, last), from, to, true};
}

std::string line(double x1, double y1, double x2, double y2) {
    return "<line x1='" + at(x1) + "' y1='" + at(y1) + "' x2='" + at(x2) + "' y2='" + at(y2) + "' stroke='#ddd'/>";
}

std::string label(double x, double y, const char* anchor, const std::string& words) {
    return "<text x='" + at(x) + "' y='" + at(y) + "' text-anchor='" + anchor + "'>" + escaped(words) + "</text>";
}

std::string axes(const Plot& plot, const Scale& nodes, const Scale& values) {
    std::string drawn;
    for (double n = nodes.low(); n <= 1.001 * nodes.high(); n *= 10)
        drawn += line(nodes(n), kTop, nodes(n), kHeight - kBottom) +
                 label(nodes(n), kHeight - kBottom + 16, "middle", plain(n));
    for (double v = values.low(); v <= 1.001 * values.high(); v = plot.share ? v + 0.2 : v * 10)
        drawn += line(kLeft, values(v), kWidth - kRight, values(v)) + label(kLeft - 6, values(v) + 4, "end", plain(v));
    return drawn + label((kLeft + kWidth - kRight) / 2, kHeight - 10, "middle", "nodes") +
           "<text transform='translate(14 " + at((kTop + kHeight - kBottom) / 2) +
           ") rotate(-90)' text-anchor='middle'>" + escaped(plot.title) + "</text>";
}

std::string strokeOf(const Curve& curve) {
    return std::string("stroke='") + kColours[curve.colour % std::size(kColours)] +
           (curve.dashed ? "' stroke-dasharray='5 4'" : "' stroke-width='2'");
}

std::string drawing(const Curve& curve, const Scale& nodes, const Scale& values) {
    std::string points;
    for (const auto& [count, value] : curve.points)
        if (nodes.shows(count) && values.shows(value))
            points += at(nodes(count)) + "," + at(values(value)) + " ";
    return "<polyline points='" + points + "' fill='none' " + strokeOf(curve) + "/>";
}

/// Draws the legend beside the curves, where nothing runs through it.
std::string legend(const std::vector<Curve>& curves) {
    const double left = kWidth - kRight + 14;
    std::string drawn;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const double y = kTop + 12 + 20 * double(i);
        drawn += "<line x1='" + at(left) + "' y1='" + at(y) + "' x2='" + at(left + 24) + "' y2='" + at(y) + "' " +
                 strokeOf(curves[i]) + "/>" + label(left + 30, y + 4, "start", curves[i].name);
    }
    return drawn;
}

}  // namespace

std::string svg(const Plot& plot) {
    const double bottom = kHeight - kBottom;
    const Scale nodes = decades(plot, true, kLeft, kWidth - kRight);
    const Scale values = plot.share ? Scale(0, 1, bottom, kTop, false) : decades(plot, false, bottom, kTop);
    const std::string size = " width='" + at(kWidth) + "' height='" + at(kHeight) + "'";
    std::string drawn = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " + at(kWidth) + " " + at(kHeight) + "'" +
                        size + " font-family='sans-serif' font-size='12'><rect" + size + " fill='#fff'/>" +
                        axes(plot, nodes, values);
    for (const Curve& curve : plot.curves)
        drawn += drawing(curve, nodes, values);
    return drawn + legend(plot.curves) + "</svg>\n";
}

}  // namespace pdr::bench::scale
