// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/text.h"

#include "model/files/unit.h"
#include "tasks/authoring/json_patch.h"
#include "tasks/checks/check_kinds.h"
#include "tasks/judging/asked_laws.h"
#include "tasks/lab_files/lab_files.h"
#include "tasks/questions/question_json.h"
#include "tasks/reading/lab_reader.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

using namespace cradle;

/// What is on either side of what is allowed, in tables: units, paths, questions, parameters of
/// checks, patches of JSON and what checks ask for: tests/approved/edges.
class TestApprovedEdges : public QObject
{
    Q_OBJECT
private slots:
    void unitsAreAsApproved();
    void pathsAreAsApproved();
    void questionsAreAsApproved();
    void kindsAreAsApproved();
    void patchesAreAsApproved();
    void askedLawsAreAsApproved();
};

namespace {

void compare(const char *file, const QString &now)
{
    const QString difference =
        approved::compare(QStringLiteral("edges/") + QString::fromLatin1(file), now);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QJsonObject object(const QByteArray &json)
{
    return QJsonDocument::fromJson(json).object();
}

QString jsonText(const QJsonValue &value)
{
    return QString::fromUtf8(QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact))
        .chopped(1)
        .mid(1);
}

} // namespace

void TestApprovedEdges::unitsAreAsApproved()
{
    QString all;
    for (const char *prefix : {"", "k", "c", "m", "d", "M", "G", "h", "µ", "u", "n", "T", "kk"}) {
        for (const char *unit : {"m", "s", "g", "kg", "N", "J", "W", "Pa", "Hz", "rad", "t", "min",
                                 "h", "°", "%", "1", "x"}) {
            const QString name = text(prefix) + text(unit);
            const auto read = unitFrom(name);
            all += name + u' '
                   + (read ? QStringLiteral("%1 %2 %3 %4")
                                 .arg(QString::number(read->scale, 'g', 12))
                                 .arg(read->powers[0])
                                 .arg(read->powers[1])
                                 .arg(read->powers[2])
                           : text("–"))
                   + u'\n';
        }
    }
    for (const char *power : {"m^2",  "m^-2", "m²", "m⁻¹",  "m^0",   "m^9",      "m^10", "m^99",
                              "m^",   "m^x",  "m2", "s⁻²",  "m/s/s", "m / s^2",  "m·s",  "m*s",
                              "m  s", "/s",   "m/", "km/h", "(m)",   "m s^-1 kg"}) {
        const auto read = unitFrom(text(power));
        all += text(power)
               + (read ? QStringLiteral(" %1 %2 %3 %4\n")
                             .arg(QString::number(read->scale, 'g', 12))
                             .arg(read->powers[0])
                             .arg(read->powers[1])
                             .arg(read->powers[2])
                       : text(" –\n"));
    }
    compare("units.txt", all);
}

void TestApprovedEdges::pathsAreAsApproved()
{
    QString all;
    for (int depth = 1; depth <= limits::labDepth + 1; ++depth)
        all += QStringLiteral("%1 folders: %2\n")
                   .arg(depth)
                   .arg(faultOfLabPath(text("a/").repeated(depth - 1) + u'a'));
    for (int more = -1; more <= 1; ++more)
        all += QStringLiteral("%1 letters: %2\n")
                   .arg(limits::labPathName + more)
                   .arg(faultOfLabPath(QString(limits::labPathName + more, u'a')));
    for (const char *path :
         {"con", "con.lua", "a/aux", "lpt",   "nul ", "a ",   "a.",  "a?",     "a*b",
          "a\"", "<",       ">",     "|",     "a:b",  "a\\b", ".a",  "a/.b",   "",
          "/",   "a//b",    "a\tb",  "a\x7f", "ä",    "conx", "CON", "Prn.txt"})
        all += QStringLiteral("%1: %2\n").arg(text(path), faultOfLabPath(text(path)));
    compare("paths.txt", all);
}

