// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_window.h"
#include "app/display_check.h"
#include "app/language.h"
#include "app/main_window.h"
#include "app/screenshot.h"
#include "tasks/authoring/lab_archive.h"
#include "tasks/lab_list.h"
#include "tasks/lab_reader.h"
#include "views/shortcut_guard.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QIcon>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTextStream>

#include <cstdio>
#include <string_view>

namespace {

using namespace cradle;

constexpr int badUsage = 2;

int complain(const QString &message)
{
    QTextStream(stderr) << message << Qt::endl;
    return badUsage;
}

/// A picture, help and version are had without a display.
bool needsNoDisplay(int argc, char **argv)
{
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument(argv[i]);
        for (const std::string_view name :
             {"--screenshot", "--help", "-h", "--help-all", "--version", "-v"}) {
            if (argument == name || argument.starts_with("--screenshot="))
                return true;
        }
    }
    return false;
}

/// Command line options; the names are those that --help shows.
struct Options {
    QCommandLineOption step{QStringLiteral("step"),
                            QCoreApplication::translate("Main", "open this step"),
                            QStringLiteral("L42T5")};
    QCommandLineOption language{
        QStringLiteral("language"),
        QCoreApplication::translate("Main", "speak this language: en or de"),
        QStringLiteral("CODE")};
    QCommandLineOption theme{QStringLiteral("theme"),
                             QCoreApplication::translate("Main", "system, light or dark"),
                             QStringLiteral("NAME")};
    QCommandLineOption example{
        QStringLiteral("example"),
        QCoreApplication::translate("Main", "open this scene of Lab → Example scenes"),
        QStringLiteral("NAME")};
    QCommandLineOption mode{
        QStringLiteral("mode"),
        QCoreApplication::translate("Main", "work on steps by this: explore or code"),
        QStringLiteral("NAME")};
    QCommandLineOption script{
        QStringLiteral("script"),
        QCoreApplication::translate("Main", "take this program as your own of the step"),
        QStringLiteral("F.lua")};
    QCommandLineOption author{QStringLiteral("author"),
                              QCoreApplication::translate(
                                  "Main", "open this lab in the window in which labs are written"),
                              QStringLiteral("LAB-DIR")};
    QCommandLineOption tab{QStringLiteral("tab"),
                           QCoreApplication::translate(
                               "Main", "of that window: scene, text, checks, programs or proof"),
                           QStringLiteral("NAME"), QStringLiteral("scene")};
    QCommandLineOption screenshot{
        QStringLiteral("screenshot"),
        QCoreApplication::translate("Main", "draw the window into this file and quit"),
        QStringLiteral("FILE.png")};
    QCommandLineOption at{
        QStringLiteral("at"),
        QCoreApplication::translate("Main", "of the scene's time, s, in the picture"),
        QStringLiteral("SECONDS"), QStringLiteral("0")};
    QCommandLineOption size{QStringLiteral("size"),
                            QCoreApplication::translate("Main", "of the window, pixels"),
                            QStringLiteral("1280x800")};
};

std::optional<ThemeChoice> themeFrom(const QString &name)
{
    if (name == QLatin1String("light"))
        return ThemeChoice::Light;
    if (name == QLatin1String("dark"))
        return ThemeChoice::Dark;
    return name == QLatin1String("system") ? std::optional(ThemeChoice::System) : std::nullopt;
}

std::optional<Mode> modeFrom(const QString &name)
{
    if (name == QLatin1String("explore"))
        return Mode::Explore;
    return name == QLatin1String("code") ? std::optional(Mode::Code) : std::nullopt;
}

/// What is wrong with the name of a step; asked before anything of the student's is touched.
std::optional<Error> missingStep(const QString &folder, const QString &step)
{
    if (step.isEmpty())
        return std::nullopt;
    const Result<Lab> lab = readLab(folder);
    if (!lab)
        return lab.error();
    if (lab->indexOf(step) >= 0)
        return std::nullopt;
    QStringList ids;
    for (const Task &task : lab->tasks)
        ids.append(task.id);
    return Error{.message = QCoreApplication::translate("Main", "there is no step %1; there are %2")
                                .arg(step, ids.join(QStringLiteral(", ")))};
}

/// Opens what the command line names: a lab, a scene, or with both a step and a scene that scene
/// as the student's work on the step. An archive is unpacked into \p labs first.
/// \return what is wrong with it
std::optional<Error> openNamed(Workbench &bench, const QString &named, const QString &step,
                               const QString &labs)
{
    QString path = named;
    if (isLabArchive(named)) {
        const Result<QString> folder = importLab(named, labs);
        if (!folder)
            return folder.error();
        path = *folder;
    }
    const bool isLab = path.isEmpty() || QFileInfo(path).isDir();
    const QString folder = isLab && !path.isEmpty() ? path : shippedLabWith(step);
    if (const auto error = missingStep(folder, step))
        return error;
    if (auto error = bench.openLab(folder, currentLanguage()))
        return error;
    if (!isLab && step.isEmpty())
        return bench.openPreset(path);
    if (step.isEmpty())
        return std::nullopt;
    bench.openTask(step);
    return isLab ? std::nullopt : bench.takePreset(path);
}

/// Opens the example called \p name. \return what is wrong with that
std::optional<Error> openExampleNamed(Workbench &bench, const QString &name)
{
    if (const auto example = exampleFromId(name))
        return bench.openExample(*example);
    QStringList ids;
    for (const Example each : allExamples)
        ids.append(idOf(each));
    return Error{.message =
                     QCoreApplication::translate("Main", "there is no example %1; there are %2")
                         .arg(name, ids.join(QStringLiteral(", ")))};
}

