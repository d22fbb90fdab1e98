#include "app/plan/recovery.h"

#include <algorithm>
#include <system_error>

namespace pdr::app {
namespace {

namespace fs = std::filesystem;

constexpr const char *kPlan = ".plan.json", *kLock = ".lock";

fs::path with(fs::path name, const char* ending) {
    return name += ending;
}

/// Makes `folder`, for its owner alone.
Result<void> makeFolder(const fs::path& folder) {
    std::error_code trouble;
    if (fs::is_directory(folder, trouble))
        return {};
    fs::create_directories(folder, trouble);
    if (!trouble)
        fs::permissions(folder, fs::perms::owner_all, trouble);
    if (trouble)
        return Error{phrase("the folder cannot be created (%1)", trouble.message()), folder.string(),
                     phrase("Create it by hand, or make the folder above it writable.")};
    return {};
}

/// Returns the plan files in `folder`, without their endings.
std::vector<fs::path> namesIn(const fs::path& folder) {
    std::vector<fs::path> names;
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
        const std::string file = entry->path().string();
        if (file.ends_with(kPlan))
            names.emplace_back(file.substr(0, file.size() - std::string_view(kPlan).size()));
    }
    return names;
}

}  // namespace

KeptPlan::KeptPlan(fs::path folder) : folder_(std::move(folder)), name_(folder_ / newSalt()) {}

KeptPlan::~KeptPlan() {
    discard();
}

Result<void> KeptPlan::begin() {
    if (lock_)
        return {};
    if (auto ok = makeFolder(folder_); !ok)
        return ok;
    if (auto lock = FileLock::of(with(name_, kLock)))
        lock_.emplace(std::move(*lock));
    return {};  // without a lock, another window may take the plan for lost; that is better than to keep none
}

Result<void> KeptPlan::keep(const Plan& plan, const std::shared_ptr<const Volume>& volume) {
    if (auto ok = begin(); !ok)
        return ok;
    if (marked_.lock() != volume) {
        mark_ = markOf(*volume, newSalt());
        marked_ = volume;
    }
    return writePlan({mark_, plan}, with(name_, kPlan));
}

void KeptPlan::discard() {
    std::error_code ignored;
    fs::remove(with(name_, kPlan), ignored);
    if (lock_)
        fs::remove(with(name_, kLock), ignored);
    lock_.reset();
}

LostPlans lostPlans(const fs::path& folder) {
    LostPlans lost;
    for (const fs::path& name : namesIn(folder)) {
        const std::optional<FileLock> ended = FileLock::of(with(name, kLock));
        if (!ended)
            continue;  // the run goes on
        const fs::path file = with(name, kPlan);
        std::error_code trouble;
        const auto written = std::chrono::file_clock::to_sys(fs::last_write_time(file, trouble));
        const auto keptAt = std::chrono::time_point_cast<std::chrono::system_clock::duration>(written);
        if (!trouble && std::chrono::system_clock::now() - keptAt > kLostPlansStay) {
            removeLost(file);
            continue;
        }
        if (auto saved = readPlan(file); saved)
            lost.plans.push_back({file, *std::move(saved), keptAt});
        else
            lost.problems.push_back(saved.error());
    }
    std::ranges::sort(lost.plans, std::ranges::greater(), &LostPlan::keptAt);
    return lost;
}

void removeLost(const fs::path& file) {
    std::error_code ignored;
    fs::remove(file, ignored);
    const std::string name = file.string();
    if (name.ends_with(kPlan))
        fs::remove(name.substr(0, name.size() - std::string_view(kPlan).size()) + kLock, ignored);
}

const LostPlan* lostPlanOf(const std::vector<LostPlan>& plans, const Volume& volume) {
    const auto found =
        std::ranges::find_if(plans, [&](const LostPlan& plan) { return bool(checkIsScanOf(plan.saved.scan, volume)); });
    return found == plans.end() ? nullptr : &*found;
}

}  // namespace pdr::app
