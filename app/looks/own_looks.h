#pragma once
/// The user's own looks: a folder with one file for each.

#include <QString>
#include <vector>

#include "render/base/result.h"
#include "render/scene/named_look.h"

namespace pdr::app {

class OwnLooks {
  public:
    /// `folder` is created when the first look is saved.
    explicit OwnLooks(QString folder) : folder_(std::move(folder)) {}
    /// Returns the folder of looks in the user's configuration.
    static QString usualFolder();

    struct Read {
        std::vector<NamedLook> looks;  ///< sorted by file name
        std::vector<Error> problems;   ///< one for each file that cannot be read
    };
    Read read() const;
    /// Saves a look, in place of one of the same name. Errors: an empty name, a name of more than 60 bytes, a folder or
    /// file that cannot be written.
    Result<void> save(NamedLook look);
    Result<void> rename(const std::string& from, const std::string& to);
    Result<void> remove(const std::string& name);

  private:
    QString fileOf(const std::string& name) const;

    QString folder_;
};

}  // namespace pdr::app