/// Opens the lab in \p folder to be written, at \p step if one is named, with the tab called
/// \p tab in front. \return what is wrong with that
std::optional<Error> openAuthor(MainWindow &window, const QString &folder, const QString &step,
                                const QString &tab)
{
    static const QStringList tabs{QStringLiteral("scene"), QStringLiteral("text"),
                                  QStringLiteral("checks"), QStringLiteral("programs"),
                                  QStringLiteral("proof")};
    if (!tabs.contains(tab))
        return Error{.message = QCoreApplication::translate(
                                    "Main", "--tab %1: scene, text, checks, programs or proof is "
                                            "right")
                                    .arg(tab)};
    if (auto error = window.openAuthor(folder))
        return error;
    AuthorDocument &document = window.author()->document();
    if (!step.isEmpty() && !document.steps().contains(step))
        return Error{.message =
                         QCoreApplication::translate("Main", "there is no step %1; there are %2")
                             .arg(step, document.steps().join(QStringLiteral(", ")))};
    if (!step.isEmpty())
        document.setStep(step);
    window.author()->showTab(static_cast<int>(tabs.indexOf(tab)));
    return std::nullopt;
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

    QApplication app(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("Cradle"));
    QApplication::setApplicationName(QStringLiteral("cradle"));
    QApplication::setApplicationDisplayName(QStringLiteral("Cradle"));
    QApplication::setApplicationVersion(QStringLiteral(CRADLE_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("cradle"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/desktop/cradle.svg")));
    QSettings settings;

    const Options options;
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QCoreApplication::translate("Main", "Learn how a physics engine works by writing one."));
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
    parser.addPositionalArgument(
        QStringLiteral("LAB-DIR, LAB.cradle or PRESET.json"),
        QCoreApplication::translate("Main", "the lab or the scene to open; without it Lab 4.2"));
    parser.addOptions({options.step, options.example, options.language, options.theme, options.mode,
                       options.script, options.author, options.tab, options.screenshot, options.at,
                       options.size});
    if (!parser.parse(QApplication::arguments()))
        return complain(QStringLiteral("cradle: ") + parser.errorText());
    if (parser.isSet(help))
        parser.showHelp();
    if (parser.isSet(version))
        parser.showVersion();
    if (parser.positionalArguments().size() > 1) {
        return complain(QCoreApplication::translate(
                            "Main", "cradle: unexpected argument %1; one lab or scene is right")
                            .arg(parser.positionalArguments().at(1)));
    }

    const QString language = parser.isSet(options.language)
                                 ? parser.value(options.language)
                                 : settings.value(QStringLiteral("language")).toString();
    if (parser.isSet(options.language) && !languages().contains(language))
        return complain(
            QCoreApplication::translate("Main", "cradle: --language %1: en or de is right")
                .arg(language));
    setLanguage(language);
    const auto theme =
        parser.isSet(options.theme)
            ? themeFrom(parser.value(options.theme))
            : static_cast<ThemeChoice>(settings.value(QStringLiteral("theme"), 0).toInt());
    if (!theme)
        return complain(QCoreApplication::translate(
                            "Main", "cradle: --theme %1: system, light or dark is right")
                            .arg(parser.value(options.theme)));
    const auto mode = parser.isSet(options.mode)
                          ? modeFrom(parser.value(options.mode))
                          : static_cast<Mode>(settings.value(QStringLiteral("mode"), 1).toInt());
    if (!mode)
        return complain(
            QCoreApplication::translate("Main", "cradle: --mode %1: explore or code is right")
                .arg(parser.value(options.mode)));
    applyTheme(*theme);
    guardShortcuts();

    const bool picture = parser.isSet(options.screenshot);
    // A picture is of the step as it is shipped, and leaves no traces.
    const QString progressFile =
        picture ? QString()
                : QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)
                      + QStringLiteral("/progress.json");
    const QTemporaryDir passing; // where a picture's lab is unpacked
    Workbench bench(progressFile);
    bench.setMode(*mode);
    MainWindow window(bench, settings, *theme);
    const bool author = parser.isSet(options.author);
    if (const auto error = openNamed(bench, parser.positionalArguments().value(0),
                                     author ? QString() : parser.value(options.step),
                                     picture ? passing.path() : userLabsFolder()))
        return complain(QStringLiteral("cradle: ") + error->toString());
    if (author) {
        if (const auto error = openAuthor(window, parser.value(options.author),
                                          parser.value(options.step), parser.value(options.tab)))
            return complain(QStringLiteral("cradle: ") + error->toString());
    }
    if (parser.isSet(options.example)) {
        if (const auto error = openExampleNamed(bench, parser.value(options.example)))
            return complain(QStringLiteral("cradle: ") + error->toString());
    }
    if (parser.isSet(options.script)) {
        if (const auto error = bench.takeScript(parser.value(options.script)))
            return complain(QStringLiteral("cradle: ") + error->toString());
    }
    if (picture && author)
        return takeScreenshot(*window.author(), parser.value(options.screenshot),
                              parser.value(options.at), parser.value(options.size));
    if (picture)
        return takeScreenshot(window, parser.value(options.screenshot), parser.value(options.at),
                              parser.value(options.size));
    QWidget &first = author ? static_cast<QWidget &>(*window.author()) : window;
    first.show();
    return QApplication::exec();
}
