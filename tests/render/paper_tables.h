#pragma once
/// Tables 2 to 5 of Perez Monte et al., "Estimation of Volume Rendering Efficiency with GPU in a Parallel Distributed
/// Environment", as printed: frames per second and times of six resolutions, the largest first.

#include <array>
#include <cmath>
#include <string>

namespace pdr::test {

inline constexpr int kPaperSizes = 6;
inline constexpr std::array<double, kPaperSizes> kPaperPixels{1920 * 1080, 960 * 540, 480 * 270,
                                                              240 * 135,   120 * 67,  60 * 34};

/// A printed number: its value, and half a unit of its last digit.
struct Printed {
    double value, half;

    double low() const { return value - half; }
    double high() const { return value + half; }

    /// "0.1079" -> 0.1079 +- 0.00005
    static Printed of(const std::string& text) {
        const std::size_t point = text.find('.');
        const int decimals = point == std::string::npos ? 0 : int(text.size() - point - 1);
        return {std::stod(text), 0.5 * std::pow(10.0, -decimals)};
    }
};

using PrintedRow = std::array<const char*, kPaperSizes>;

struct PaperScenario {
    PrintedRow kroes, pd1, pd10, pd100;  ///< frames per second: tables 2 and 3
    PrintedRow iterationMs;              ///< T_p: table 4
    PrintedRow kroesOtherMs, pdOtherMs;  ///< T_t + T_c: table 5
};

inline constexpr PaperScenario kGtx560Ti{.kroes = {"7.8", "28.41", "80.3", "151.7", "197.0", "228"},
                                         .pd1 = {"9.8", "37.18", "118", "299.8", "474.3", "756.4"},
                                         .pd10 = {"1.060", "4.03", "15.08", "48.05", "106.7", "192.5"},
                                         .pd100 = {"0.1079", "0.4144", "1.53", "5.35", "12.7", "24.98"},
                                         .iterationMs = {"93.02", "24.13", "6.54", "1.87", "0.785", "0.400"},
                                         .kroesOtherMs = {"35.2", "9.48", "5.91", "4.72", "4.29", "3.98"},
                                         .pdOtherMs = {"9.02", "2.76", "1.93", "1.46", "1.32", "0.922"}};

inline constexpr PaperScenario kGts250{.kroes = {"1.233", "4.61", "16.6", "52.88", "134.9", "301.8"},
                                       .pd1 = {"1.516", "5.95", "21.23", "72.61", "211.0", "537.6"},
                                       .pd10 = {"0.1735", "0.69", "2.58", "9.16", "28.75", "68.93"},
                                       .pd100 = {"0.01735", "0.0702", "0.263", "0.945", "3.1", "7.36"},
                                       .iterationMs = {"576", "142", "38", "10.58", "3.22", "1.35"},
                                       .kroesOtherMs = {"235", "74.9", "22.24", "8.33", "4.19", "1.96"},
                                       .pdOtherMs = {"83.63", "26.06", "9.1", "3.19", "1.52", "0.510"}};

}  // namespace pdr::test
