// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/text.h"

#include "model/files/unit.h"
#include "tasks/authoring/json_patch.h"
#include "tasks/checks/check_kinds.h"
#include "tasks/lab_files/lab_files.h"
#include "tasks/questions/question_json.h"
#include "tasks/workspace/kept_history.h"

#include <QCryptographicHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>
#include <QtEndian>

using namespace cradle;

/// What is on either side of what is allowed, in tables: units, paths, questions, parameters of
/// checks, patches of JSON, histories of strangers: tests/approved/edges.
class TestApprovedEdges : public QObject
{
    Q_OBJECT
private slots:
    void unitsAreAsApproved();
    void pathsAreAsApproved();
    void questionsAreAsApproved();
    void kindsAreAsApproved();
    void patchesAreAsApproved();
    void historiesAreAsApproved();
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

/// A repository as git writes it, but without compression, so that every zlib makes these bytes.
class Repository
{
public:
    QByteArray add(const QByteArray &kind, const QByteArray &content)
    {
        const QByteArray whole = kind + ' ' + QByteArray::number(content.size()) + '\0' + content;
        const QByteArray id = QCryptographicHash::hash(whole, QCryptographicHash::Sha1);
        const QString hex = QString::fromLatin1(id.toHex());
        files[QStringLiteral("objects/%1/%2").arg(hex.left(2), hex.mid(2))] = stored(whole);
        return id;
    }
    QByteArray tree(const QList<std::pair<QByteArray, QByteArray>> &entries)
    {
        QByteArray content;
        for (const auto &[name, id] : entries)
            content += "100644 " + name + '\0' + id;
        return add("tree", content);
    }
    QByteArray commit(const QByteArray &tree, const QList<QByteArray> &parents,
                      const QByteArray &message, int time)
    {
        QByteArray content = "tree " + tree.toHex() + '\n';
        for (const QByteArray &parent : parents)
            content += "parent " + parent.toHex() + '\n';
        const QByteArray who = "Ada <a@b.c> " + QByteArray::number(time) + " +0200\n";
        return add("commit", content + "author " + who + "committer " + who + '\n' + message);
    }
    static QByteArray stored(const QByteArray &bytes) { return qCompress(bytes, 0).mid(4); }

