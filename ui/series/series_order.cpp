#include "ui/series/series_order.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "render/volume/sheared.h"

namespace pdr::ui {
namespace {

using Person = std::tuple<std::string, std::string, std::string>;

Person personOf(const dicom::Series& series) {
    return {series.patient.name, series.patient.id, series.patient.birthDate};
}

const std::string& dateOf(const dicom::Series& series) {
    return series.study.date.empty() ? series.series.date : series.study.date;
}

/// Returns whether nothing speaks against HU: a perfusion map is CT, too, but shows a flow.
bool isCt(const dicom::Series& series) {
    return (series.series.modality.empty() || series.series.modality == "CT") && series.unit.isHu;
}

/// Returns the place of a series among those of its study; the lowest comes first.
auto rankOf(const dicom::Series& series) {
    enum { axialCt, otherVolume, resampled, refused, noVolume } kind = refused;
    long distance = 0;  // [0.01 mm], so that rounding in the files does not matter
    if (series.verdict.loadable()) {
        kind = series.series.resampled ? resampled : isCt(series) && isAxial(series.geometry) ? axialCt : otherVolume;
        distance = std::lround(sliceDrift(series.geometry).gapMm * 100);
    } else if (series.verdict.stack == dicom::Stack::notCt) {
        kind = noVolume;
    }
    return std::tuple(kind, distance, -std::ptrdiff_t(series.slices.size()), series.series.number, series.series.part);
}

}  // namespace

bool isAxial(const VolumeGeometry& geometry) {
    const dmat4& map = geometry.patientFromIndex;
    const dvec3 normal = glm::abs(glm::cross(dvec3(map[0]), dvec3(map[1])));
    return normal.z > normal.x && normal.z > normal.y;
}

std::vector<ListedStudy> listedStudies(const dicom::ScanResult& scan) {
    // Sort the series into studies, and note whose can be loaded
    std::map<std::pair<Person, std::string>, ListedStudy> byStudy;
    std::map<Person, bool> nothingOf;
    for (int i = 0; i < int(scan.series.size()); ++i) {
        const dicom::Series& series = scan.series[std::size_t(i)];
        const Person person = personOf(series);
        byStudy[{person, series.study.uid}].series.push_back(i);
        nothingOf.try_emplace(person, true).first->second &= !series.verdict.loadable();
    }
    // Sort the series of each study, then the studies by their first series
    const auto at = [&](int i) -> const dicom::Series& { return scan.series[std::size_t(i)]; };
    std::vector<ListedStudy> studies;
    for (auto& [key, study] : byStudy) {
        std::ranges::stable_sort(study.series, [&](int a, int b) { return rankOf(at(a)) < rankOf(at(b)); });
        studies.push_back(std::move(study));
    }
    const auto first = [&](const ListedStudy& study) -> const dicom::Series& { return at(study.series.front()); };
    std::ranges::stable_sort(studies, [&](const ListedStudy& left, const ListedStudy& right) {
        const dicom::Series &a = first(left), &b = first(right);
        const Person ours = personOf(a), theirs = personOf(b);
        if (ours != theirs)
            return std::tuple(nothingOf[ours], ours) < std::tuple(nothingOf[theirs], theirs);
        return std::tuple(!a.verdict.loadable(), dateOf(b)) < std::tuple(!b.verdict.loadable(), dateOf(a));
    });
    // Number the patients
    for (std::size_t i = 1; i < studies.size(); ++i)
        studies[i].patient =
            studies[i - 1].patient + (personOf(first(studies[i - 1])) == personOf(first(studies[i])) ? 0 : 1);
    return studies;
}

}  // namespace pdr::ui
