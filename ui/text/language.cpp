#include "ui/text/language.h"

#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

/// Keeps the linker from dropping the translation resources of this static library. Qt's macro must stand outside of
/// any namespace.
static void keepTranslations() {
    Q_INIT_RESOURCE(translations);
}

namespace pdr::ui {
namespace {

/// A translator with a single context: a text has the same translation wherever it is used. Texts of folders that do
/// not use Qt have no context.
class Texts : public QTranslator {
  public:
    using QTranslator::QTranslator;

    QString translate(const char*, const char* text, const char*, int n) const override {
        return QTranslator::translate("PD-Render", text, nullptr, n);
    }
};

}  // namespace

const QStringList& languages() {
    static const QStringList codes{"en", "de", "es"};
    return codes;
}

/// Languages are named in their own language, for users who cannot read the others.
QString languageName(const QString& code) {
    return code == "de" ? "Deutsch" : code == "es" ? QString::fromUtf8("Español") : "English";
}

QString languageFor(const QString& chosen) {
    if (languages().contains(chosen))
        return chosen;
    const QString system = QLocale::system().name().section('_', 0, 0);
    return languages().contains(system) ? system : languages().front();
}

/// Loads the translations also for English, since plurals are part of them.
void speak(QCoreApplication& application, const QString& code) {
    for (QTranslator* before : application.findChildren<QTranslator*>(Qt::FindDirectChildrenOnly))
        delete before;
    QLocale locale(code);
    locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    QLocale::setDefault(locale);
    auto* ofQt = new QTranslator(&application);
    if (ofQt->load("qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(ofQt);
    keepTranslations();
    auto* texts = new Texts(&application);
    if (texts->load(":/translations/pdrender_" + code))
        QCoreApplication::installTranslator(texts);
}

QString number(double value, int decimals) {
    return QLocale().toString(value, 'f', decimals);
}

QString localNumber(const std::string& text) {
    return QString::fromStdString(text).replace('.', QLocale().decimalPoint());
}

}  // namespace pdr::ui
