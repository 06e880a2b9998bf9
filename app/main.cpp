// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_window.h"
#include "app/command_line.h"
#include "app/display_check.h"
#include "app/language.h"
#include "app/main_window.h"
#include "app/named_opening.h"
#include "app/screenshot.h"
#include "app/settings_format.h"
#include "model/files/file_io.h"
#include "model/files/json_schema.h"
#include "tasks/reading/lab_archive.h"
#include "views/formula_setting.h"
#include "views/report_printer.h"
#include "views/shortcut_guard.h"

#include <QApplication>
#include <QEventLoop>
#include <QIcon>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTextDocumentFragment>
#include <QTextStream>

#include <csignal>
#include <cstdio>
#include <memory>

namespace {

using namespace cradle;

constexpr int badUsage = 2;
constexpr qint64 mostFormulaBytes = 16 * 1024 * 1024;

int complain(const QString &message)
{
    QTextStream(stderr) << message << Qt::endl;
    return badUsage;
}

void nameApplication()
{
    QApplication::setOrganizationName(QStringLiteral("Cradle"));
    QApplication::setApplicationName(QStringLiteral("cradle"));
    QApplication::setApplicationDisplayName(QStringLiteral("Cradle"));
    QApplication::setApplicationVersion(QStringLiteral(CRADLE_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("cradle"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/desktop/cradle.svg")));
}

/// How the window looks, and how steps are worked on: as asked, else as last time.
struct Manner {
    ThemeChoice theme = ThemeChoice::System;
    int textSize = 100; ///< %
    Mode mode = Mode::Code;
};

/// Speaks the language at once, so that what is wrong is said in it.
Result<Manner> takeManner(const CommandLine &request, const QSettings &settings)
{
    if (request.language && !languages().contains(*request.language))
        return Error{
            .message =
                QCoreApplication::translate("Main", "cradle: --language %1: one of %2 is right")
                    .arg(*request.language, languages().join(QStringLiteral(", ")))};
    setLanguage(request.language.value_or(settings.value(QStringLiteral("language")).toString()));
    const auto theme =
        request.theme
            ? themeFrom(*request.theme)
            : static_cast<ThemeChoice>(settings.value(QStringLiteral("theme"), 0).toInt());
    if (!theme)
        return Error{.message = QCoreApplication::translate(
                                    "Main", "cradle: --theme %1: system, light, dark or "
                                            "high-contrast is right")
                                    .arg(*request.theme)};
    const auto mode = request.mode
                          ? modeFrom(*request.mode)
                          : static_cast<Mode>(settings.value(QStringLiteral("mode"), 1).toInt());
    if (!mode)
        return Error{.message = QCoreApplication::translate(
                                    "Main", "cradle: --mode %1: explore or code is right")
                                    .arg(*request.mode)};
    bool isNumber = true;
    const int textSize = request.textSize ? request.textSize->toInt(&isNumber)
                                          : settings.value(QStringLiteral("textSize"), 100).toInt();
    if (!isNumber || (request.textSize && (textSize < 100 || textSize > 200)))
        return Error{.message = QCoreApplication::translate(
                                    "Main", "cradle: --text-size %1: a number from 100 to 200 "
                                            "is right")
                                    .arg(*request.textSize)};
    return Manner{.theme = *theme, .textSize = textSize, .mode = *mode};
}

/// Prints the report that lies in \p folder as report.pdf there.
int printReport(const QString &folder)
{
    const auto page = readPage(folder);
    if (!page)
        return complain(page.error().toString());
    const QString title =
        QTextDocumentFragment::fromHtml(page->html.section(QStringLiteral("<title>"), 1)
                                            .section(QStringLiteral("</title>"), 0, 0))
            .toPlainText();
    const auto error = writeFile(folder + QStringLiteral("/report.pdf"), printedPdf(*page, title));
    return error ? complain(error->toString()) : 0;
}

/// Sets the formulas that lie in \p folder as formulas.json; they become set.json there.
int setFormulas(const QString &folder)
{
    const auto asked = readFile(folder + QStringLiteral("/formulas.json"), mostFormulaBytes);
    if (!asked)
        return complain(asked.error().toString());
    FormulaSetting setting;
    QEventLoop loop;
    std::optional<SetFormulas> set;
    QObject::connect(&setting, &FormulaSetting::done, &loop, [&](const SetFormulas &formulas) {
        set = formulas;
        loop.quit();
    });
    setting.start(formulasFrom(*asked));
    if (!set)
        loop.exec();
    const auto error = writeFile(folder + QStringLiteral("/set.json"), textOf(*set));
    return error ? complain(error->toString()) : 0;
}

/// Opens all that is asked for. \return what is wrong with it
std::optional<Error> open(MainWindow &window, Workbench &bench, const CommandLine &request,
                          const QString &labs)
{
    if (auto error =
            openNamed(bench, request.named, request.author ? QString() : request.step, labs))
        return error;
    if (request.author) {
        if (auto error = openAuthor(window, *request.author, request.step, request.tab, labs))
            return error;
    }
    if (request.example) {
        if (auto error = openExampleNamed(bench, *request.example))
            return error;
    }
    return request.script ? bench.takeScript(*request.script) : std::nullopt;
}

} // namespace

int main(int argc, char **argv)
{
    if (needsNoDisplay(argc, argv) && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        // That platform warns of what it need not do.
        qputenv("QT_LOGGING_RULES", "default.warning=false");
    }
    if (const QString missing = missingDisplay(argc, argv); !missing.isEmpty())
        return complain(missing);

    // A file that may not grow is told by the write that fails, and in words.
    std::signal(SIGXFSZ, SIG_IGN);
    QApplication app(argc, argv);
    nameApplication();
    const Result<CommandLine> request = parseCommandLine(QApplication::arguments());
    if (!request)
        return complain(request.error().message);
    if (request->setFormulas)
        return setFormulas(*request->setFormulas);
    if (request->printReport) {
        if (request->language)
            setLanguage(*request->language);
        return printReport(*request->printReport);
    }
    QSettings settings(settingsFormat(), QSettings::UserScope, QApplication::organizationName(),
                       QApplication::applicationName());
    takeOlderSettings(settings, QSettings());
    const Result<Manner> manner = takeManner(*request, settings);
    if (!manner)
        return complain(manner.error().message);
    setTextScale(manner->textSize / 100.0);
    applyTheme(manner->theme);
    guardShortcuts();

    // A picture is of the step as it is shipped, and leaves no traces.
    const bool picture = request->screenshot.has_value();
    const QString progressFile =
        picture ? QString()
                : QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)
                      + QStringLiteral("/progress.json");
    // Where a picture's lab is unpacked; a window that is killed leaves none.
    const auto passing = picture ? std::make_unique<const QTemporaryDir>() : nullptr;
    Workbench bench(progressFile);
    bench.setMode(manner->mode);
    MainWindow window(bench, settings, manner->theme);
    if (const auto error =
            open(window, bench, *request, picture ? passing->path() : userLabsFolder()))
        return complain(QStringLiteral("cradle: ") + error->toString());
    if (picture && request->author)
        return takeScreenshot(*window.authors().newest(), *request->screenshot, request->at,
                              request->size);
    if (picture)
        return takeScreenshot(window, *request->screenshot, request->at, request->size);
    QWidget &first = request->author ? static_cast<QWidget &>(*window.authors().newest()) : window;
    first.show();
    return QApplication::exec();
}
