#pragma once
/// The looks that a user has saved: a folder of files, one for each.

#include <QString>
#include <vector>

#include "render/base/result.h"
#include "render/scene/named_look.h"

namespace pdr::app {

class OwnLooks {
  public:
    /// `folder` is made when the first look is saved.
    explicit OwnLooks(QString folder) : folder_(std::move(folder)) {}
    /// Where the user's settings are.
    static QString usualFolder();

    struct Read {
        std::vector<NamedLook> looks;  ///< by name
        std::vector<Error> problems;   ///< one for each file that cannot be read
    };
    Read read() const;
    /// Takes the place of one of the same name. Errors: no name, too long a name, the folder cannot be written.
    Result<void> save(NamedLook look);
    Result<void> rename(const std::string& from, const std::string& to);
    Result<void> remove(const std::string& name);

  private:
    QString fileOf(const std::string& name) const;

    QString folder_;
};

}  // namespace pdr::app