    RepositoryFiles files{};
};

/// A commit as a pack has it: what a pack's delta makes of another, or whole.
struct Packed {
    int kind = 1;
    QByteArray head{}; ///< between size and content: where the base is
    QByteArray id{};
    QByteArray content{};
};

QByteArray sized(int kind, qsizetype size)
{
    QByteArray bytes;
    auto rest = size >> 4;
    bytes += static_cast<char>((rest > 0 ? 0x80 : 0) | kind << 4 | (size & 15));
    for (; rest > 0; rest >>= 7)
        bytes += static_cast<char>((rest > 127 ? 0x80 : 0) | (rest & 0x7f));
    return bytes;
}

/// Objects in this order, and an index of them.
RepositoryFiles packOf(const QList<Packed> &all)
{
    QByteArray pack = QByteArray("PACK\0\0\0\2\0\0\0", 11) + static_cast<char>(all.size());
    QMap<QByteArray, QByteArray> places; // by id
    for (const Packed &each : all) {
        char place[4];
        qToBigEndian(static_cast<quint32>(pack.size()), place);
        places[each.id] = QByteArray(place, 4);
        pack +=
            sized(each.kind, each.content.size()) + each.head + Repository::stored(each.content);
    }
    QByteArray counts(256 * 4, '\0');
    for (const QByteArray &id : places.keys()) {
        for (int first = static_cast<unsigned char>(id[0]); first < 256; ++first)
            counts[4 * first + 3] = static_cast<char>(counts[4 * first + 3] + 1);
    }
    const QByteArray index = QByteArray("\377tOc\0\0\0\2", 8) + counts
                             + QByteArrayList(places.keys()).join()
                             + QByteArray(4 * places.size(), '\0')
                             + QByteArrayList(places.values()).join() + QByteArray(40, '\0');
    return {{text("objects/pack/pack-1.idx"), index}, {text("objects/pack/pack-1.pack"), pack}};
}

QString told(const std::map<QString, std::vector<Version>> &history)
{
    QString all;
    for (const auto &[step, versions] : history) {
        for (const Version &version : versions)
            all += QStringLiteral("%1 %2 %3 %4 %5; ")
                       .arg(step, version.id.left(8))
                       .arg(version.when.toSecsSinceEpoch())
                       .arg(version.note.passed ? int(*version.note.passed) : -1)
                       .arg(version.note.findings.join(u','));
    }
    return all;
}

const QStringList steps{text("A"), text("B")};

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

void TestApprovedEdges::historiesAreAsApproved()
{
    Repository made;
    const QByteArray one = made.add("blob", "-- one\n");
    const QByteArray two = made.add("blob", "-- two\n");
    const auto treeOf = [&](const QList<std::pair<QByteArray, QByteArray>> &programs) {
        return made.tree({{"cradle.json", one}, {"steps", made.tree(programs)}});
    };
    const QByteArray first = made.commit(treeOf({{"A.lua", one}}), {}, "begin", 1000);
    const QByteArray second =
        made.commit(treeOf({{"A.lua", two}, {"B.lua", one}}), {first}, "go on", 2000);
    const QByteArray side = made.commit(treeOf({{"B.lua", two}}), {first}, "aside", 2500);
    const QByteArray last =
        made.commit(treeOf({{"A.lua", one}, {"B.lua", two}}), {second, side}, "together", 3000);
    const QByteArray wrong = made.commit(
        treeOf({}), {}, "A: checked\n\nCradle-Reason: check\nCradle-Verdict: not passed\n", 1100);
    const QByteArray message =
        "A: checked\n\nCradle-Reason: check\nCradle-Verdict: passed\nCradle-Finding: x\n";
    const QByteArray right = made.commit(treeOf({}), {wrong}, message, 1200);
    made.files[text("HEAD")] = "ref: refs/heads/main\n";
    made.files[text("refs/heads/main")] = last.toHex() + '\n';
    made.files[text("packed-refs")] = "# pack-refs with: peeled\n" + right.toHex()
                                      + " refs/cradle/versions/A\n^" + first.toHex() + '\n';
    QString all = told(keptHistory(made.files, steps)) + u'\n';
    // The newest version out of a pack: whole, and as what a delta makes of the one before.
    const auto pathOf = [](const QByteArray &id) {
        const QString hex = QString::fromLatin1(id.toHex());
        return QStringLiteral("objects/%1/%2").arg(hex.left(2), hex.mid(2));
    };
    const auto contentOf = [&](const QByteArray &id) {
        const QByteArray whole = qUncompress(QByteArray("\0\1\0\0", 4) + made.files[pathOf(id)]);
        return whole.mid(whole.indexOf('\0') + 1);
    };
    const QByteArray base = contentOf(wrong);
    const QByteArray content = contentOf(right);
    const auto numbered = [](qsizetype size) {
        QByteArray bytes;
        for (; size > 127; size >>= 7)
            bytes += static_cast<char>(0x80 | (size & 0x7f));
        return bytes + static_cast<char>(size);
    };
    // Of the base its first 46 bytes, which is the tree; then all else as it is.
    QByteArray delta = numbered(base.size()) + numbered(content.size()) + QByteArray("\x90\x2e", 2);
    for (qsizetype at = 46; at < content.size(); at += 100) {
        const QByteArray part = content.mid(at, 100);
        delta += static_cast<char>(part.size()) + part;
    }
    const Packed whole{.kind = 1, .head = {}, .id = wrong, .content = base};
    const auto back = sized(1, base.size()).size() + Repository::stored(base).size();
    QVERIFY(back > 127 && back < 16'000); // two bytes
    const QByteArray offset =
        QByteArray(1, static_cast<char>(0x80 | ((back >> 7) - 1))) + static_cast<char>(back & 0x7f);
    const Packed delivered[] = {{.kind = 1, .head = {}, .id = right, .content = content},
                                {.kind = 7, .head = wrong, .id = right, .content = delta},
                                {.kind = 6, .head = offset, .id = right, .content = delta}};
    QList<RepositoryFiles> packs;
    for (const Packed &each : delivered)
        packs.append(packOf({whole, each}));
    // A delta upon itself goes on without end.
    packs.append(packOf({Packed{.kind = 7, .head = right, .id = right, .content = delta}}));
    for (const RepositoryFiles &pack : packs) {
        RepositoryFiles files = made.files;
        files.remove(pathOf(right));
        files.remove(pathOf(wrong));
        files.insert(pack);
        all += told(keptHistory(files, steps)) + u'\n';
        QCryptographicHash broken(QCryptographicHash::Sha256);
        for (auto it = files.cbegin(); it != files.cend(); ++it) {
            for (qsizetype at = 0; at < it->size(); at += 1 + it->size() / 300) {
                for (const int bits : {1, 0x80}) {
                    RepositoryFiles other = files;
                    other[it.key()][at] = static_cast<char>((*it)[at] ^ bits);
                    broken.addData(told(keptHistory(other, steps)).toUtf8());
                }
                RepositoryFiles cut = files;
                cut[it.key()] = it->left(at);
                broken.addData(told(keptHistory(cut, steps)).toUtf8());
            }
        }
        all += QString::fromLatin1(broken.result().toHex().left(32)) + u'\n';
    }
    compare("histories.txt", all);
}

QTEST_GUILESS_MAIN(TestApprovedEdges)
#include "test_approved_edges.moc"