void TestApprovedEdges::questionsAreAsApproved()
{
    QString all;
    QJsonArray list;
    for (
        const char *json :
        {R"({"id": "a", "kind": "number", "title": "A", "text": "", "right": 1})",
         R"({"id": "a", "kind": "number", "title": "twice", "text": "", "right": "2 m", "unit": "m"})",
         R"({"id": "b", "kind": "number", "title": "B", "text": "", "right": "2 kg", "unit": "m"})",
         R"({"id": "c", "kind": "number", "title": "C", "text": "", "unit": "furlong", "right": 1})",
         R"({"id": "d", "kind": "number", "title": "D", "text": ""})",
         R"({"id": "e", "kind": "number", "title": "E", "text": "", "right": 1, "tolerance": 0})",
         R"({"id": "f", "kind": "number", "title": "F", "text": "", "right": 1, "tolerance": -0.1})",
         R"({"id": "g", "kind": "number", "title": "G", "text": "", "right": 1, "tolerance": "1 s", "unit": "m"})",
         R"({"id": "h", "kind": "number", "title": "H", "text": "", "right": 1, "tolerance": "5 %"})",
         R"({"id": "i", "kind": "one", "title": "I", "text": "", "answers": ["x"], "right": 1})",
         R"({"id": "j", "kind": "one", "title": "J", "text": "", "answers": ["x", "y"], "right": 0})",
         R"({"id": "k", "kind": "one", "title": "K", "text": "", "answers": ["x", "y"], "right": 1})",
         R"({"id": "l", "kind": "one", "title": "L", "text": "", "answers": ["x", "y"], "right": 2})",
         R"({"id": "m", "kind": "one", "title": "M", "text": "", "answers": ["x", "y"], "right": 3})",
         R"({"id": "n", "kind": "one", "title": "N", "text": "", "answers": ["x", "y"], "right": [1, 2]})",
         R"({"id": "o", "kind": "one", "title": "O", "text": "", "answers": ["x", "y"]})",
         R"({"id": "p", "kind": "several", "title": "P", "text": "", "answers": ["x", "y", "z"], "right": [1, 3]})",
         R"({"id": "q", "kind": "several", "title": "Q", "text": "", "answers": ["x", "y", "z"], "right": []})",
         R"({"id": "r", "kind": "several", "title": "R", "text": "", "answers": ["x", "y", "z"], "right": [0, 4]})",
         R"({"id": "s", "kind": "order", "title": "S", "text": "", "answers": ["x", "y"]})",
         R"({"id": "t", "kind": "order", "title": "T", "text": "", "answers": ["x"]})",
         R"({"id": "u", "kind": "text", "title": "U", "text": "", "points": 2})",
         R"({"id": "start", "kind": "text", "title": "V", "text": ""})"}) {
        const QJsonObject each = object(json);
        list.append(each);
        const Question question = questionFrom(each);
        all += jsonText(each) + u'\n' + jsonText(jsonFrom(question)) + u'\n'
               + jsonText(textsOf(question)) + u'\n' + faultOf(question) + u'\n';
    }
    const QJsonObject task{{text("checks"), QJsonArray{object(R"({"id": "start"})")}},
                           {text("questions"), list}};
    for (const Error &fault : questionFaults(task))
        all += fault.pointer + text(": ") + fault.message + u'\n';
    const QJsonObject words = object(
        R"({"questions": {"k": {"title": "Q", "answers": ["1", "2"]}, "l": {"answers": ["1"]}}})");
    for (const Question &question : readQuestions(task, words))
        all += question.id + u' ' + question.title + u' ' + question.answers.join(u',') + u'\n';
    compare("questions.txt", all);
}

void TestApprovedEdges::kindsAreAsApproved()
{
    QString all;
    const auto number = [](const std::optional<double> &value) {
        return value ? QString::number(*value) : text("–");
    };
    for (const std::vector<KindInfo> &kinds : {checkKinds(), sceneKinds()}) {
        for (const KindInfo &kind : kinds) {
            all += QStringLiteral("== %1, from %2 circles: %3. %4\n")
                       .arg(kind.name)
                       .arg(kind.circles)
                       .arg(kind.title, kind.purpose);
            for (const ParameterInfo &each : kind.parameters)
                all +=
                    QStringLiteral("%1, type %2, %3 to %4 %5, else %6, %7%8: %9. %10\n")
                        .arg(each.name)
                        .arg(int(each.type))
                        .arg(number(each.least), number(each.most), each.unit,
                             jsonText(each.standard), each.choices.join(u'|'),
                             each.required ? text(" required") : QString(), each.label, each.help);
        }
    }
    compare("kinds.txt", all);
}

