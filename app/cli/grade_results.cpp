// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/grade_results.h"

#include <QDir>
#include <QSet>

namespace cradle::cli {

void removeOthers(const QString &results, Manifest &manifest, const QStringList &ids)
{
    const QSet<QString> wanted(ids.begin(), ids.end());
    const QStringList folders = QDir(results).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    std::erase_if(manifest.students, [&](const auto &each) {
        if (wanted.contains(each.first))
            return false;
        // Whatever was written of a student has the id for its name, as a folder or as a file.
        for (const QString &folder : folders) {
            const QString start =
                results + QLatin1Char('/') + folder + QLatin1Char('/') + each.first;
            for (const char *suffix : {".json", ".html", ".xml", ".tap"})
                QFile::remove(start + QLatin1String(suffix));
            QDir(start).removeRecursively();
        }
        return true;
    });
}

std::optional<Error> writeResults(const GradeRequest &request, const Lab &lab,
                                  const Manifest &manifest, GradeProgress &progress)
{
    const ClassFacts facts{.className = manifest.className,
                           .isolation = manifest.isolation,
                           .program = manifest.version.cradle,
                           .late = request.late,
                           .missing = manifest.missing,
                           .remarks = manifest.remarks,
                           .language = manifest.version.language};
    return writeClassResults(request.results, lab, facts,
                             [&progress](int done, int total) { progress.writing(done, total); });
}

ExitCode verdictOn(const Manifest &manifest, const GradeRequest &request)
{
    bool graded = true;
    bool passed = true;
    for (const auto &[id, student] : manifest.students) {
        graded = graded && student.notGraded == 0;
        passed = passed && student.notPassed == 0;
    }
    return graded && (passed || request.exitZero) ? Done : NotPassed;
}

} // namespace cradle::cli
