#include "ui/text/language.h"

#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

/// Qt's macro must stand outside of any namespace; without it the linker drops the resources of a static library.
static void keepTranslations() {
    Q_INIT_RESOURCE(translations);
}

namespace pdr::ui {
namespace {

/// A text has one translation wherever it stands: files know one context only. Texts of rooms without Qt have none.
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

/// Each in its own words, for those who cannot read the others.
QString languageName(const QString& code) {
    return code == "de" ? "Deutsch" : code == "es" ? QString::fromUtf8("Español") : "English";
}

QString languageFor(const QString& chosen) {
    if (languages().contains(chosen))
        return chosen;
    const QString system = QLocale::system().name().section('_', 0, 0);
    return languages().contains(system) ? system : languages().front();
}

/// Plurals are part of the texts, also in English.
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
