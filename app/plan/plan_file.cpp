#include "app/plan/plan_file.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "app/plan/plan_fields.h"
#include "render/base/plain_file.h"
#include "render/base/replacing_file.h"
#include "render/scene/field_check.h"
#include "render/scene/field_reader.h"
#include "render/scene/field_writer.h"

namespace pdr::app {
namespace {

constexpr std::string_view kFormat = "pdrender-plan";
constexpr std::uint64_t kMostBytes = 16 << 20;
constexpr std::size_t kMostSlices = 16384;  // as many as a scan may have
constexpr std::size_t kMostSliceDigits = 16 * kMostSlices;

/// Returns whether a symmetric matrix can be a covariance: no direction has a negative variance. Decomposes it
/// (Cholesky with pivots), since its determinant is nothing but rounding where one direction is much less sure than the
/// others. Rounding of 1e-6 of the largest variance is let pass: directions may come from numbers in float.
bool isCovariance(dmat3 m) {
    const double slack = 1e-6 * std::max({m[0][0], m[1][1], m[2][2]});
    for (int step = 0; step < 3; ++step) {
        const dvec3 variances(m[0][0], m[1][1], m[2][2]);
        const int pivot = int(std::max_element(&variances[0], &variances[0] + 3) - &variances[0]);
        if (variances[pivot] <= slack)
            break;
        const dvec3 column = m[pivot];
        m -= glm::outerProduct(column, column) / column[pivot];
    }
    const auto isZero = [slack](const dvec3& column) {
        return glm::all(glm::lessThanEqual(glm::abs(column), dvec3(slack)));
    };
    return isZero(m[0]) && isZero(m[1]) && isZero(m[2]);
}

Result<void> check(const measure::Place& place, const std::string& where) {
    for (const dmat3& share : place.spread.mm2)
        if (!isCovariance(share))
            return Error{phrase("is no covariance: some direction has a negative variance"), where, ""};
    return {};
}

Result<void> check(const Measurement& measurement, const std::string& where) {
    const std::size_t count = measurement.places.size(), least = placesOf(measurement.kind),
                      most = mostPlacesOf(measurement.kind);
    if (count < least || count > most)
        return Error{
            least == most ? phrase("must have %1 places", least) : phrase("must have %1 to %2 places", least, most),
            where + ".places", ""};
    if (measurement.name.size() > kLongestName)
        return Error{phrase("must not be longer than %1 bytes", kLongestName), where + ".name", ""};
    for (std::size_t i = 0; i < measurement.places.size(); ++i)
        if (auto ok = check(measurement.places[i], where + ".places[" + std::to_string(i) + "]"); !ok)
            return ok;
    return {};
}

Result<void> check(const std::vector<Measurement>& measurements) {
    if (measurements.size() > kMostMeasurements)
        return Error{phrase("has more than %1 measurements", kMostMeasurements), "measurements", ""};
    std::set<std::uint64_t> ids;
    for (std::size_t i = 0; i < measurements.size(); ++i) {
        const std::string where = "measurements[" + std::to_string(i) + "]";
        if (!ids.insert(measurements[i].id).second)
            return Error{phrase("is the id of two measurements"), where + ".id", ""};
        if (auto ok = check(measurements[i], where); !ok)
            return ok;
    }
    return {};
}

Result<void> check(const std::vector<Hole>& holes) {
    if (holes.size() > kMostSlices)
        return Error{phrase("has more than %1 holes", kMostSlices), "scan.holes", ""};
    for (std::size_t i = 0; i < holes.size(); ++i)
        if (std::abs(glm::length(holes[i].normal) - 1) > 1e-6)
            return Error{phrase("is no unit vector"), "scan.holes[" + std::to_string(i) + "].normal", ""};
    return {};
}

Result<void> check(const SavedPlan& saved) {
    if (auto ok = FieldCheck::check(saved.scan, "scan"); !ok)
        return ok;
    if (auto ok = check(saved.scan.holes); !ok)
        return ok;
    if (auto ok = FieldCheck::check(saved.plan); !ok)
        return ok;
    if (saved.scan.salt.size() > 64)
        return Error{phrase("must not be longer than %1 bytes", 64), "scan.salt", ""};
    if (saved.scan.sliceHashes.size() > kMostSliceDigits)
        return Error{phrase("must not be longer than %1 bytes", kMostSliceDigits), "scan.sliceHashes", ""};
    if (auto ok = pdr::check(saved.plan.image); !ok)
        return Error{ok.error().what, "image." + ok.error().where, ok.error().hint};
    if (saved.plan.partSources.labels.size() > 64)
        return Error{phrase("must not be longer than %1 bytes", 64), "parts.labels", ""};
    return check(saved.plan.measurements);
}

}  // namespace

Result<SavedPlan> planFromText(std::string_view text, std::string_view where) {
    SavedPlan saved;
    const auto read = [&](JsonFields& fields) {
        FieldReader reader(fields);
        reader.object({"scan", "the scan on which it was made", {}, kRequired}, saved.scan);
        describe(reader, saved.plan);
        if (auto ok = check(saved); !ok)
            throw FieldError{ok.error()};
    };
    if (auto ok = readJson(text, where, kFormat, read); !ok)
        return ok.error();
    return saved;
}

std::string planText(SavedPlan saved) {
    nlohmann::ordered_json fields = nlohmann::ordered_json::object();
    fields["scan"] = FieldWriter::written(saved.scan);
    fields.update(FieldWriter::written(saved.plan));
    return jsonText(kFormat, fields);
}

Result<SavedPlan> readPlan(const std::filesystem::path& file) {
    const auto text = readPlainFile(file, kMostBytes);
    if (!text)
        return text.error();
    return planFromText(*text, file.string());
}

Result<void> writePlan(const SavedPlan& saved, const std::filesystem::path& file) {
    return writeWhole(planText(saved), file, FileAccess::owner);
}

}  // namespace pdr::app
