// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_files/lab_files.h"

#include "model/files/json_schema.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include <array>

namespace cradle {

namespace {

struct LabFilesText {
    Q_DECLARE_TR_FUNCTIONS(LabFiles)
};

/// Goes through a lab's folder, which may be any folder of the disk, and takes its files.
class FolderReader
{
public:
    FolderReader(const QString &folder, std::vector<Error> *findings)
        : m_folder(folder)
        , m_root(QFileInfo(folder).canonicalFilePath() + QLatin1Char('/'))
        , m_findings(findings)
    {
    }

    LabFiles read()
    {
        readFolder({}, 1);
        return m_files;
    }

private:
    void find(const QString &path, const QString &message)
    {
        if (m_findings)
            m_findings->push_back({.message = message, .file = m_folder + QLatin1Char('/') + path});
    }

    void readFolder(const QString &below, int depth)
    {
        // Special files and links to nowhere are "system" files; hidden ones are not asked for.
        // Files come first, so that no folder full of others keeps lab.json away.
        const QFileInfoList entries =
            QDir(m_folder + QLatin1Char('/') + below)
                .entryInfoList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot,
                               QDir::Name | QDir::DirsLast);
        for (const QFileInfo &entry : entries) {
            if (++m_seen > limits::labFiles) {
                if (m_seen == limits::labFiles + 1)
                    find(below + entry.fileName(), tooMuchText());
                return;
            }
            if (!entry.fileName().endsWith(QLatin1Char('~')))
                readEntry(entry, below + entry.fileName(), depth);
        }
    }

    void readEntry(const QFileInfo &entry, const QString &path, int depth)
    {
        if (const QString fault = faultOfLabPath(path); !fault.isEmpty())
            return find(path, fault);
        if (entry.isSymLink() && !isLinkWithin(entry))
            return find(path, LabFilesText::tr("this is a link that leads to no file of the lab; "
                                               "a file of its own is right"));
        if (entry.isDir()) {
            if (hasSuffixOfAFile(path))
                return find(path, LabFilesText::tr("this is a folder; a file is right"));
            if (depth == limits::labDepth)
                return find(path, LabFilesText::tr("folders are nested too deeply; at most %1 "
                                                   "are right")
                                      .arg(limits::labDepth - 1));
            return readFolder(path + QLatin1Char('/'), depth + 1);
        }
        if (!entry.isFile())
            return find(path, LabFilesText::tr("this is neither a file nor a folder"));
        readFile(entry, path);
    }

    void readFile(const QFileInfo &entry, const QString &path)
    {
        if (entry.size() > limits::labFileBytes)
            return find(path, LabFilesText::tr("the file is too large; at most %1 are right")
                                  .arg(QLocale::c().formattedDataSize(limits::labFileBytes)));
        if (m_bytes + entry.size() > limits::labBytes)
            return find(path, tooMuchText());
        Result<QByteArray> content = cradle::readFile(entry.filePath(), limits::labFileBytes);
        if (!content)
            return find(path, content.error().message);
        if (const QString fault = faultOfPicture(*content); !fault.isEmpty())
            find(path, fault);
        m_bytes += content->size();
        m_files.contents.insert(path, std::move(*content));
    }

    static QString tooMuchText()
    {
        return LabFilesText::tr("the lab is too large from here on; at most %1 files and %2 are "
                                "right")
            .arg(limits::labFiles)
            .arg(QLocale::c().formattedDataSize(limits::labBytes));
    }

    /// Links to folders are refused: they may go round in circles.
    [[nodiscard]] bool isLinkWithin(const QFileInfo &entry) const
    {
        return entry.isFile() && entry.canonicalFilePath().startsWith(m_root);
    }

    static bool hasSuffixOfAFile(const QString &path)
    {
        return path.endsWith(QLatin1String(".json")) || path.endsWith(QLatin1String(".md"))
               || path.endsWith(QLatin1String(".lua"));
    }

    QString m_folder;
    QString m_root; ///< the folder without links, with a slash
    std::vector<Error> *m_findings;
    LabFiles m_files{};
    qint64 m_bytes = 0;
    int m_seen = 0; ///< files and folders, of the lab or not
};

} // namespace

QString faultOfLabPath(const QString &path)
{
    static constexpr std::array reserved{"con", "prn", "aux", "nul"};
    const QStringList names = path.split(QLatin1Char('/'));
    if (names.size() > limits::labDepth)
        return LabFilesText::tr("folders are nested too deeply; at most %1 are right")
            .arg(limits::labDepth - 1);
    for (const QString &name : names) {
        if (name.isEmpty() || name.startsWith(QLatin1Char('.')))
            return LabFilesText::tr("a path that stays in the lab is right, of names that do not "
                                    "begin with a dot");
        if (name.size() > limits::labPathName)
            return LabFilesText::tr("the name is too long; at most %1 characters are right")
                .arg(limits::labPathName);
        for (const QChar character : name) {
            if (!character.isPrint() || QStringLiteral("\\:*?\"<>|").contains(character))
                return LabFilesText::tr("a name without \\ : * ? \" < > | and without control "
                                        "characters is right");
        }
        const QString base = name.section(QLatin1Char('.'), 0, 0).toLower();
        for (const char *word : reserved) {
            if (base == QLatin1String(word))
                return LabFilesText::tr("%1 names a device on some systems; another name is right")
                    .arg(name);
        }
        if (name.endsWith(QLatin1Char(' ')) || name.endsWith(QLatin1Char('.')))
            return LabFilesText::tr("a name that ends with a letter or a digit is right");
    }
    return {};
}

Result<LabFiles> readLabFiles(const QString &folder, std::vector<Error> *findings)
{
    const QFileInfo info(folder);
    if (!info.isDir())
        return Error{.message = LabFilesText::tr("cannot be read: there is no such folder"),
                     .file = folder};
    if (!info.isReadable() || !info.isExecutable()) {
        // A folder among the resources is never executable, and yet it can be read.
        if (!folder.startsWith(QLatin1Char(':')))
            return Error{.message = LabFilesText::tr("cannot be read: the folder may not be "
                                                     "opened"),
                         .file = folder};
    }
    return FolderReader(folder, findings).read();
}

} // namespace cradle