/// Every one of some objects becomes every other, in the layout in which it stands.
void TestApprovedEdges::patchesAreAsApproved()
{
    const QByteArray texts[] = {
        "{}",
        "{\"a\": 1}",
        "{\n  \"a\": 1.50,\n  \"b\": [1, 2, 3],\n  \"unknown\": null\n}\n",
        "{ \"b\" : [ 1,2 ,3 ], \"a\":1e0 }",
        "{\n    \"id\": \"S1\",\n    \"title\": \"T\",\n    \"checks\": [\n"
        "        {\"id\": \"x\", \"kind\": \"start\"},\n        {\"id\": \"y\"}\n    ]\n}\n",
        "{\"checks\": [{\"id\": \"y\", \"points\": 2}], \"title\": \"ä\\n\\\"\", \"hints\": "
        "[\"one\", \"two\"]}",
        "{\n\t\"scene\": {\"kind\": \"pair\", \"speed\": [0.1, 2e-7]},\n\t\"b\": [[1, 2], [3, "
        "4]]\n}",
        "{\"scene\": {\"kind\": \"shot\", \"other\": {\"deep\": true}}, \"a\": 0.1}",
        "{\"title\": \"\", \"hints\": [], \"scene\": {}, \"b\": [1, 2, 3, 4]}"};
    QString all;
    for (const QByteArray &before : texts) {
        for (const QByteArray &after : texts) {
            const QByteArray made = patchJson(before, object(before), object(after));
            QCOMPARE(object(made), object(after));
            all += QString::fromUtf8(made).trimmed() + text("\n--\n");
        }
    }
    // What is written knows more than the edit does.
    for (const QByteArray &known : texts)
        all += QString::fromUtf8(patchJson(texts[2], object(known), object(texts[4]))).trimmed()
               + text("\n--\n");
    compare("patches.txt", all);
}

/// What the checks of a step say of the right laws: all of them, each alone, and all but each.
void TestApprovedEdges::askedLawsAreAsApproved()
{
    const auto said = [](const Task &task) {
        const AskedLaws laws = askedLaws(task);
        QString integrators;
        for (const PresetCircle &circle : laws.scene.circles)
            integrators += QString::number(int(circle.integrator)) + u' ';
        return QStringLiteral("motion %1, walls %2, pair %3, g (%4, %5), laws %6 %7, by %8\n")
            .arg(laws.motion)
            .arg(laws.walls)
            .arg(laws.pair)
            .arg(laws.scene.gravity.x)
            .arg(laws.scene.gravity.y)
            .arg(int(laws.scene.laws.walls))
            .arg(int(laws.scene.laws.circles))
            .arg(integrators);
    };
    QString all;
    for (const char *folder : {shippedLab, bouncingBallLab}) {
        const auto lab = readLab(QLatin1String(folder));
        QVERIFY(lab.ok());
        for (const Task &task : lab->tasks) {
            all += QStringLiteral("%1: %2").arg(task.id, said(task));
            for (std::size_t i = 0; i < task.checks.size(); ++i) {
                Task other = task;
                other.checks = {task.checks[i]};
                all += QStringLiteral("  %1 alone: %2").arg(task.checks[i].id, said(other));
                other.checks = task.checks;
                other.checks.erase(other.checks.begin() + static_cast<std::ptrdiff_t>(i));
                all += QStringLiteral("  without %1: %2").arg(task.checks[i].id, said(other));
            }
        }
    }
    compare("asked.txt", all);
}

QTEST_GUILESS_MAIN(TestApprovedEdges)
#include "test_approved_edges.moc"
