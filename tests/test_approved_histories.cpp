// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/text.h"

#include "tasks/workspace/kept_history.h"

#include <QCryptographicHash>
#include <QTest>
#include <QtEndian>

using namespace cradle;

/// What is read of the repositories of strangers, whole, broken and made to mislead:
/// tests/approved/edges.
class TestApprovedHistories : public QObject
{
    Q_OBJECT
private slots:
    void historiesAreAsApproved();
};

namespace {

void compare(const char *file, const QString &now)
{
    const QString difference =
        approved::compare(QStringLiteral("edges/") + QString::fromLatin1(file), now);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
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

void TestApprovedHistories::historiesAreAsApproved()
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
    for (const RepositoryFiles &pack : std::as_const(packs)) {
        RepositoryFiles files = made.files;
        files.remove(pathOf(right));
        files.remove(pathOf(wrong));
        files.insert(pack);
        all += told(keptHistory(files, steps)) + u'\n';
        QCryptographicHash broken(QCryptographicHash::Sha256);
        for (auto it = files.cbegin(); it != files.cend(); ++it) {
            if (&pack != &packs.first() && !it.key().startsWith(text("objects/pack/")))
                continue; // broken beside the first pack already
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

QTEST_GUILESS_MAIN(TestApprovedHistories)
#include "test_approved_histories.moc"
