// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include <QCommandLineParser>
#include <QCoreApplication>

#include <string_view>

namespace cradle {

namespace {

/// An option of which only our own programs know.
QCommandLineOption hidden(const QString &name)
{
    QCommandLineOption option(name, {}, QStringLiteral("FOLDER"));
    option.setFlags(QCommandLineOption::HiddenFromHelp);
    return option;
}

/// Command line options; the names are those that --help shows.
struct Options {
    QCommandLineOption step{QStringLiteral("step"),
                            QCoreApplication::translate("Main", "open this step"),
                            QStringLiteral("L42T5")};
    QCommandLineOption language{
        QStringLiteral("language"),
        QCoreApplication::translate("Main", "speak this language, such as en or de"),
        QStringLiteral("CODE")};
    QCommandLineOption theme{
        QStringLiteral("theme"),
        QCoreApplication::translate("Main", "system, light, dark or high-contrast"),
        QStringLiteral("NAME")};
    QCommandLineOption textSize{QStringLiteral("text-size"),
                                QCoreApplication::translate("Main", "of texts, %: 100 to 200"),
                                QStringLiteral("PERCENT")};
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
    QCommandLineOption printReport = hidden(QStringLiteral("print-report"));
    QCommandLineOption setFormulas = hidden(QStringLiteral("set-formulas"));
    QCommandLineOption at{
        QStringLiteral("at"),
        QCoreApplication::translate("Main", "of the scene's time, s, in the picture"),
        QStringLiteral("SECONDS"), QStringLiteral("0")};
    QCommandLineOption size{QStringLiteral("size"),
                            QCoreApplication::translate("Main", "of the window, pixels"),
                            QStringLiteral("1280x800")};
};

} // namespace

std::optional<ThemeChoice> themeFrom(const QString &name)
{
    if (name == QLatin1String("light"))
        return ThemeChoice::Light;
    if (name == QLatin1String("dark"))
        return ThemeChoice::Dark;
    if (name == QLatin1String("high-contrast"))
        return ThemeChoice::HighContrast;
    return name == QLatin1String("system") ? std::optional(ThemeChoice::System) : std::nullopt;
}

bool needsNoDisplay(int argc, char **argv)
{
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument(argv[i]);
        for (const std::string_view name : {"--screenshot", "--print-report", "--set-formulas",
                                            "--help", "-h", "--help-all", "--version", "-v"}) {
            if (argument == name || argument.starts_with("--screenshot="))
                return true;
        }
    }
    return false;
}

Result<CommandLine> parseCommandLine(const QStringList &arguments)
{
    const Options options;
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QCoreApplication::translate("Main", "Learn how a physics engine works by writing one."));
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
    parser.addPositionalArgument(
        QStringLiteral("LAB-DIR, LAB.cradle or PRESET.json"),
        QCoreApplication::translate("Main", "the lab or the scene to open; without it Lab 4.2"));
    parser.addOptions({options.step, options.example, options.language, options.theme,
                       options.textSize, options.mode, options.script, options.author, options.tab,
                       options.screenshot, options.at, options.size, options.printReport,
                       options.setFormulas});
    if (!parser.parse(arguments))
        return Error{.message = QStringLiteral("cradle: ") + parser.errorText()};
    if (parser.isSet(help))
        parser.showHelp();
    if (parser.isSet(version))
        parser.showVersion();
    const QStringList named = parser.positionalArguments();
    if (named.size() > 1)
        return Error{.message =
                         QCoreApplication::translate(
                             "Main", "cradle: unexpected argument %1; one lab or scene is right")
                             .arg(named.at(1))};
    const auto value = [&parser](const QCommandLineOption &option) {
        return parser.isSet(option) ? std::optional(parser.value(option)) : std::nullopt;
    };
    return CommandLine{.named = named.value(0),
                       .step = parser.value(options.step),
                       .example = value(options.example),
                       .language = value(options.language),
                       .theme = value(options.theme),
                       .textSize = value(options.textSize),
                       .mode = value(options.mode),
                       .script = value(options.script),
                       .author = value(options.author),
                       .tab = parser.value(options.tab),
                       .screenshot = value(options.screenshot),
                       .at = parser.value(options.at),
                       .size = parser.value(options.size),
                       .printReport = value(options.printReport),
                       .setFormulas = value(options.setFormulas)};
}

} // namespace cradle
