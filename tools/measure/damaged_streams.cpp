/// Damages compressed CT slices and says what the import sees of it.
///   damaged_streams [--keep FOLDER]
/// Zero runs of 16 to 512 bytes, one flipped bit, eight flipped bits; in the files of shared/data/ct/transfer_syntaxes
/// where they are there, else in slices that the toolkit encodes. --keep leaves every damaged file in FOLDER with a
/// list of them, for damaged_streams_gdcm.py to try the same on GDCM.

#include "tests/support/dicom/damaged_streams.h"

#include <cstdio>
#include <map>

#include "tests/support/dicom/shared_data.h"

using namespace pdr;
using test::Outcome;

namespace fs = std::filesystem;

namespace {

constexpr int kTrials = 64;
constexpr std::size_t kRuns[] = {16, 64, 512};

struct Source {
    std::string name;
    fs::path file;
};

std::vector<Source> sources(const fs::path& scratch) {
    std::vector<Source> found;
    const fs::path real = test::sharedCt() / "transfer_syntaxes";
    if (fs::is_directory(real)) {
        for (const auto& entry : fs::directory_iterator(real))
            found.push_back({entry.path().filename().string(), entry.path() / "CTImage.dcm"});
        std::sort(found.begin(), found.end(), [](const Source& a, const Source& b) { return a.name < b.name; });
        return found;
    }
    std::puts("The real CT slices are not there: slices that the toolkit encodes stand in.");
    for (const E_TransferSyntax coding :
         {EXS_RLELossless, EXS_JPEGProcess2_4, EXS_JPEGProcess6_8, EXS_JPEGProcess10_12, EXS_JPEGProcess14,
          EXS_JPEGProcess14SV1, EXS_JPEGLSLossless, EXS_JPEGLSLossy}) {
        const std::string name = std::to_string(int(coding));
        if (test::writeCompressedSlice(scratch / name, test::tissueSlice({512, 512}, 1), coding))
            found.push_back({name, scratch / name});
    }
    return found;
}

struct Count {
    int refused = 0, unchanged = 0, silent = 0;
    void add(Outcome outcome) {
        ++(outcome == Outcome::refused ? refused : outcome == Outcome::unchanged ? unchanged : silent);
    }
};

std::string damagedBy(const std::string& kind, const std::string& whole, int trial, std::mt19937& random) {
    const test::StreamRange range = test::streamRange(whole);
    if (kind == "zero run")
        return test::withZeroRun(whole, range, kRuns[trial % 3], random);
    return test::withBitFlips(whole, range, kind == "one bit" ? 1 : 8, random);
}

}  // namespace

int main(int argc, char** argv) {
    const bool keep = argc == 3 && std::string(argv[1]) == "--keep";
    const fs::path scratch = keep ? fs::path(argv[2]) : fs::temp_directory_path() / "damaged_streams";
    fs::create_directories(scratch);
    std::ofstream list(scratch / "list.txt");
    std::map<std::string, Count> totals;
    std::printf("%-22s %-9s %8s %10s %7s\n", "coding", "damage", "refused", "unchanged", "silent");
    for (const Source& source : sources(scratch)) {
        const std::string whole = test::bytesOf(source.file);
        const auto sound = dicom::decodeSlice({source.file}, dicom::Padding::keep);
        if (!sound || test::streamRange(whole).last == 0)
            continue;  // not compressed, or in a coding that is refused as a whole
        std::mt19937 random(2026);
        for (const std::string kind : {"zero run", "one bit", "8 bits"}) {
            Count count;
            for (int trial = 0; trial < kTrials; ++trial) {
                const std::string name =
                    keep ? source.name + "-" + kind.substr(0, kind.find(' ')) + "-" + std::to_string(trial) : "damaged";
                test::writeBytes(scratch / name, damagedBy(kind, whole, trial, random));
                const Outcome outcome = test::outcomeOf(scratch / name, sound->hu);
                count.add(outcome);
                totals[kind].add(outcome);
                list << source.name << '\t' << kind << '\t' << name << '\t' << source.file.string() << '\n';
            }
            std::printf("%-22s %-9s %8d %10d %7d\n", source.name.c_str(), kind.c_str(), count.refused, count.unchanged,
                        count.silent);
            std::fflush(stdout);
        }
    }
    for (const auto& [kind, count] : totals)
        std::printf("%-22s %-9s %8d %10d %7d\n", "all", kind.c_str(), count.refused, count.unchanged, count.silent);
    if (!keep)
        fs::remove_all(scratch);
    return totals["zero run"].silent == 0 ? 0 : 1;
}
