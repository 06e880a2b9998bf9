<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Arrangement</name>
    <message>
        <source>Rack</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>%1 circles are too many: at most %2 are right</source>
        <translation>%1 Kreise sind zu viele: Richtig sind höchstens %2</translation>
    </message>
    <message>
        <source>They do not fit into the square: fewer or smaller ones are right</source>
        <translation>Sie passen nicht in das Quadrat: Richtig sind weniger oder kleinere</translation>
    </message>
</context>
<context>
    <name>AuthorForms</name>
    <message>
        <source>An id of letters, digits, dots, dashes and underscores is right</source>
        <translation>Richtig ist eine Kennung aus Buchstaben, Ziffern, Punkten, Binde- und Unterstrichen</translation>
    </message>
    <message>
        <source>Points: a number from 0 to 1000 is right</source>
        <translation>Punkte: Richtig ist eine Zahl von 0 bis 1000</translation>
    </message>
</context>
<context>
    <name>AuthorMenu</name>
    <message>
        <source>&amp;Lab</source>
        <translation>&amp;Lab</translation>
    </message>
    <message>
        <source>&amp;New lab…</source>
        <translation>&amp;Neues Lab…</translation>
    </message>
    <message>
        <source>&amp;Open a folder…</source>
        <translation>Einen Ordner &amp;öffnen…</translation>
    </message>
    <message>
        <source>Open lab in one &amp;file…</source>
        <translation>Lab aus einer &amp;Datei öffnen…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>&amp;Export as one file…</source>
        <translation>Als eine Datei e&amp;xportieren…</translation>
    </message>
    <message>
        <source>Export for st&amp;udents…</source>
        <translation>&amp;Für Studierende exportieren…</translation>
    </message>
    <message>
        <source>&amp;Properties…</source>
        <translation>&amp;Eigenschaften…</translation>
    </message>
    <message>
        <source>Open as a s&amp;tudent</source>
        <translation>Wie S&amp;tudierende öffnen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>F&amp;ind and replace in the lab…</source>
        <translation>Im Lab &amp;suchen und ersetzen…</translation>
    </message>
    <message>
        <source>Insert the scene as a &amp;figure</source>
        <translation>Szene als &amp;Abbildung einfügen</translation>
    </message>
    <message>
        <source>&amp;Values of lab and step</source>
        <translation>Werte von &amp;Lab und Schritt</translation>
    </message>
    <message>
        <source>Start from the moment &amp;shown</source>
        <translation>Ab dem &amp;gezeigten Moment starten</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Schritt</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Move d&amp;own</source>
        <translation>Nach u&amp;nten</translation>
    </message>
    <message>
        <source>&amp;Proof</source>
        <translation>&amp;Nachweis</translation>
    </message>
    <message>
        <source>&amp;Verify this step</source>
        <translation>Diesen Schritt &amp;nachweisen</translation>
    </message>
    <message>
        <source>Verify the &amp;lab</source>
        <translation>Das ganze &amp;Lab nachweisen</translation>
    </message>
    <message>
        <source>&amp;Suggest mistakes</source>
        <translation>&amp;Fehler vorschlagen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
</context>
<context>
    <name>AuthorPanes</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Nachweis</translation>
    </message>
    <message>
        <source>Parts of the step</source>
        <translation>Teile des Schritts</translation>
    </message>
</context>
<context>
    <name>ChartExport</name>
    <message>
        <source>Drawings (*.svg)</source>
        <translation>Zeichnungen (*.svg)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation>Diagramm speichern</translation>
    </message>
    <message>
        <source>Save the numbers of the chart</source>
        <translation>Zahlen des Diagramms speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>&amp;Bild kopieren</translation>
    </message>
    <message>
        <source>Picture as PN&amp;G…</source>
        <translation>Bild als PN&amp;G…</translation>
    </message>
    <message>
        <source>Picture as &amp;SVG…</source>
        <translation>Bild als &amp;SVG…</translation>
    </message>
    <message>
        <source>&amp;Numbers as CSV…</source>
        <translation>Zahlen als &amp;CSV…</translation>
    </message>
    <message>
        <source>the name ends in .%1, but this is a .%2 file; choose another name</source>
        <translation>der Name endet auf .%1, dies ist aber eine .%2-Datei; wähle einen anderen Namen</translation>
    </message>
</context>
<context>
    <name>CheckKinds</name>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>What is right; that of the scene if left out</source>
        <translation>Was richtig ist; ohne Angabe der Wert der Szene</translation>
    </message>
    <message>
        <source>Circles collide</source>
        <translation>Kreise stoßen zusammen</translation>
    </message>
    <message>
        <source>Leave out the moments at which circles may touch</source>
        <translation>Augenblicke auslassen, in denen Kreise sich berühren können</translation>
    </message>
    <message>
        <source>Restitution e</source>
        <translation>Stoßzahl e</translation>
    </message>
    <message>
        <source>Hits at least</source>
        <translation>Stöße mindestens</translation>
    </message>
    <message>
        <source>How many hits there must be</source>
        <translation>Wie viele Stöße es geben muss</translation>
    </message>
    <message>
        <source>Integrators</source>
        <translation>Integratoren</translation>
    </message>
    <message>
        <source>Any of these is right</source>
        <translation>Jeder von diesen ist richtig</translation>
    </message>
    <message>
        <source>Laws</source>
        <translation>Gesetze</translation>
    </message>
    <message>
        <source>Any of these is right: both stop; they swap their velocities; they swap the parts along the line of centres; the impulse of masses and e</source>
        <translation>Jedes von diesen ist richtig: beide bleiben stehen; sie tauschen die Geschwindigkeiten; sie tauschen die Anteile längs der Verbindungslinie; der Kraftstoß aus Massen und e</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>How far off is still right</source>
        <translation>Welche Abweichung noch richtig ist</translation>
    </message>
    <message>
        <source>One for each of the circles; not looked at if left out</source>
        <translation>Einer für jeden der Kreise; ohne Angabe nicht geprüft</translation>
    </message>
    <message>
        <source>Not looked at if left out</source>
        <translation>Ohne Angabe nicht geprüft</translation>
    </message>
    <message>
        <source>Starts with these values</source>
        <translation>Beginnt mit diesen Werten</translation>
    </message>
    <message>
        <source>The values that a circle starts with</source>
        <translation>Die Werte, mit denen ein Kreis beginnt</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>How many circles there are</source>
        <translation>Wie viele Kreise es gibt</translation>
    </message>
    <message>
        <source>Moves by an integrator</source>
        <translation>Bewegt sich nach einem Integrator</translation>
    </message>
    <message>
        <source>Every step far from walls is one of the named integrators under the named gravity</source>
        <translation>Jeder Schritt fern der Wände ist einer der genannten Integratoren unter der genannten Schwerkraft</translation>
    </message>
    <message>
        <source>Follows x₀ + v₀t + ½gt²</source>
        <translation>Folgt x₀ + v₀t + ½gt²</translation>
    </message>
    <message>
        <source>Up to the first bounce it is where the formula says</source>
        <translation>Bis zum ersten Abprall ist er, wo die Formel sagt</translation>
    </message>
    <message>
        <source>Stay together</source>
        <translation>Bleiben zusammen</translation>
    </message>
    <message>
        <source>Two circles are in the same place with the same velocity at every step</source>
        <translation>Zwei Kreise sind in jedem Schritt am selben Ort mit derselben Geschwindigkeit</translation>
    </message>
    <message>
        <source>Use the same integrator</source>
        <translation>Benutzen denselben Integrator</translation>
    </message>
    <message>
        <source>Two circles follow one and the same integrator, whichever it is</source>
        <translation>Zwei Kreise folgen ein und demselben Integrator, gleich welchem</translation>
    </message>
    <message>
        <source>Is there at a moment</source>
        <translation>Ist zu einem Zeitpunkt dort</translation>
    </message>
    <message>
        <source>Positions and velocities at a moment; between two steps, on the straight line between them</source>
        <translation>Orte und Geschwindigkeiten zu einem Zeitpunkt; zwischen zwei Schritten auf der Geraden dazwischen</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Zeitpunkt</translation>
    </message>
    <message>
        <source>Seconds from the start; the end if left out</source>
        <translation>Sekunden ab dem Start; ohne Angabe das Ende</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>Geschwindigkeiten</translation>
    </message>
    <message>
        <source>Walls reflect with e</source>
        <translation>Wände reflektieren mit e</translation>
    </message>
    <message>
        <source>At a wall v_n&apos; = −e v_n; the part along the wall stays; at the rim and in time</source>
        <translation>An einer Wand v_n&apos; = −e v_n; der Anteil längs der Wand bleibt; am Rand und rechtzeitig</translation>
    </message>
    <message>
        <source>Stays inside</source>
        <translation>Bleibt drinnen</translation>
    </message>
    <message>
        <source>Never further beyond a wall than the way of one step and the tolerance</source>
        <translation>Nie weiter hinter einer Wand als der Weg eines Schritts und die Toleranz</translation>
    </message>
    <message>
        <source>Bounces to the heights e²ⁿ h₀</source>
        <translation>Springt auf die Höhen e²ⁿ h₀</translation>
    </message>
    <message>
        <source>After the n-th bounce it rises to e²ⁿ times the height it came from</source>
        <translation>Nach dem n-ten Aufprall steigt er auf das e²ⁿ-Fache der Ausgangshöhe</translation>
    </message>
    <message>
        <source>Bounces</source>
        <translation>Aufpralle</translation>
    </message>
    <message>
        <source>How many are looked at; those lower than the tolerance are not</source>
        <translation>Wie viele geprüft werden; solche unter der Toleranz nicht</translation>
    </message>
    <message>
        <source>How far off is still right, as a share of the first height</source>
        <translation>Welche Abweichung noch richtig ist, als Anteil der ersten Höhe</translation>
    </message>
    <message>
        <source>Comes to rest</source>
        <translation>Kommt zur Ruhe</translation>
    </message>
    <message>
        <source>At the end it lies on the floor as still as its integrator allows</source>
        <translation>Am Ende liegt er so still auf dem Boden, wie sein Integrator es zulässt</translation>
    </message>
    <message>
        <source>Collide by a law</source>
        <translation>Stoßen nach einem Gesetz</translation>
    </message>
    <message>
        <source>Circles 1 and 2 answer every contact, in time, by one of the named laws: stop, exchange velocities, exchange normal parts, impulse with e</source>
        <translation>Kreise 1 und 2 beantworten jede Berührung rechtzeitig nach einem der genannten Gesetze: stehen bleiben, Geschwindigkeiten tauschen, Normalanteile tauschen, Kraftstoß mit e</translation>
    </message>
    <message>
        <source>Hit when the gap closes</source>
        <translation>Stoßen, wenn sich die Lücke schließt</translation>
    </message>
    <message>
        <source>Circles 1 and 2 answer every contact when their rims meet, neither earlier nor later, in whatever way</source>
        <translation>Kreise 1 und 2 beantworten jede Berührung, wenn ihre Ränder sich treffen, nicht früher und nicht später, gleich wie</translation>
    </message>
    <message>
        <source>Part with e times the speed</source>
        <translation>Trennen sich mit dem e-Fachen des Tempos</translation>
    </message>
    <message>
        <source>In every hit of circles 1 and 2 their relative speed along the line of centres becomes e times what it was</source>
        <translation>Bei jedem Stoß der Kreise 1 und 2 wird ihre relative Geschwindigkeit längs der Verbindungslinie der Mittelpunkte das e-Fache</translation>
    </message>
    <message>
        <source>Keep momentum and energy</source>
        <translation>Erhalten Impuls und Energie</translation>
    </message>
    <message>
        <source>Every hit of circles 1 and 2 keeps the momentum and, if asked, the kinetic energy</source>
        <translation>Jeder Stoß der Kreise 1 und 2 erhält den Impuls und, wenn verlangt, die kinetische Energie</translation>
    </message>
    <message>
        <source>Kinetic energy, too</source>
        <translation>Auch die kinetische Energie</translation>
    </message>
    <message>
        <source>Else only the momentum is looked at</source>
        <translation>Sonst wird nur der Impuls geprüft</translation>
    </message>
    <message>
        <source>What share may be missing</source>
        <translation>Welcher Anteil fehlen darf</translation>
    </message>
    <message>
        <source>Leave the first hit with</source>
        <translation>Verlassen den ersten Stoß mit</translation>
    </message>
    <message>
        <source>The velocities of circles 1 and 2 after their first hit</source>
        <translation>Die Geschwindigkeiten der Kreise 1 und 2 nach ihrem ersten Stoß</translation>
    </message>
    <message>
        <source>One for each of the two circles</source>
        <translation>Eine für jeden der beiden Kreise</translation>
    </message>
    <message>
        <source>Lose energy</source>
        <translation>Verlieren Energie</translation>
    </message>
    <message>
        <source>The first hit of circles 1 and 2 takes kinetic energy</source>
        <translation>Der erste Stoß der Kreise 1 und 2 nimmt kinetische Energie</translation>
    </message>
    <message>
        <source>Pass through each other</source>
        <translation>Gehen durcheinander hindurch</translation>
    </message>
    <message>
        <source>Circles 1 and 2 cross without changing</source>
        <translation>Kreise 1 und 2 durchqueren einander unverändert</translation>
    </message>
    <message>
        <source>Your own, in Lua</source>
        <translation>Eigene Prüfung in Lua</translation>
    </message>
    <message>
        <source>The function check(run) of a file looks at the whole run and says what is wrong with it</source>
        <translation>Die Funktion check(run) einer Datei sieht sich den ganzen Lauf an und sagt, was daran falsch ist</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>In the folder checks of the step, such as heights.lua</source>
        <translation>Im Ordner checks des Schritts, etwa heights.lua</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> in %1</translation>
    </message>
    <message>
        <source> from %1 to %2</source>
        <translation> von %1 bis %2</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>a list out of %1</source>
        <translation>eine Liste aus %1</translation>
    </message>
    <message>
        <source>a list [x, y], each %1</source>
        <translation>eine Liste [x, y], jeweils %1</translation>
    </message>
    <message>
        <source>a list of lists [x, y], each %1</source>
        <translation>eine Liste von Listen [x, y], jeweils %1</translation>
    </message>
    <message>
        <source>a list [least, most], each %1</source>
        <translation>eine Liste [kleinster, größter], jeweils %1</translation>
    </message>
    <message>
        <source>a list, each %1</source>
        <translation>eine Liste, jeweils %1</translation>
    </message>
    <message>
        <source>the name of a file in the folder checks, such as heights.lua</source>
        <translation>der Name einer Datei im Ordner checks, etwa heights.lua</translation>
    </message>
    <message>
        <source>the moment %1 s is after the end of the scene; at most its duration of %2 s is right</source>
        <translation>der Zeitpunkt %1 s liegt nach dem Ende der Szene; richtig ist höchstens ihre Dauer von %2 s</translation>
    </message>
    <message numerus="yes">
        <source>there is no circle %1; the scene of the step has %n circle(s)</source>
        <translation>
            <numerusform>es gibt keinen Kreis %1; die Szene des Schritts hat %n Kreis</numerusform>
            <numerusform>es gibt keinen Kreis %1; die Szene des Schritts hat %n Kreise</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is not right here; right would be one of %2</source>
        <translation>%1 ist hier nicht richtig; richtig wäre eines von %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 needs %2 circles; the scene of the step has %n circle(s)</source>
        <translation>
            <numerusform>%1 braucht %2 Kreise; die Szene des Schritts hat %n Kreis</numerusform>
            <numerusform>%1 braucht %2 Kreise; die Szene des Schritts hat %n Kreise</numerusform>
        </translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing; right would be %2</source>
        <translation>„%1“ fehlt; richtig wäre %2</translation>
    </message>
    <message>
        <source>%1 has no parameters</source>
        <translation>%1 hat keine Parameter</translation>
    </message>
    <message>
        <source>%1 has no parameter &quot;%2&quot;; it has %3</source>
        <translation>%1 hat keinen Parameter „%2“; vorhanden sind %3</translation>
    </message>
    <message>
        <source>%1 is not right here; right would be %2</source>
        <translation>%1 ist hier nicht richtig; richtig wäre %2</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>How long every scene runs</source>
        <translation>Wie lange jede Szene läuft</translation>
    </message>
    <message>
        <source>Timesteps</source>
        <translation>Zeitschritte</translation>
    </message>
    <message>
        <source>The scenes take turns with these; 1/60 s if left out, in the student&apos;s own scene its own</source>
        <translation>Die Szenen wechseln sich damit ab; ohne Angabe 1/60 s, in der eigenen Szene deren Zeitschritt</translation>
    </message>
    <message>
        <source>Drawn between the least and the most</source>
        <translation>Gezogen zwischen dem kleinsten und dem größten Wert</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>Geschwindigkeitsbeträge</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>How many scenes are drawn</source>
        <translation>Wie viele Szenen gezogen werden</translation>
    </message>
    <message>
        <source>Radii</source>
        <translation>Radien</translation>
    </message>
    <message>
        <source>Densities</source>
        <translation>Dichten</translation>
    </message>
    <message>
        <source>None if left out</source>
        <translation>Ohne Angabe keine</translation>
    </message>
    <message>
        <source>Restitutions e</source>
        <translation>Stoßzahlen e</translation>
    </message>
    <message>
        <source>The scenes take turns with these</source>
        <translation>Die Szenen wechseln sich damit ab</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>The same scenes in every check; drawn anew with the seed of the check if left out</source>
        <translation>Bei jeder Prüfung dieselben Szenen; ohne Angabe mit dem Startwert der Prüfung neu gezogen</translation>
    </message>
    <message>
        <source>The student&apos;s own scene</source>
        <translation>Die eigene Szene</translation>
    </message>
    <message>
        <source>With each of the timesteps</source>
        <translation>Mit jedem der Zeitschritte</translation>
    </message>
    <message>
        <source>Throws</source>
        <translation>Würfe</translation>
    </message>
    <message>
        <source>The circles thrown together from the middle, in any direction</source>
        <translation>Die Kreise gemeinsam aus der Mitte geworfen, in beliebiger Richtung</translation>
    </message>
    <message>
        <source>Shots in all directions</source>
        <translation>Schüsse in alle Richtungen</translation>
    </message>
    <message>
        <source>Shots at the corners</source>
        <translation>Schüsse in die Ecken</translation>
    </message>
    <message>
        <source>Encounters</source>
        <translation>Begegnungen</translation>
    </message>
    <message>
        <source>Circles 1 and 2 thrown so that they meet, from all angles</source>
        <translation>Kreise 1 und 2 so geworfen, dass sie sich treffen, aus allen Winkeln</translation>
    </message>
    <message>
        <source>Off centre</source>
        <translation>Außermittig</translation>
    </message>
    <message>
        <source>How far off centre they meet at most, in r₁ + r₂</source>
        <translation>Wie weit außermittig sie sich höchstens treffen, in r₁ + r₂</translation>
    </message>
    <message>
        <source>Both move</source>
        <translation>Beide bewegen sich</translation>
    </message>
    <message>
        <source>Circles that part</source>
        <translation>Kreise, die sich trennen</translation>
    </message>
    <message>
        <source>Circles 1 and 2 overlap, as after a hit that was told late, and move apart already; ask for 0 hits</source>
        <translation>Kreise 1 und 2 überlappen wie nach einem spät bemerkten Stoß und entfernen sich schon; verlange 0 Stöße</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Fallversuche</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>From the x axis; the scenes divide them evenly</source>
        <translation>Von der x-Achse aus; die Szenen teilen sie gleichmäßig auf</translation>
    </message>
    <message>
        <source>How often walls must turn the circles round, together, in every scene</source>
        <translation>Wie oft Kreise an Wänden umkehren müssen, zusammen, in jeder Szene</translation>
    </message>
    <message>
        <source>Visits at least</source>
        <translation>Besuche mindestens</translation>
    </message>
    <message>
        <source>How often each circle must come to a wall</source>
        <translation>Wie oft jeder Kreis an eine Wand kommen muss</translation>
    </message>
    <message>
        <source>Free at least</source>
        <translation>Frei mindestens</translation>
    </message>
    <message>
        <source>How long each circle must be free of walls and circles; a tenth of the duration if left out</source>
        <translation>Wie lange jeder Kreis frei von Wänden und Kreisen sein muss; ein Zehntel der Dauer, wenn nicht angegeben</translation>
    </message>
    <message>
        <source>Each of the circles at the walls, all round, while the others move on where nothing meets them</source>
        <translation>Jeder der Kreise an die Wände, ringsum, während die anderen weiterlaufen, wo ihnen nichts begegnet</translation>
    </message>
    <message>
        <source>Each of the circles straight at the corners and just beside them, while the others move on where nothing meets them</source>
        <translation>Jeder der Kreise genau in die Ecken und dicht daneben, während die anderen weiterlaufen, wo ihnen nichts begegnet</translation>
    </message>
    <message>
        <source>Also one after the other, or one of them at rest; else circle 2 rests before the hit</source>
        <translation>Auch einer dem anderen hinterher oder einer von ihnen in Ruhe; sonst ruht Kreis 2 vor dem Stoß</translation>
    </message>
    <message>
        <source>Slow hits</source>
        <translation>Langsame Stöße</translation>
    </message>
    <message>
        <source>Sideways</source>
        <translation>Seitwärts</translation>
    </message>
    <message>
        <source>Speed to the right, drawn between the least and the most</source>
        <translation>Tempo nach rechts, gezogen zwischen dem kleinsten und dem größten</translation>
    </message>
    <message>
        <source>Again at once</source>
        <translation>Gleich noch einmal</translation>
    </message>
    <message>
        <source>another check has the id %1 already; an id of its own is right</source>
        <translation>eine andere Prüfung hat schon die Kennung %1; richtig ist eine eigene</translation>
    </message>
    <message>
        <source>Some, between equal circles, are in front of a wall that sends circle 2 back to a second hit, with another line of centres; in two more the heavier circle meets the other twice on one line, which a wall sends back</source>
        <translation>Einige, zwischen gleichen Kreisen, liegen vor einer Wand, die Kreis 2 zu einem zweiten Stoß mit anderer Verbindungslinie der Mittelpunkte zurückschickt; in zwei weiteren trifft der schwerere Kreis den anderen, den eine Wand zurückschickt, zweimal auf einer Linie</translation>
    </message>
    <message>
        <source>The circles come slowly to the floor and to the ceiling, sooner or later in a step: what leaves a wall more slowly than it came is easily turned twice. Some are let go at rest, just above the floor</source>
        <translation>Die Kreise kommen langsam an Boden und Decke, früher oder später in einem Schritt: Was eine Wand langsamer verlässt, als es kam, kehrt leicht zweimal um. Einige werden ruhend dicht über dem Boden losgelassen</translation>
    </message>
    <message>
        <source>The circles fall onto the floor; in the last scene, where e is 1, from so low that they bounce often</source>
        <translation>Die Kreise fallen auf den Boden; in der letzten Szene, wenn e dort 1 ist, von so tief, dass sie oft aufprallen</translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message>
        <source>There is no circle %1; add one</source>
        <translation>Kreis %1 fehlt; füge ihn hinzu</translation>
    </message>
    <message>
        <source>At step %1 circle %2 hit a wall and its velocity along the wall changed from %3 to %4 m/s; only the part into the wall should change</source>
        <translation>In Schritt %1 traf Kreis %2 auf eine Wand, und seine Geschwindigkeit längs der Wand änderte sich von %3 auf %4 m/s; nur der Anteil in die Wand soll sich ändern</translation>
    </message>
    <message>
        <source>At step %1 circle %2 turned round although its rim was still %3 m from the %4; it should touch first</source>
        <translation>In Schritt %1 kehrte Kreis %2 um, obwohl sein Rand noch %3 m von %4 entfernt war; er soll zuerst berühren</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was already leaving the %3 with %4 m/s and was turned round again; it should be left alone</source>
        <translation>In Schritt %1 bewegte sich Kreis %2 schon mit %4 m/s von %3 weg und kehrte noch einmal um; er soll in Ruhe gelassen werden</translation>
    </message>
    <message>
        <source>At step %1 circle %2 came to the %3 with %4 m/s and left it with %5 m/s; −e times %4 m/s with e = %6 is %7 m/s</source>
        <translation>In Schritt %1 kam Kreis %2 mit %4 m/s zu %3 und ging mit %5 m/s; −e mal %4 m/s mit e = %6 ist %7 m/s</translation>
    </message>
    <message>
        <source>At step %1 the rim of circle %2 is %3 m beyond the %4; at most the way of one step, %5 m, is right</source>
        <translation>In Schritt %1 liegt der Rand von Kreis %2 um %3 m hinter %4; richtig ist höchstens der Weg eines Schritts, %5 m</translation>
    </message>
    <message>
        <source>At step %1 the circles have run into each other and go on as if nothing had happened; they should answer as soon as their distance is r₁ + r₂</source>
        <translation>In Schritt %1 sind die Kreise ineinander gelaufen und bewegen sich weiter, als wäre nichts geschehen; sie sollen antworten, sobald ihr Abstand r₁ + r₂ ist</translation>
    </message>
    <message>
        <source>At step %1 the hit changed the total momentum from %2 to %3 kg m/s; it should stay</source>
        <translation>In Schritt %1 änderte der Stoß den Gesamtimpuls von %2 auf %3 kg m/s; er soll bleiben</translation>
    </message>
    <message>
        <source>At step %1 the hit changed the kinetic energy from %2 to %3 J; it should stay</source>
        <translation>In Schritt %1 änderte der Stoß die kinetische Energie von %2 auf %3 J; sie soll bleiben</translation>
    </message>
    <message>
        <source>At step %1 circle %2 left the first hit with %3 m/s; %4 m/s is right</source>
        <translation>In Schritt %1 kam Kreis %2 mit %3 m/s aus dem ersten Stoß; richtig ist %4 m/s</translation>
    </message>
    <message>
        <source>At step %1 the kinetic energy was %2 J before the hit and %3 J after it; with e below 1 it should be less</source>
        <translation>In Schritt %1 war die kinetische Energie vor dem Stoß %2 J und danach %3 J; mit e unter 1 soll sie kleiner werden</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed from %3 to %4 m/s; the circles should pass through each other unchanged</source>
        <translation>In Schritt %1 änderte sich die Geschwindigkeit von Kreis %2 von %3 auf %4 m/s; die Kreise sollen unverändert durcheinander hindurchgehen</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed by %3 m/s, an acceleration of %4 m/s²; %5 m/s² is right here</source>
        <translation>In Schritt %1 änderte sich die Geschwindigkeit von Kreis %2 um %3 m/s, eine Beschleunigung von %4 m/s²; richtig ist hier %5 m/s²</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m; by %4 it moves by %5 m</source>
        <translation>In Schritt %1 bewegte sich Kreis %2 um %3 m; mit dem Verfahren %4 sind es %5 m</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>Circle %1 moves by %2 and circle %3 by %4; the same for both is right</source>
        <translation>Kreis %1 benutzt das Verfahren %2 und Kreis %3 das Verfahren %4; richtig ist für beide dasselbe</translation>
    </message>
    <message>
        <source>At step %1 circle %2 is at %3 m; x₀ + v₀t + ½gt² is %4 m</source>
        <translation>In Schritt %1 ist Kreis %2 bei %3 m; x₀ + v₀t + ½gt² ist %4 m</translation>
    </message>
    <message>
        <source>left wall</source>
        <translation>der linken Wand</translation>
    </message>
    <message>
        <source>right wall</source>
        <translation>der rechten Wand</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>dem Boden</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>der Decke</translation>
    </message>
    <message>
        <source>Euler</source>
        <translation>Euler</translation>
    </message>
    <message>
        <source>symplectic Euler</source>
        <translation>symplektischer Euler</translation>
    </message>
    <message>
        <source>velocity Verlet</source>
        <translation>Velocity-Verlet</translation>
    </message>
    <message>
        <source>Runge-Kutta 4</source>
        <translation>Runge-Kutta 4</translation>
    </message>
    <message>
        <source>After %1 s circle %2 still comes %3 m above the floor with e = %4; at most %5 m is right for its integrator</source>
        <translation>Nach %1 s kommt Kreis %2 mit e = %4 noch %3 m über den Boden; richtig sind für seinen Integrator höchstens %5 m</translation>
    </message>
    <message>
        <source>%1 is %2 %4 at the start; %3 %4 is asked for</source>
        <translation>%1 ist am Anfang %2 %4; verlangt ist %3 %4</translation>
    </message>
    <message>
        <source>The position of circle %1</source>
        <translation>Der Ort von Kreis %1</translation>
    </message>
    <message>
        <source>The velocity of circle %1</source>
        <translation>Die Geschwindigkeit von Kreis %1</translation>
    </message>
    <message>
        <source>The radius of circle %1</source>
        <translation>Der Radius von Kreis %1</translation>
    </message>
    <message>
        <source>The density of circle %1</source>
        <translation>Die Dichte von Kreis %1</translation>
    </message>
    <message>
        <source>There are %1 circles; %2 are asked for</source>
        <translation>Die Zahl der Kreise ist %1; verlangt ist %2</translation>
    </message>
    <message>
        <source>At step %1 circle %2 is at %3 m with %4 m/s and circle %5 at %6 m with %7 m/s; they should be in the same place with the same velocity</source>
        <translation>In Schritt %1 ist Kreis %2 bei %3 m mit %4 m/s und Kreis %5 bei %6 m mit %7 m/s; sie sollen am selben Ort sein und dieselbe Geschwindigkeit haben</translation>
    </message>
    <message>
        <source>A check runs at most %1 circles; there are %2</source>
        <translation>Eine Prüfung rechnet mit höchstens %1 Kreisen; es sind %2</translation>
    </message>
    <message>
        <source>The timestep %1 s is too short to be judged; %2 s or more is right</source>
        <translation>Der Zeitschritt %1 s ist zu kurz, um geprüft zu werden; richtig sind %2 s oder mehr</translation>
    </message>
    <message>
        <source>not judged: the program stopped with an error</source>
        <translation>nicht geprüft: Das Programm brach mit einem Fehler ab</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m at once; with its velocity it comes %4 m far</source>
        <translation>In Schritt %1 bewegte sich Kreis %2 auf einmal um %3 m; mit seiner Geschwindigkeit kommt er %4 m weit</translation>
    </message>
    <message>
        <source>At step %1 circle %2 came to the %3 with %4 m/s and left it with %5 m/s; %6 m/s is right</source>
        <translation>In Schritt %1 kam Kreis %2 mit %4 m/s zu %3 und ging mit %5 m/s; richtig sind %6 m/s</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m; its velocity times the timestep is %4 m</source>
        <translation>In Schritt %1 bewegte sich Kreis %2 um %3 m; seine Geschwindigkeit mal dem Zeitschritt ist %4 m</translation>
    </message>
    <message>
        <source>After bounce %1 circle %2 rises to %3 m above the floor; e to the power of %4 times the first height, with e = %5, is %6 m</source>
        <translation>Nach Aufprall %1 steigt Kreis %2 auf %3 m über dem Boden; e hoch %4 mal die erste Höhe ist mit e = %5 %6 m</translation>
    </message>
    <message>
        <source>Circle %1 comes off the floor and down again %2 times; at least %3 is right</source>
        <translation>Kreis %1 springt %2-mal vom Boden auf und fällt wieder; richtig ist mindestens %3</translation>
    </message>
    <message>
        <source>At step %1 the circles met with %2 m/s along the line of centres and parted with %3 m/s; e times as much, with e = %4, is %5 m/s</source>
        <translation>In Schritt %1 trafen sich die Kreise längs der Verbindungslinie der Mittelpunkte mit %2 m/s und trennten sich mit %3 m/s; das e-Fache ist mit e = %4 %5 m/s</translation>
    </message>
    <message>
        <source>At %1 s circle %2 is at %3 m; %4 m is right</source>
        <translation>Bei %1 s ist Kreis %2 bei %3 m; richtig ist %4 m</translation>
    </message>
    <message>
        <source>At %1 s circle %2 moves with %3 m/s; %4 m/s is right</source>
        <translation>Bei %1 s bewegt sich Kreis %2 mit %3 m/s; richtig ist %4 m/s</translation>
    </message>
    <message>
        <source>%1: the check itself stopped, so it says nothing of your work: %2</source>
        <translation>%1: Die Prüfung selbst brach ab und sagt nichts über deine Arbeit: %2</translation>
    </message>
    <message>
        <source>What the step fixes is as the step has it</source>
        <translation>Was der Schritt festlegt, ist so, wie er es festlegt</translation>
    </message>
    <message>
        <source>the check took more than %1 million instructions; an update should take a few thousand</source>
        <translation>die Prüfung brauchte mehr als %1 Millionen Befehle; für ein on_update sollten einige Tausend reichen</translation>
    </message>
    <message>
        <source>stopped by the machine: the check took more than %1 s. This is no verdict on the program</source>
        <translation>vom Rechner abgebrochen: Die Prüfung dauerte mehr als %1 s. Das ist kein Urteil über das Programm</translation>
    </message>
    <message>
        <source>In %1 s circle %2 came to a wall %3 times; at least %4 must be seen to judge whether it stays inside</source>
        <translation>In %1 s kam Kreis %2 %3-mal an eine Wand; um zu beurteilen, ob er drinnen bleibt, muss es mindestens %4-mal zu sehen sein</translation>
    </message>
    <message>
        <source>Circle %1 was free of walls and other circles for %2 s only; at least %3 s must be seen to judge its motion</source>
        <translation>Kreis %1 war nur %2 s lang frei von Wänden und anderen Kreisen; um seine Bewegung zu beurteilen, müssen mindestens %3 s zu sehen sein</translation>
    </message>
    <message>
        <source>Circle %1 came %2 m far in %3 s; at least its diameter of %4 m must be seen to judge whether they stay together</source>
        <translation>Kreis %1 kam in %3 s %2 m weit; mindestens sein Durchmesser von %4 m muss zu sehen sein, um zu beurteilen, ob sie zusammenbleiben</translation>
    </message>
    <message>
        <source>not judged: your program does not move the circles</source>
        <translation>nicht beurteilt: Dein Programm bewegt die Kreise nicht</translation>
    </message>
    <message>
        <source>not judged: what moves the circles is not what the step asks for</source>
        <translation>nicht beurteilt: Die Kreise bewegt nicht, was der Schritt verlangt</translation>
    </message>
    <message>
        <source>Your program moves the circles</source>
        <translation>Dein Programm bewegt die Kreise</translation>
    </message>
    <message>
        <source>The laws of the scene move the circles</source>
        <translation>Die Gesetze der Szene bewegen die Kreise</translation>
    </message>
    <message>
        <source>Your program moves the circles: leave on_update out, and the laws of the scene do it</source>
        <translation>Dein Programm bewegt die Kreise: Lass on_update weg, dann tun es die Gesetze der Szene</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 into the %3 was %4 m/s before the step and %5 m/s after it; with e = %6 and gravity, %7 to %8 m/s is right</source>
        <translation>In Schritt %1 war die Geschwindigkeit von Kreis %2 zu %3 hin vor dem Schritt %4 m/s und danach %5 m/s; mit e = %6 und der Schwerkraft sind %7 bis %8 m/s richtig</translation>
    </message>
    <message>
        <source>Hits that the circles answered: %1; at least %2 is right</source>
        <translation>Stöße, die die Kreise beantwortet haben: %1; richtig sind mindestens %2</translation>
    </message>
    <message>
        <source>Turns at walls, away from the other circle, in %1 s: %2; at least %3 must be seen to judge them</source>
        <translation>Umkehrungen an Wänden, fern vom anderen Kreis, in %1 s: %2; mindestens %3 müssen zu sehen sein, um sie zu beurteilen</translation>
    </message>
    <message>
        <source>Turns at walls in %1 s: %2; at least %3 must be seen to judge them</source>
        <translation>Umkehrungen an Wänden in %1 s: %2; mindestens %3 müssen zu sehen sein, um sie zu beurteilen</translation>
    </message>
    <message>
        <source>At step %1 the rim of circle %2 is %3 m beyond the %4, where it was without any speed; it should not be beyond it</source>
        <translation>In Schritt %1 ist der Rand von Kreis %2 um %3 m hinter %4, wo er kein Tempo mehr hatte; er soll nicht dahinter liegen</translation>
    </message>
    <message>
        <source>At step %1, at a wall, circle %2 had %3 m/s along the wall before the step and %4 m/s after it; with gravity alone it is %5 m/s</source>
        <translation>In Schritt %1 hatte Kreis %2 an einer Wand vor dem Schritt %3 m/s längs der Wand und danach %4 m/s; mit der Schwerkraft allein sind es %5 m/s</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was leaving the %3, with %4 m/s before the step and %5 m/s after it; with gravity alone it is %6 m/s</source>
        <translation>In Schritt %1 bewegte sich Kreis %2 von %3 weg, mit %4 m/s vor dem Schritt und %5 m/s danach; mit der Schwerkraft allein sind es %6 m/s</translation>
    </message>
    <message>
        <source>At step %1 the circles were already moving apart with %2 m/s, and their velocities changed from %3 and %4 to %5 and %6 m/s; circles that move apart should be left alone</source>
        <translation>In Schritt %1 entfernten sich die Kreise schon mit %2 m/s voneinander, und ihre Geschwindigkeiten änderten sich von %3 und %4 auf %5 und %6 m/s; Kreise, die sich entfernen, sollen in Ruhe gelassen werden</translation>
    </message>
    <message>
        <source>At step %1, with e = %2, the circles have run into each other and go on as if nothing had happened; they should answer as soon as their distance is r₁ + r₂</source>
        <translation>In Schritt %1, mit e = %2, sind die Kreise ineinander gelaufen und bewegen sich weiter, als wäre nichts geschehen; sie sollen antworten, sobald ihr Abstand r₁ + r₂ ist</translation>
    </message>
    <message>
        <source>In this scene no velocity changed in a hit of the circles, so there is none to judge</source>
        <translation>In dieser Szene änderte sich bei keinem Stoß der Kreise eine Geschwindigkeit; es gibt also keinen zu beurteilen</translation>
    </message>
    <message>
        <source>In this scene no hit changed the velocities of the circles; one should</source>
        <translation>In dieser Szene änderte kein Stoß die Geschwindigkeiten der Kreise; einer soll das tun</translation>
    </message>
    <message>
        <source>. In this step %1 does so</source>
        <translation>. In diesem Schritt macht es das Verfahren %1 so</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed from %3 to %4 m/s although it touched neither a wall nor the other circle, from whose rim it was still %5 m away</source>
        <translation>In Schritt %1 änderte sich die Geschwindigkeit von Kreis %2 von %3 auf %4 m/s, obwohl er weder eine Wand noch den anderen Kreis berührte, von dessen Rand er noch %5 m entfernt war</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m, as by no integrator that this check allows; the nearest of them, %4, moves it by %5 m</source>
        <translation>In Schritt %1 bewegte sich Kreis %2 um %3 m, wie nach keinem der Verfahren, die diese Prüfung zulässt; nach dem nächsten davon, %4, sind es %5 m</translation>
    </message>
    <message>
        <source>At step %1 circle %2 still has %4 m/s into the %3, as it has since step %5; the wall should turn it round at once</source>
        <translation>In Schritt %1 hat Kreis %2, wie seit Schritt %5, immer noch %4 m/s zu %3 hin; die Wand soll ihn sofort umkehren</translation>
    </message>
    <message>
        <source>At step %1 circle %2 still has %4 m/s into the %3, as it has since step %5; with e = %6 the wall should answer at once</source>
        <translation>In Schritt %1 hat Kreis %2, wie seit Schritt %5, immer noch %4 m/s zu %3 hin; mit e = %6 soll die Wand sofort antworten</translation>
    </message>
    <message>
        <source>In this scene the circles never met, so nothing shows whether they pass through each other</source>
        <translation>In dieser Szene trafen sich die Kreise nie; so zeigt nichts, ob sie durcheinander hindurchgehen</translation>
    </message>
    <message>
        <source>At step %1, where the circles do not touch, the total momentum changed from %2 to %3 kg m/s; it should stay</source>
        <translation>In Schritt %1, in dem die Kreise sich nicht berühren, änderte sich der Gesamtimpuls von %2 auf %3 kg m/s; er soll bleiben</translation>
    </message>
    <message>
        <source>At step %1, where the circles do not touch, the kinetic energy changed from %2 to %3 J; it should stay</source>
        <translation>In Schritt %1, in dem die Kreise sich nicht berühren, änderte sich die kinetische Energie von %2 auf %3 J; sie soll bleiben</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 went from %3 to %4 m/s although it touched neither a wall nor the other circle, from whose rim it was still %5 m away; %6 m/s is right</source>
        <translation>In Schritt %1 ging die Geschwindigkeit von Kreis %2 von %3 auf %4 m/s, obwohl er weder eine Wand noch den anderen Kreis berührte, von dessen Rand er noch %5 m entfernt war; richtig sind %6 m/s</translation>
    </message>
    <message>
        <source>At step %1 circle 1 left the hit with %2 m/s and circle 2 with %3 m/s; where their line of centres points along %4, %5 and %6 m/s are right</source>
        <translation>In Schritt %1 kam Kreis 1 mit %2 m/s aus dem Stoß und Kreis 2 mit %3 m/s; wo ihre Verbindungslinie der Mittelpunkte nach %4 zeigt, sind %5 und %6 m/s richtig</translation>
    </message>
    <message>
        <source>%1. Their hit before, at step %2, came out right</source>
        <translation>%1. Ihr Stoß davor, in Schritt %2, war richtig</translation>
    </message>
    <message>
        <source>%1. A wall is reached in this step, too: judge it when the walls are right</source>
        <translation>%1. In diesem Schritt wird auch eine Wand erreicht: Beurteile ihn, wenn die Wände stimmen</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moves by %3, and in steps before by another method; one for all steps is right</source>
        <translation>In Schritt %1 bewegt sich Kreis %2 nach %3 und in Schritten davor nach einem anderen Verfahren; eines für alle Schritte ist richtig</translation>
    </message>
    <message>
        <source>None of the four integrators makes all steps of circle %1 under gravity %2 m/s²</source>
        <translation>Keiner der vier Integratoren macht alle Schritte von Kreis %1 unter der Schwerkraft %2 m/s²</translation>
    </message>
    <message>
        <source>At step %1 the circles met with %2 m/s along the line of centres, and after the hit they still come nearer, with %3 m/s; they should part with e times as much as they met with: with e = %4, %5 m/s</source>
        <translation>In Schritt %1 trafen sich die Kreise mit %2 m/s längs der Verbindungslinie, und nach dem Stoß nähern sie sich noch immer, mit %3 m/s; trennen sollten sie sich mit dem e-Fachen: bei e = %4 mit %5 m/s</translation>
    </message>
    <message>
        <source>By step %1 the circles have run into each other, and they are answered only in step %2, which begins with their centres %3 m apart; they should answer as soon as their distance is r₁ + r₂</source>
        <translation>Bis Schritt %1 sind die Kreise ineinandergelaufen, und beantwortet wird das erst in Schritt %2, an dessen Anfang ihre Mittelpunkte %3 m auseinanderliegen; antworten sollten sie, sobald ihr Abstand r₁ + r₂ ist</translation>
    </message>
    <message>
        <source>Nothing in your program moves the circles: write on_update</source>
        <translation>Nichts in deinem Programm bewegt die Kreise: Schreib on_update</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed from %3 to %4 m/s, while the circles moved apart and the other one kept its own; it should stay as it was</source>
        <translation>In Schritt %1 änderte sich die Geschwindigkeit von Kreis %2 von %3 auf %4 m/s, während sich die Kreise voneinander entfernten und der andere seine behielt; sie soll bleiben, wie sie war</translation>
    </message>
    <message>
        <source>At step %1, while the circles did not come nearer, the total momentum changed from %2 to %3 kg m/s; it should stay</source>
        <translation>In Schritt %1, in dem die Kreise sich nicht näher kamen, änderte sich der Gesamtimpuls von %2 auf %3 kg m/s; er soll bleiben</translation>
    </message>
    <message>
        <source>At step %1, while the circles did not come nearer, the kinetic energy changed from %2 to %3 J; it should stay</source>
        <translation>In Schritt %1, in dem die Kreise sich nicht näher kamen, änderte sich die kinetische Energie von %2 auf %3 J; sie soll bleiben</translation>
    </message>
    <message>
        <source>At step %1, where it touches nothing, circle %2 moved by %3 m; its velocity times the timestep is %4 m. Hits are judged once this is mended</source>
        <translation>In Schritt %1, in dem er nichts berührt, bewegte sich Kreis %2 um %3 m; seine Geschwindigkeit mal Zeitschritt ist %4 m. Stöße werden beurteilt, sobald das behoben ist</translation>
    </message>
    <message>
        <source>At step %1, where it touches nothing, circle %2 moved by %3 m; its velocity times the timestep is %4 m, and gravity adds at most %5 m. Hits are judged once this is mended</source>
        <translation>In Schritt %1, in dem er nichts berührt, bewegte sich Kreis %2 um %3 m; seine Geschwindigkeit mal dem Zeitschritt ist %4 m, und die Schwerkraft fügt höchstens %5 m hinzu. Stöße werden beurteilt, sobald das behoben ist</translation>
    </message>
    <message>
        <source>At step %1, where it touches nothing, the velocity of circle %2 went from %3 to %4 m/s; %5 m/s is right. Hits are judged once this is mended</source>
        <translation>In Schritt %1, in dem er nichts berührt, ging die Geschwindigkeit von Kreis %2 von %3 auf %4 m/s; richtig sind %5 m/s. Stöße werden beurteilt, sobald das behoben ist</translation>
    </message>
    <message>
        <source>In %2 s circle %1 never came to the floor as fast as a fall makes it; that must be seen to judge how it comes to rest</source>
        <translation>In %2 s kam Kreis %1 nie so schnell zum Boden, wie ein Fall ihn macht; das muss zu sehen sein, um zu beurteilen, wie er zur Ruhe kommt</translation>
    </message>
    <message>
        <source>. Nothing moved</source>
        <translation>. Nichts bewegte sich</translation>
    </message>
    <message>
        <source>. From %1 s on nothing moved</source>
        <translation>. Ab %1 s bewegte sich nichts</translation>
    </message>
    <message>
        <source>. For %1 s it was within a step&apos;s way of a wall or beyond it, for %2 s of another circle: look at what it does there</source>
        <translation>. %1 s lang war er höchstens den Weg eines Schritts von einer Wand entfernt oder jenseits von ihr, %2 s lang von einem anderen Kreis: Sieh dir an, was er dort tut</translation>
    </message>
    <message>
        <source>. For %1 s it was within a step&apos;s way of a wall or beyond it: look at what it does there</source>
        <translation>. %1 s lang war er höchstens den Weg eines Schritts von einer Wand entfernt oder jenseits von ihr: Sieh dir an, was er dort tut</translation>
    </message>
    <message>
        <source>. For %1 s it was within a step&apos;s way of another circle: look at what it does there</source>
        <translation>. %1 s lang war er höchstens den Weg eines Schritts von einem anderen Kreis entfernt: Sieh dir an, was er dort tut</translation>
    </message>
    <message>
        <source>At step %1, which began away from the walls, the velocity of circle %2 went from %3 to %4 m/s; %5 m/s is right. Hits are judged once this is mended</source>
        <translation>In Schritt %1, der fern der Wände begann, ging die Geschwindigkeit von Kreis %2 von %3 auf %4 m/s; richtig sind %5 m/s. Stöße werden beurteilt, sobald das behoben ist</translation>
    </message>
    <message>
        <source>In %2 s circle %1 never came to the floor; that must be seen to judge how it comes to rest</source>
        <translation>In %2 s kam Kreis %1 nie zum Boden; das muss zu sehen sein, um zu beurteilen, wie er zur Ruhe kommt</translation>
    </message>
    <message>
        <source>At step %1 the hit put circle %2 %3 m nearer to the other one than its velocities before and after it take it; a hit may move circles apart, not into each other</source>
        <translation>In Schritt %1 setzte der Stoß Kreis %2 um %3 m näher an den anderen, als ihn seine Geschwindigkeiten davor und danach bringen; ein Stoß darf die Kreise auseinandersetzen, nicht ineinander</translation>
    </message>
    <message>
        <source>At step %1 the hit put circle %2 %3 m farther from the other one than its velocities and twice what they overlapped explain; it is enough that they touch</source>
        <translation>In Schritt %1 setzte der Stoß Kreis %2 um %3 m weiter vom anderen weg, als seine Geschwindigkeiten und das Doppelte der Überlappung erklären; es genügt, dass sie sich berühren</translation>
    </message>
    <message>
        <source>At step %1 the hit put circle %2 %3 m to the side of the ways that its velocities before and after it take it; a hit may move circles apart along the line of centres only</source>
        <translation>In Schritt %1 setzte der Stoß Kreis %2 um %3 m seitlich neben die Wege, die ihn seine Geschwindigkeiten davor und danach bringen; ein Stoß darf die Kreise nur entlang der Mittelpunktslinie auseinandersetzen</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was put %4 m further in from the %3 than its velocities and twice the way of its rim beyond the wall explain; it is enough that its rim is at the wall</source>
        <translation>In Schritt %1 wurde Kreis %2 um %4 m weiter von %3 weg nach innen gesetzt, als seine Geschwindigkeiten und das Doppelte des Weges seines Randes hinter die Wand erklären; es genügt, dass sein Rand an der Wand ist</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was put %4 m further out at the %3 than its velocity takes it; it belongs where its rim is at the wall, or back</source>
        <translation>In Schritt %1 wurde Kreis %2 an %3 um %4 m weiter nach außen gesetzt, als ihn seine Geschwindigkeit bringt; er gehört dorthin, wo sein Rand an der Wand ist, oder zurück</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was put %4 m along the %3 beside the ways that its velocities before and after it take it; a wall should move it inward only, or back</source>
        <translation>In Schritt %1 wurde Kreis %2 um %4 m entlang von %3 neben die Wege gesetzt, die ihn seine Geschwindigkeiten davor und danach bringen; eine Wand soll ihn nur nach innen versetzen, oder zurück</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed from %3 to %4 m/s although the circles were moving apart, with %5 m between their rims</source>
        <translation>In Schritt %1 änderte sich die Geschwindigkeit von Kreis %2 von %3 auf %4 m/s, obwohl die Kreise sich voneinander entfernten, mit %5 m zwischen ihren Rändern</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 went from %3 to %4 m/s although the circles were moving apart, with %5 m between their rims; %6 m/s is right</source>
        <translation>In Schritt %1 ging die Geschwindigkeit von Kreis %2 von %3 auf %4 m/s, obwohl die Kreise sich voneinander entfernten, mit %5 m zwischen ihren Rändern; richtig sind %6 m/s</translation>
    </message>
    <message>
        <source>After a hit at step %1 circle %2 has a velocity of %3 m/s, away from what it hit. From there to step %4 it moved by %5 m; with its velocity it comes %6 m far</source>
        <translation>Nach einem Stoß in Schritt %1 hat Kreis %2 eine Geschwindigkeit von %3 m/s, weg von dem, was er traf. Von da bis Schritt %4 bewegte er sich um %5 m; mit seiner Geschwindigkeit kommt er %6 m weit</translation>
    </message>
</context>
<context>
    <name>CircleClipboard</name>
    <message>
        <source>The clipboard is empty: copy circles first</source>
        <translation>Die Zwischenablage ist leer: Kopiere zuerst Kreise</translation>
    </message>
    <message>
        <source>The clipboard holds too much text to be circles</source>
        <translation>Die Zwischenablage enthält zu viel Text, das sind keine Kreise</translation>
    </message>
    <message>
        <source>The clipboard holds no circles: %1</source>
        <translation>Die Zwischenablage enthält keine Kreise: %1</translation>
    </message>
    <message>
        <source>The scene on the clipboard has no circles</source>
        <translation>Die Szene in der Zwischenablage hat keine Kreise</translation>
    </message>
</context>
<context>
    <name>CircleName</name>
    <message>
        <source>circle %1</source>
        <translation>Kreis %1</translation>
    </message>
</context>
<context>
    <name>Cli</name>
    <message>
        <source>the step, like L42T5</source>
        <translation>der Schritt, etwa L42T5</translation>
    </message>
    <message>
        <source>of the scenes; 1 without it</source>
        <translation>Startwert für den Zufall der Szenen; ohne ihn 1</translation>
    </message>
    <message>
        <source>where to write; without it the terminal</source>
        <translation>wohin geschrieben wird; ohne sie ins Terminal</translation>
    </message>
    <message>
        <source>exit with 0 also if it did not pass</source>
        <translation>mit 0 enden, auch wenn nicht bestanden</translation>
    </message>
    <message>
        <source>--seed %1 is not a whole number</source>
        <translation>--seed %1 ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>the lab has no step %1; it has %2</source>
        <translation>das Lab hat keinen Schritt %1; es hat %2</translation>
    </message>
    <message>
        <source>%1: %2 circles, %3 steps, %4 s, %5 hits
momentum (%6, %7) kg m/s, kinetic %8 J, potential %9 J
</source>
        <translation>%1: %2 Kreise, %3 Schritte, %4 s, %5 Stöße
Impuls (%6, %7) kg m/s, kinetisch %8 J, potentiell %9 J
</translation>
    </message>
    <message>
        <source>the scene</source>
        <translation>die Szene</translation>
    </message>
    <message>
        <source>how long, s</source>
        <translation>wie lange, s</translation>
    </message>
    <message>
        <source>instead of the preset&apos;s, s</source>
        <translation>statt des Zeitschritts der Szene, s</translation>
    </message>
    <message>
        <source>discrete, continuous or exact</source>
        <translation>discrete, continuous oder exact</translation>
    </message>
    <message>
        <source>write every N-th step only</source>
        <translation>nur jeden N-ten Schritt schreiben</translation>
    </message>
    <message>
        <source>table of the circles&apos; states</source>
        <translation>Tabelle der Zustände der Kreise</translation>
    </message>
    <message>
        <source>table of momentum and energy</source>
        <translation>Tabelle von Impuls und Energie</translation>
    </message>
    <message>
        <source>table of the hits</source>
        <translation>Tabelle der Stöße</translation>
    </message>
    <message>
        <source>--duration S is missing: how long, in s?</source>
        <translation>--duration S fehlt: Wie lange, in s?</translation>
    </message>
    <message>
        <source>%1 steps are too many; at most %2 are right</source>
        <translation>%1 Schritte sind zu viele; richtig sind höchstens %2</translation>
    </message>
    <message>
        <source>an argument is missing; see %1 --help</source>
        <translation>ein Argument fehlt; siehe %1 --help</translation>
    </message>
    <message>
        <source>unexpected argument %1; see %2 --help</source>
        <translation>unerwartetes Argument %1; siehe %2 --help</translation>
    </message>
    <message>
        <source>--%1 %2 is not right; %3 is right</source>
        <translation>--%1 %2 ist nicht richtig; richtig ist %3</translation>
    </message>
    <message>
        <source>a number above 0 and at most %1</source>
        <translation>eine Zahl über 0 und höchstens %1</translation>
    </message>
    <message>
        <source>a whole number from 1</source>
        <translation>eine ganze Zahl ab 1</translation>
    </message>
    <message>
        <source>Judges a program, or with --preset alone the engine&apos;s laws, for one step: by what they do. A program that does not load or that stops does not pass; why is also on standard error, as FILE:LINE: message.</source>
        <translation>Prüft ein Programm, oder mit --preset allein die Gesetze der Engine, für einen Schritt: danach, was sie tun. Ein Programm, das sich nicht laden lässt oder das abbricht, besteht nicht; warum, steht auch in der Fehlerausgabe, als DATEI:ZEILE: Meldung.</translation>
    </message>
    <message>
        <source>the scene; without it that of the step</source>
        <translation>die Szene; ohne sie die des Schritts</translation>
    </message>
    <message>
        <source>one of %1; text without it</source>
        <translation>eines von %1; ohne Angabe text</translation>
    </message>
    <message>
        <source>SCRIPT.lua or --preset P.json is missing: what is to be judged?</source>
        <translation>SCRIPT.lua oder --preset P.json fehlt: Was soll geprüft werden?</translation>
    </message>
    <message>
        <source>unknown format %1; one of %2 is right</source>
        <translation>unbekanntes Format %1; richtig ist eines von %2</translation>
    </message>
    <message>
        <source>this is no text in UTF-8, which would be right</source>
        <translation>das ist kein Text in UTF-8, was richtig wäre</translation>
    </message>
    <message>
        <source>a program that moves the circles; what it prints goes to standard error, what it plots and draws is dropped, its hits are inferred</source>
        <translation>ein Programm, das die Kreise bewegt; was es mit print ausgibt, geht in die Fehlerausgabe, was es mit plot und draw zeichnet, fällt weg, seine Stöße werden erschlossen</translation>
    </message>
    <message>
        <source>Judges a lab itself: starters fail by a check, solutions pass, every known mistake fails and is recognised, and every check is failed by a mistake. Prints which mistake (row) fails which check (column, x) and what it is taken for.</source>
        <translation>Prüft ein Lab selbst: Startprogramme bestehen eine Prüfung nicht, Lösungen bestehen, jeder bekannte Fehler besteht nicht und wird erkannt, und an jeder Prüfung scheitert ein Fehler. Gibt aus, welcher Fehler (Zeile) an welcher Prüfung scheitert (Spalte, x) und wofür er gehalten wird.</translation>
    </message>
    <message>
        <source>this step alone</source>
        <translation>nur dieser Schritt</translation>
    </message>
    <message>
        <source>the lab&apos;s folder or NAME.cradle; without it the shipped lab</source>
        <translation>der Ordner des Labs oder NAME.cradle; ohne dies das mitgelieferte Lab</translation>
    </message>
    <message>
        <source>      passes every check
</source>
        <translation>      besteht jede Prüfung
</translation>
    </message>
    <message>
        <source>      fails %1 without a diagnosis: %2
</source>
        <translation>      scheitert an %1 ohne Diagnose: %2
</translation>
    </message>
    <message>
        <source>the lab&apos;s folder, or NAME.cradle</source>
        <translation>der Ordner des Labs oder NAME.cradle</translation>
    </message>
    <message>
        <source>the lab&apos;s folder or NAME.cradle; without it the shipped lab that the work belongs to</source>
        <translation>der Ordner des Labs oder NAME.cradle; sonst das mitgelieferte Lab, zu dem die Arbeit gehört</translation>
    </message>
    <message>
        <source>of the student</source>
        <translation>der Studentin oder des Studenten</translation>
    </message>
    <message>
        <source>to the teacher</source>
        <translation>an die Lehrkraft</translation>
    </message>
    <message>
        <source>where to write</source>
        <translation>wohin geschrieben wird</translation>
    </message>
    <message>
        <source>the application that prints PDF is not beside cradle-cli; F.html is right without it</source>
        <translation>die Anwendung, die PDF druckt, liegt nicht neben cradle-cli; ohne sie ist F.html richtig</translation>
    </message>
    <message>
        <source>the report could not be printed: %1</source>
        <translation>der Bericht konnte nicht gedruckt werden: %1</translation>
    </message>
    <message>
        <source>Writes the report of a student&apos;s work: what was asked, what the program does, how it came about. Every step is judged anew.</source>
        <translation>Schreibt den Bericht über die Arbeit: was gefragt war, was das Programm tut, wie es dazu kam. Jeder Schritt wird neu geprüft.</translation>
    </message>
    <message>
        <source>the folder, or a FILE.cradle-work</source>
        <translation>der Ordner, oder DATEI.cradle-work</translation>
    </message>
    <message>
        <source>--output F.pdf or --output F.html is right</source>
        <translation>richtig ist --output F.pdf oder --output F.html</translation>
    </message>
    <message>
        <source>Writes a student&apos;s work into one file to be handed in: the programs, scenes, notes, the history and a report. Every step is judged once more.</source>
        <translation>Schreibt die Arbeit in eine Datei zum Abgeben: die Programme, Szenen, Notizen, den Verlauf und einen Bericht. Jeder Schritt wird noch einmal geprüft.</translation>
    </message>
    <message>
        <source>the folder</source>
        <translation>der Ordner</translation>
    </message>
    <message>
        <source>--output FILE.cradle-work is right</source>
        <translation>richtig ist --output DATEI.cradle-work</translation>
    </message>
    <message>
        <source>this is too long for a program; at most %1 are right</source>
        <translation>das ist zu lang für ein Programm; richtig sind höchstens %1</translation>
    </message>
    <message>
        <source>this is text in UTF-16; UTF-8 would be right</source>
        <translation>das ist Text in UTF-16; richtig wäre UTF-8</translation>
    </message>
    <message>
        <source>the program to judge; - is standard input</source>
        <translation>das zu beurteilende Programm; - ist die Standardeingabe</translation>
    </message>
    <message>
        <source>judge only where rlimits, seccomp and namespaces are to be had</source>
        <translation>nur beurteilen, wo es rlimits, seccomp und Namensräume gibt</translation>
    </message>
    <message>
        <source>left out of the zip: %1</source>
        <translation>aus dem Zip ausgelassen: %1</translation>
    </message>
    <message>
        <source>the results may not go where the submissions are</source>
        <translation>die Ergebnisse dürfen nicht dorthin, wo die Abgaben sind</translation>
    </message>
    <message>
        <source>there is no folder %1</source>
        <translation>es gibt keinen Ordner %1</translation>
    </message>
    <message>
        <source>a secret was made for the scenes of this class: %1; keep it, and publish it to nobody</source>
        <translation>für die Szenen dieses Kurses wurde ein Geheimnis gemacht: %1; bewahre es auf und gib es niemandem</translation>
    </message>
    <message>
        <source>the lab</source>
        <translation>das Lab</translation>
    </message>
    <message>
        <source>the secret</source>
        <translation>das Geheimnis</translation>
    </message>
    <message>
        <source>--require-isolation: this machine has only: %1</source>
        <translation>--require-isolation: Dieser Rechner hat nur: %1</translation>
    </message>
    <message>
        <source>%1 holds results of another version (%2); another folder is right, or --again to begin anew</source>
        <translation>%1 enthält Ergebnisse einer anderen Fassung (%2); richtig ist ein anderer Ordner, oder --again, um neu zu beginnen</translation>
    </message>
    <message>
        <source>the shard</source>
        <translation>der Teil</translation>
    </message>
    <message>
        <source>nothing to judge</source>
        <translation>nichts zu beurteilen</translation>
    </message>
    <message>
        <source>missing: %1 %2</source>
        <translation>fehlt: %1 %2</translation>
    </message>
    <message>
        <source>none of the folders has the lab; --lab LAB is right</source>
        <translation>keiner der Ordner hat das Lab; richtig ist --lab LAB</translation>
    </message>
    <message>
        <source>the results were judged by another version of the lab</source>
        <translation>die Ergebnisse wurden nach einer anderen Fassung des Labs beurteilt</translation>
    </message>
    <message>
        <source>the results of all may not go where those of a shard are</source>
        <translation>die Ergebnisse aller dürfen nicht dorthin, wo die eines Teils sind</translation>
    </message>
    <message>
        <source>%1 holds results of another version; another folder is right, or --again to begin anew</source>
        <translation>%1 enthält Ergebnisse einer anderen Fassung; richtig ist ein anderer Ordner, oder --again, um neu zu beginnen</translation>
    </message>
    <message>
        <source>isolation: %1</source>
        <translation>Isolation: %1</translation>
    </message>
    <message>
        <source>%1 of %2 students</source>
        <translation>%1 von %2 Studierenden</translation>
    </message>
    <message>
        <source>, %1 a minute, %2 left</source>
        <translation>, %1 in der Minute, noch %2</translation>
    </message>
    <message>
        <source>, %1 steps not passed</source>
        <translation>, %1 Schritte nicht bestanden</translation>
    </message>
    <message>
        <source>, %1 not graded</source>
        <translation>, %1 nicht bewertet</translation>
    </message>
    <message>
        <source>%1 of %2 students, %3 of them as they were before; steps: %4 passed, %5 not passed, %6 not graded; %7</source>
        <translation>%1 von %2 Studierenden, davon %3 wie zuvor; Schritte: %4 bestanden, %5 nicht bestanden, %6 nicht bewertet; %7</translation>
    </message>
    <message>
        <source>the folder of the results</source>
        <translation>der Ordner der Ergebnisse</translation>
    </message>
    <message>
        <source>from which, with the id, each student&apos;s scenes follow; without it one is made and kept in RESULTS/secret.txt</source>
        <translation>daraus und aus der Kennung folgen die Szenen jedes Studierenden; ohne wird eines gemacht und in ERGEBNISSE/secret.txt aufbewahrt</translation>
    </message>
    <message>
        <source>students at a time; without it as many as processors</source>
        <translation>Studierende zugleich; ohne so viele wie Prozessoren</translation>
    </message>
    <message>
        <source>who is in the class: a table with columns id, folder, name, number, email, late days</source>
        <translation>wer im Kurs ist: eine Tabelle mit den Spalten id, folder, name, number, email, late days</translation>
    </message>
    <message>
        <source>what each late day takes of the points; 0 without it</source>
        <translation>was jeder Tag Verspätung an Punkten nimmt; ohne 0</translation>
    </message>
    <message>
        <source>more percent are never taken; 100 without it</source>
        <translation>mehr Prozent werden nie genommen; ohne 100</translation>
    </message>
    <message>
        <source>judge part I of N of the class, for --merge</source>
        <translation>Teil I von N des Kurses beurteilen, für --merge</translation>
    </message>
    <message>
        <source>judge nothing; put together the results of shards, each a folder</source>
        <translation>nichts beurteilen; die Ergebnisse von Teilen zusammenfügen, jeder ein Ordner</translation>
    </message>
    <message>
        <source>tell how the folder was understood, and judge nothing</source>
        <translation>sagen, wie der Ordner verstanden wurde, und nichts beurteilen</translation>
    </message>
    <message>
        <source>begin anew where RESULTS holds those of another version</source>
        <translation>neu beginnen, wo ERGEBNISSE die einer anderen Fassung enthält</translation>
    </message>
    <message>
        <source>text, or json: events on standard output, one a line</source>
        <translation>text oder json: Ereignisse auf der Standardausgabe, eines je Zeile</translation>
    </message>
    <message>
        <source>exit with 0 also if somebody did not pass, if only all are graded</source>
        <translation>mit 0 enden, auch wenn jemand nicht bestanden hat, wenn nur alle bewertet sind</translation>
    </message>
    <message>
        <source>--jobs %1: a number from 1 to %2 is right</source>
        <translation>--jobs %1: Richtig ist eine Zahl von 1 bis %2</translation>
    </message>
    <message>
        <source>--shard %1: I/N is right, with I from 1 to N</source>
        <translation>--shard %1: Richtig ist I/N, mit I von 1 bis N</translation>
    </message>
    <message>
        <source>--shard needs --secret FILE, the same for every shard</source>
        <translation>--shard braucht --secret DATEI, für jeden Teil dieselbe</translation>
    </message>
    <message>
        <source>--late-percent and --late-most are numbers from 0 to 100</source>
        <translation>--late-percent und --late-most sind Zahlen von 0 bis 100</translation>
    </message>
    <message>
        <source>Judges a class: every step of every student, each in a process of its own that can do nothing else. SUBMISSIONS is a folder of folders or of .cradle-work files, a download of Moodle, Canvas or Blackboard, clones of GitHub Classroom, or a zip of any of these; nothing in it is written. Stopped at any time it goes on where it was. Exit status: 1 if not all passed.</source>
        <translation>Beurteilt einen Kurs: jeden Schritt aller Studierenden, jeden in einem eigenen Prozess, der nichts anderes kann. SUBMISSIONS ist ein Ordner aus Ordnern oder .cradle-work-Dateien, ein Download von Moodle, Canvas oder Blackboard, Klone von GitHub Classroom oder ein Zip von alledem; nichts darin wird geschrieben. Jederzeit angehalten geht es dort weiter, wo es war. Endstatus: 1, wenn nicht alle bestanden haben.</translation>
    </message>
    <message>
        <source>what was handed in; with --merge: results</source>
        <translation>was abgegeben wurde; mit --merge: Ergebnisse</translation>
    </message>
    <message>
        <source>--out RESULTS is missing: where are the results to go?</source>
        <translation>--out ERGEBNISSE fehlt: Wohin sollen die Ergebnisse?</translation>
    </message>
    <message>
        <source>there is no verdict; of the process that judged: %1</source>
        <translation>es gibt kein Urteil; vom Prozess, der urteilte: %1</translation>
    </message>
    <message>
        <source>this is a folder; a file is right</source>
        <translation>das ist ein Ordner; richtig ist eine Datei</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>programs: %1</source>
        <translation>Programme: %1</translation>
    </message>
    <message>
        <source>students: %1</source>
        <translation>Studierende: %1</translation>
    </message>
    <message>
        <source>%1 programs became differences, %2 lines fewer</source>
        <translation>%1 Programme wurden Unterschiede, %2 Zeilen weniger</translation>
    </message>
    <message>
        <source>keep mistakes and remarks as differences from their solution where that is shorter</source>
        <translation>bewahrt Fehler und Anmerkungen als Unterschiede zur Lösung auf, wo das kürzer ist</translation>
    </message>
    <message>
        <source>also ask of every check whether some change of the solution fails by it alone; takes minutes</source>
        <translation>fragt bei jeder Prüfung auch, ob eine Änderung der Lösung an ihr allein scheitert; dauert Minuten</translation>
    </message>
    <message>
        <source>It was stopped after %1 s of processor time.</source>
        <translation>Er wurde nach %1 s Rechenzeit angehalten.</translation>
    </message>
    <message>
        <source>It was stopped: it asked the system for what no program needs.</source>
        <translation>Er wurde angehalten: Er verlangte vom System, was kein Programm braucht.</translation>
    </message>
    <message>
        <source>The process that judged it broke down.</source>
        <translation>Der Prozess, der ihn beurteilte, ist zusammengebrochen.</translation>
    </message>
    <message>
        <source>No process could be had to judge it.</source>
        <translation>Es gab keinen Prozess, der ihn beurteilen konnte.</translation>
    </message>
    <message>
        <source>of the report, such as en or de; without it that of the system</source>
        <translation>des Berichts, etwa en oder de; ohne diese Angabe die des Systems</translation>
    </message>
    <message>
        <source>--language %1: one of %2 is right</source>
        <translation>--language %1: Richtig ist eines von %2</translation>
    </message>
    <message>
        <source>an object with an answer for each id of a question is right</source>
        <translation>richtig ist ein Objekt mit einer Antwort zu jeder Kennung einer Frage</translation>
    </message>
    <message>
        <source>the answers to the step&apos;s questions: {&quot;ID&quot;: ANSWER}</source>
        <translation>die Antworten auf die Fragen des Schritts: {&quot;KENNUNG&quot;: ANTWORT}</translation>
    </message>
    <message>
        <source>number of the student for whom the lab draws its values</source>
        <translation>Nummer der Person, für die das Lab seine Werte zieht</translation>
    </message>
    <message>
        <source>the language</source>
        <translation>die Sprache</translation>
    </message>
    <message>
        <source>--language %1: the results are in the language %2, in which they were judged</source>
        <translation>--language %1: Die Ergebnisse sind in der Sprache %2, in der geurteilt wurde</translation>
    </message>
    <message>
        <source>of the pages and of what students are told, such as en or de; en without it</source>
        <translation>der Seiten und dessen, was Studierende lesen, etwa en oder de; ohne dies en</translation>
    </message>
    <message>
        <source>Runs a scene, by its laws or by a program, and writes what happens: tables, or without any a summary. If the program stops, why is on standard error as FILE:LINE: message, the tables reach up to there, and the exit status is 1. Ctrl+C ends the run: what is written reaches up to there, and the exit status is 130.</source>
        <translation>Lässt eine Szene laufen, nach ihren Gesetzen oder mit einem Programm, und schreibt, was geschieht: Tabellen, oder ohne sie eine Zusammenfassung. Bricht das Programm ab, so steht in der Fehlerausgabe, warum, als DATEI:ZEILE: Meldung; die Tabellen reichen bis dorthin, und der Rückgabewert ist 1. Strg+C beendet den Lauf: Was geschrieben wird, reicht bis dorthin, und der Rückgabewert ist 130.</translation>
    </message>
    <message>
        <source>stopped at %1 s</source>
        <translation>angehalten bei %1 s</translation>
    </message>
    <message>
        <source>%1 % of the run; Ctrl+C ends it here</source>
        <translation>%1 % des Laufs; Strg+C beendet ihn hier</translation>
    </message>
    <message>
        <source>of the summary: text, or json, which is written beside tables, too</source>
        <translation>der Zusammenfassung: text, oder json, das auch neben Tabellen geschrieben wird</translation>
    </message>
    <message>
        <source>a table and the summary cannot both go to standard output; a file for the table is right</source>
        <translation>eine Tabelle und die Zusammenfassung können nicht beide in die Standardausgabe; richtig ist eine Datei für die Tabelle</translation>
    </message>
    <message>
        <source>contacts merged from %1 s on</source>
        <translation>Kontakte ab %1 s zusammengefasst</translation>
    </message>
    <message>
        <source>with how many seeds every solution is judged, 1 to 1000</source>
        <translation>mit wie vielen Startwerten jede Lösung beurteilt wird, 1 bis 1000</translation>
    </message>
    <message>
        <source>--seeds takes a whole number from 1 to 1000, not %1</source>
        <translation>--seeds nimmt eine ganze Zahl von 1 bis 1000, nicht %1</translation>
    </message>
    <message>
        <source>Writes a lab into one file. For students it leaves out solutions, mistakes, remarks and files that no step uses; what checks and questions ask for stays.</source>
        <translation>Schreibt ein Lab in eine Datei. Für Studierende lässt es Lösungen, Fehler, Anmerkungen und Dateien weg, die kein Schritt verwendet; was Prüfungen und Fragen verlangen, bleibt.</translation>
    </message>
    <message>
        <source>leave out what students shall find</source>
        <translation>weglassen, was Studierende selbst finden sollen</translation>
    </message>
    <message>
        <source>the file to write; needed</source>
        <translation>die Datei, die geschrieben wird; nötig</translation>
    </message>
    <message>
        <source>--output is missing: the file to write</source>
        <translation>--output fehlt: die Datei, die geschrieben wird</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) left out</source>
        <translation>
            <numerusform>%n Datei weggelassen</numerusform>
            <numerusform>%n Dateien weggelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>students are told what checks saw, and not which law is wrong, in %1: these checks tell no law</source>
        <translation>In %1 erfahren Studierende, was Prüfungen sahen, und nicht, welches Gesetz falsch ist: Diese Prüfungen nennen keines</translation>
    </message>
    <message>
        <source>this is an edition for students, without the solutions and mistakes that prove a lab; the whole lab is right</source>
        <translation>dies ist eine Ausgabe für Studierende, ohne die Lösungen und Fehler, mit denen ein Lab nachgewiesen wird; richtig ist das ganze Lab</translation>
    </message>
    <message>
        <source>there is nothing of that name; the name of something new must be UTF-8</source>
        <translation>es gibt nichts, was so heißt; der Name von etwas Neuem muss UTF-8 sein</translation>
    </message>
    <message>
        <source>writing, %1 of %2</source>
        <translation>schreibt, %1 von %2</translation>
    </message>
    <message>
        <source>of what the student is told, such as en or de; en without it</source>
        <translation>dessen, was Studierende lesen, etwa en oder de; ohne dies en</translation>
    </message>
    <message>
        <source>the step %1 cannot be read; why is said above</source>
        <translation>der Schritt %1 ist nicht lesbar; warum, steht darüber</translation>
    </message>
    <message>
        <source>of files of a lab that draws values: those of the student with this number</source>
        <translation>bei Dateien eines Labs, das Werte zieht: die der Person mit dieser Nummer</translation>
    </message>
    <message>
        <source>      fails %1; what is measured tells: %2
</source>
        <translation>      scheitert an %1; das Gemessene sagt: %2
</translation>
    </message>
    <message>
        <source>Makes mistakes that students make out of the solutions of a lab, and names those that pass every check (a check may be missing), those that fail without a diagnosis (a mistake may be missing), and those of which a law that is measured tells.</source>
        <translation>Macht aus den Lösungen eines Labs Fehler, wie sie gemacht werden, und nennt die, die jede Prüfung bestehen (vielleicht fehlt eine Prüfung), die, die ohne Diagnose scheitern (vielleicht fehlt ein Fehler), und die, von denen ein gemessenes Gesetz erzählt.</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n Schritt</numerusform>
            <numerusform>%n Schritte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mistakes</source>
        <translation>
            <numerusform>%n Fehler</numerusform>
            <numerusform>%n Fehler</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problems</source>
        <translation>
            <numerusform>%n Problem</numerusform>
            <numerusform>%n Probleme</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>the folder %1 is no step: lab.json does not list it
</source>
        <translation>der Ordner %1 ist kein Schritt: lab.json führt ihn nicht auf
</translation>
    </message>
    <message>
        <source>Values of students that were tried:
</source>
        <translation>Werte, die ausprobiert wurden:
</translation>
    </message>
    <message>
        <source>%1 is written: %2 of %3 steps passed</source>
        <translation>%1 ist geschrieben: %2 von %3 Schritten bestanden</translation>
    </message>
</context>
<context>
    <name>Deviation</name>
    <message>
        <source>%1 m</source>
        <comment>a distance</comment>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>up to %1 m (rms %2 m)</source>
        <translation>bis zu %1 m (quadr. Mittel %2 m)</translation>
    </message>
    <message>
        <source>%1 J</source>
        <comment>an energy, with its sign</comment>
        <translation>%1 J</translation>
    </message>
    <message>
        <source>Off the exact motion: %1, %2.</source>
        <comment>energy, distance</comment>
        <translation>Neben der exakten Bewegung: %1, %2.</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>A thousand equal circles start with the same speed, 2 m/s, in all directions. Press Run and watch the speeds at the bottom right.

No hit is aimed at anything, yet within a second or two the speeds spread until they lie along one curve, that of Maxwell and Boltzmann. No energy is lost: only how the circles share it changes.

- Go back on the timeline: the curve is the same all the time, as it depends on the mean energy alone.
- Set the restitution to 0.99: the gas cools, and the curve moves to the left.
- The colours say which half a circle comes from. They mix much more slowly than the speeds.</source>
        <translation>Tausend gleiche Kreise starten mit demselben Tempo, 2 m/s, in alle Richtungen. Drücke „Starten“ und sieh unten rechts das Tempo an.

Kein Stoß zielt auf etwas, und doch verteilt sich das Tempo in ein, zwei Sekunden so, dass es auf einer Kurve liegt, der von Maxwell und Boltzmann. Energie geht keine verloren: Nur wie die Kreise sie teilen, ändert sich.

- Geh auf der Zeitleiste zurück: Die Kurve ist immer dieselbe, denn sie hängt nur von der mittleren Energie ab.
- Setze die Stoßzahl auf 0.99: Das Gas kühlt ab, und die Kurve rückt nach links.
- Die Farben sagen, aus welcher Hälfte ein Kreis kommt. Sie mischen sich viel langsamer als das Tempo.</translation>
    </message>
    <message>
        <source>Gas</source>
        <translation>Gas</translation>
    </message>
    <message>
        <source>Piston drop</source>
        <translation>Fallender Kolben</translation>
    </message>
    <message>
        <source>This scene belongs to no step. Choose a step above to go back to the lab.</source>
        <translation>Diese Szene gehört zu keinem Schritt. Wähle oben einen Schritt, um zum Lab zurückzukehren.</translation>
    </message>
    <message>
        <source>A heavy circle falls onto a bed of 124 light ones, each of which has a six-thousandth of its mass. Press Run and watch the energy.

A hit with e = 0.9 leaves e² = 81 % of the energy of the motion towards each other. Yet here a fifth of all energy goes in less than a tenth of a second, most of it in two blows, at 0.94 s and 0.99 s: light circles that are caught between the heavy one and the floor are hit to and fro ever faster, hundreds of times in a hundredth of a second. That is how an inelastic collapse begins.

- Go back on the timeline to the blows, and step through them with → and ←.
- Set the restitution to 1: the bed becomes a gas under a piston, and throws it back.</source>
        <translation>Ein schwerer Kreis fällt auf ein Bett aus 124 leichten, von denen jeder ein Sechstausendstel seiner Masse hat. Drücke „Starten“ und sieh die Energie an.

Ein Stoß mit e = 0.9 lässt e² = 81 % der Energie der Bewegung aufeinander zu. Und doch geht hier in weniger als einer Zehntelsekunde ein Fünftel aller Energie, das meiste auf zwei Schläge, bei 0.94 s und 0.99 s: Leichte Kreise, die zwischen dem schweren und dem Boden gefangen sind, werden immer schneller hin und her gestoßen, hunderte Male in einer Hundertstelsekunde. So beginnt ein inelastischer Kollaps.

- Geh auf der Zeitleiste zu den Schlägen zurück und mit → und ← Schritt für Schritt hindurch.
- Setze die Stoßzahl auf 1: Das Bett wird zu einem Gas unter einem Kolben und wirft ihn zurück.</translation>
    </message>
</context>
<context>
    <name>Expression</name>
    <message>
        <source>“%1” is not expected there</source>
        <translation>„%1“ wird dort nicht erwartet</translation>
    </message>
    <message>
        <source>it comes to no finite number</source>
        <translation>es ergibt keine endliche Zahl</translation>
    </message>
    <message>
        <source>“%1” is no number: %2</source>
        <translation>„%1“ ist keine Zahl: %2</translation>
    </message>
    <message>
        <source>it is too deep</source>
        <translation>es ist zu tief verschachtelt</translation>
    </message>
    <message>
        <source>a closing parenthesis is missing</source>
        <translation>es fehlt eine schließende Klammer</translation>
    </message>
    <message>
        <source>something is missing at its end</source>
        <translation>am Ende fehlt etwas</translation>
    </message>
    <message>
        <source>there is no value called %1</source>
        <translation>es gibt keinen Wert namens %1</translation>
    </message>
    <message>
        <source>a parenthesis behind %1 is missing</source>
        <translation>hinter %1 fehlt eine Klammer</translation>
    </message>
    <message>
        <source>a comma and another number are missing</source>
        <translation>es fehlen ein Komma und noch eine Zahl</translation>
    </message>
    <message>
        <source>an expression of at most %1 characters is right</source>
        <translation>richtig ist ein Ausdruck von höchstens %1 Zeichen</translation>
    </message>
    <message>
        <source>%1 and %2 stand side by side</source>
        <translation>%1 und %2 stehen nebeneinander</translation>
    </message>
    <message>
        <source>a power with that unit is none</source>
        <translation>eine Potenz mit dieser Einheit gibt es nicht</translation>
    </message>
    <message>
        <source>there is a unit too many</source>
        <translation>eine Einheit ist zu viel</translation>
    </message>
    <message>
        <source>%1 is taken of a number without a unit, not of one in %2</source>
        <translation>%1 nimmt man von einer Zahl ohne Einheit, nicht von einer in %2</translation>
    </message>
    <message>
        <source>it is in %1; %2 is right here</source>
        <translation>es ist in %1; richtig ist hier %2</translation>
    </message>
</context>
<context>
    <name>FileIo</name>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>your share of the disk is full</source>
        <translation>dein Anteil am Datenträger ist voll</translation>
    </message>
    <message>
        <source>a file may not be so large here</source>
        <translation>eine Datei darf hier nicht so groß sein</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>der Datenträger lässt sich nur lesen</translation>
    </message>
    <message>
        <source>you may not write here</source>
        <translation>hier darf nicht geschrieben werden</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>a file is where a folder should be</source>
        <translation>wo ein Ordner sein soll, ist eine Datei</translation>
    </message>
    <message>
        <source>this is a folder; the name of a file is right</source>
        <translation>das ist ein Ordner; richtig ist der Name einer Datei</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>der Name ist zu lang</translation>
    </message>
    <message>
        <source>the disk has a fault</source>
        <translation>der Datenträger hat einen Fehler</translation>
    </message>
    <message>
        <source>it is closed</source>
        <translation>sie ist geschlossen</translation>
    </message>
</context>
<context>
    <name>Findings</name>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>Rims touch where the centres are r₁ + r₂ apart, here %1 m.</source>
        <translation>Die Ränder berühren sich, wo die Mittelpunkte r₁ + r₂ auseinander sind, hier %1 m.</translation>
    </message>
    <message>
        <source>Only half of r₁ + r₂ counts in the test of contact</source>
        <translation>Im Test auf Berührung zählt nur die Hälfte von r₁ + r₂</translation>
    </message>
    <message>
        <source>The circles answer only when their centres have met</source>
        <translation>Die Kreise antworten erst, wenn ihre Mittelpunkte sich getroffen haben</translation>
    </message>
    <message>
        <source>Boxes are compared, not circles</source>
        <translation>Kästen werden verglichen, nicht Kreise</translation>
    </message>
    <message>
        <source>Side by side they answer in time, but on a diagonal when their centres are still %2 m apart: x and y each on its own ask for squares. Make one distance out of the two differences.</source>
        <translation>Nebeneinander antworten sie rechtzeitig, auf einer Diagonalen aber schon, wenn ihre Mittelpunkte noch %2 m auseinander sind: Wer nach x und y je für sich fragt, fragt nach Quadraten. Mach aus den beiden Differenzen einen einzigen Abstand.</translation>
    </message>
    <message>
        <source>|Δx| + |Δy| is not the distance</source>
        <translation>|Δx| + |Δy| ist nicht der Abstand</translation>
    </message>
    <message>
        <source>Side by side they answer in time, but on a diagonal only when their centres are %2 m apart. A distance is the root of the sum of the squares.</source>
        <translation>Nebeneinander antworten sie rechtzeitig, auf einer Diagonalen aber erst, wenn ihre Mittelpunkte %2 m auseinander sind. Ein Abstand ist die Wurzel aus der Summe der Quadrate.</translation>
    </message>
    <message>
        <source>A squared distance is compared with a length</source>
        <translation>Ein Quadrat eines Abstands wird mit einer Länge verglichen</translation>
    </message>
    <message>
        <source>Contact is tested at %1, not at r₁ + r₂</source>
        <translation>Als Abstand der Berührung gilt %1, nicht r₁ + r₂</translation>
    </message>
    <message>
        <source>the larger radius</source>
        <translation>der größere Radius</translation>
    </message>
    <message>
        <source>the smaller radius</source>
        <translation>der kleinere Radius</translation>
    </message>
    <message>
        <source>the difference of the radii</source>
        <translation>die Differenz der Radien</translation>
    </message>
    <message>
        <source>twice the larger radius</source>
        <translation>das Doppelte des größeren Radius</translation>
    </message>
    <message>
        <source>the sum of the diameters</source>
        <translation>die Summe der Durchmesser</translation>
    </message>
    <message>
        <source>The circles run through each other</source>
        <translation>Die Kreise gehen durcheinander hindurch</translation>
    </message>
    <message>
        <source>The circles act on each other</source>
        <translation>Die Kreise wirken aufeinander</translation>
    </message>
    <message>
        <source>In this step they should still pass through each other.</source>
        <translation>In diesem Schritt sollen sie noch durcheinander hindurchgehen.</translation>
    </message>
    <message>
        <source>Where they overlapped, your program put circle %1 elsewhere than its velocity takes it. In this step they should still pass through each other.</source>
        <translation>Wo sie sich überlappten, setzte dein Programm Kreis %1 anderswohin, als seine Geschwindigkeit ihn bringt. In diesem Schritt sollen sie noch durcheinander hindurchgehen.</translation>
    </message>
    <message>
        <source>The circles are answered long after they meet</source>
        <translation>Die Kreise antworten lange, nachdem sie sich treffen</translation>
    </message>
    <message>
        <source>Circles that overlap at the start of a run and move apart are not answered at once. Look at what is asked before they answer, and at what your program counts, or keeps from one step to the next.</source>
        <translation>Kreise, die sich am Anfang eines Laufs überlappen und sich voneinander entfernen, antworten nicht sofort. Sieh dir an, was gefragt wird, bevor sie antworten, und was dein Programm zählt oder von einem Schritt zum nächsten aufbewahrt.</translation>
    </message>
    <message>
        <source>The circles answer when they part, not when they meet</source>
        <translation>Die Kreise antworten, wenn sie sich entfernen, nicht, wenn sie sich treffen</translation>
    </message>
    <message>
        <source>They ran into each other until their centres were %1 m apart, and were answered in the step in which these passed each other; circles that overlap and move apart are not answered. Rims touch where the centres are r₁ + r₂ apart: look at what their distance is compared with.</source>
        <translation>Sie liefen ineinander, bis ihre Mittelpunkte %1 m auseinander waren, und bekamen ihre Antwort in dem Schritt, in dem diese aneinander vorbeikamen; Kreise, die sich überlappen und auseinanderlaufen, bekommen keine. Ränder berühren sich, wo die Mittelpunkte r₁ + r₂ auseinander sind: Sieh nach, womit ihr Abstand verglichen wird.</translation>
    </message>
    <message>
        <source>The circles answer where their centres meet</source>
        <translation>Die Kreise antworten, wo sich ihre Mittelpunkte treffen</translation>
    </message>
    <message>
        <source>With r₁ = %1 m and r₂ = %2 m, met at %3°, they answered when their centres were between %4 and %5 m apart.</source>
        <translation>Mit r₁ = %1 m und r₂ = %2 m antworteten sie bei einem Treffen unter %3°, als ihre Mittelpunkte zwischen %4 und %5 m auseinander waren.</translation>
    </message>
    <message>
        <source>The test of contact acts as if a number stood for r₁ + r₂</source>
        <translation>Der Test auf Berührung wirkt, als stünde eine Zahl für r₁ + r₂</translation>
    </message>
    <message>
        <source>The circles answer before they touch</source>
        <translation>Die Kreise antworten, bevor sie sich berühren</translation>
    </message>
    <message>
        <source>The circles answer too late</source>
        <translation>Die Kreise antworten zu spät</translation>
    </message>
    <message>
        <source>A hit puts circle %1 somewhere else

When they touched it was put to %2 m, far from where it came from. Each circle goes back to its *own* old place: look at which one it gets.</source>
        <translation>Ein Stoß versetzt Kreis %1

Als sie sich berührten, wurde er auf %2 m gesetzt, weit von dort, woher er kam. Jeder Kreis geht an seinen *eigenen* alten Ort zurück: Sieh nach, welchen er bekommt.</translation>
    </message>
    <message>
        <source>Nothing happens when it is circle 2 that comes nearer</source>
        <translation>Nichts geschieht, wenn es Kreis 2 ist, der näher kommt</translation>
    </message>
    <message>
        <source>A later hit is not answered</source>
        <translation>Ein späterer Stoß wird nicht beantwortet</translation>
    </message>
    <message>
        <source>Circles that already part are hit again</source>
        <translation>Kreise, die sich schon entfernen, werden noch einmal gestoßen</translation>
    </message>
    <message>
        <source>They overlapped and moved apart with %1 m/s; the next step turned them to %2 and %3 m/s.</source>
        <translation>Sie überlappten und entfernten sich mit %1 m/s; der nächste Schritt machte daraus %2 und %3 m/s.</translation>
    </message>
    <message>
        <source>They moved apart with %1 m/s, with %4 m between their rims; the next step turned them to %2 and %3 m/s.</source>
        <translation>Sie entfernten sich mit %1 m/s, mit %4 m zwischen ihren Rändern; der nächste Schritt machte daraus %2 und %3 m/s.</translation>
    </message>
    <message>
        <source>Circles that move apart have had their hit: ask whether they come nearer.</source>
        <translation>Kreise, die sich entfernen, hatten ihren Stoß schon: Frag, ob sie sich nähern.</translation>
    </message>
    <message>
        <source>A run that begins so leaves them alone: look at what your program keeps from one step to the next.</source>
        <translation>Ein Lauf, der so beginnt, lässt sie in Ruhe: Sieh nach, was dein Programm von einem Schritt zum nächsten aufbewahrt.</translation>
    </message>
    <message>
        <source>circle %1</source>
        <translation>Kreis %1</translation>
    </message>
    <message>
        <source>both circles</source>
        <translation>beide Kreise</translation>
    </message>
    <message>
        <source>all circles</source>
        <translation>alle Kreise</translation>
    </message>
    <message>
        <source>the circles %1</source>
        <translation>die Kreise %1</translation>
    </message>
    <message>
        <source>The velocity of %who is set anew in every step</source>
        <translation>Für %who wird die Geschwindigkeit in jedem Schritt neu gesetzt</translation>
    </message>
    <message>
        <source>The velocity of circle %1 moves %who</source>
        <translation>Die Geschwindigkeit von Kreis %1 bewegt %who</translation>
    </message>
    <message>
        <source>The velocity of %who at the start is not taken over</source>
        <translation>Die Geschwindigkeit beim Start wird nicht übernommen, für %who</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later, and so it has from every other start tried; later steps go on from that.</source>
        <translation>Mit %1 m/s gestartet, hat er einen Schritt später %2 m/s, und ebenso bei jedem anderen versuchten Start; spätere Schritte gehen davon weiter.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later; one part is the same from every other start tried, and later steps go on from that.</source>
        <translation>Mit %1 m/s gestartet, hat er einen Schritt später %2 m/s; ein Teil ist bei jedem anderen versuchten Start derselbe, und spätere Schritte gehen davon weiter.</translation>
    </message>
    <message>
        <source>A run begins with the velocity that the circle has then: look at which one your program begins with instead.</source>
        <translation>Ein Lauf beginnt mit der Geschwindigkeit, die der Kreis dann hat: Sieh nach, mit welcher dein Programm stattdessen beginnt.</translation>
    </message>
    <message>
        <source>The place of %who at the start is not taken over</source>
        <translation>Der Ort beim Start wird nicht übernommen, für %who</translation>
    </message>
    <message>
        <source>Started at rest at two places, it is at one and the same place two steps later; the second step goes on from where the first one ends. A run begins where the circle is then: look at which place your program begins with instead.</source>
        <translation>An zwei Orten in Ruhe gestartet, ist er zwei Schritte später an ein und demselben Ort; der zweite Schritt geht von dort weiter, wo der erste endet. Ein Lauf beginnt, wo der Kreis dann ist: Sieh nach, mit welchem Ort dein Programm stattdessen beginnt.</translation>
    </message>
    <message>
        <source>A step of %who does %1 times what it should</source>
        <translation>Ein Schritt bewirkt das %1-Fache von dem, was er soll, für %who</translation>
    </message>
    <message>
        <source>x and y of the velocity of %who are exchanged</source>
        <translation>x und y der Geschwindigkeit sind vertauscht, für %who</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it goes %2 m in the first step of %3 s and has %4 m/s after it. Each part of the velocity goes on from itself: look at the line that writes it down.</source>
        <translation>Mit %1 m/s gestartet, legt er im ersten Schritt von %3 s %2 m zurück und hat danach %4 m/s. Jeder Teil der Geschwindigkeit geht von sich selbst weiter: Sieh die Zeile an, die sie hinschreibt.</translation>
    </message>
    <message>
        <source>The velocity of %who at the start is not taken over whole</source>
        <translation>Die Geschwindigkeit beim Start wird nicht ganz übernommen, für %who</translation>
    </message>
    <message>
        <source>The new place of %who does not depend on the old one</source>
        <translation>Für %who hängt der neue Ort nicht vom alten ab</translation>
    </message>
    <message>
        <source>The way of %who is not multiplied by the timestep</source>
        <translation>Für %who wird der Weg nicht mit dem Zeitschritt multipliziert</translation>
    </message>
    <message>
        <source>A velocity says how far it gets in a whole second; a step lasts only Δt.</source>
        <translation>Eine Geschwindigkeit sagt, wie weit ein Kreis in einer ganzen Sekunde kommt; ein Schritt dauert nur Δt.</translation>
    </message>
    <message>
        <source>The way of %who is multiplied by the timestep twice</source>
        <translation>Für %who wird der Weg zweimal mit dem Zeitschritt multipliziert</translation>
    </message>
    <message>
        <source>Count how often the timestep stands in the line that moves it.</source>
        <translation>Zähle, wie oft der Zeitschritt in der Zeile steht, die den Kreis bewegt.</translation>
    </message>
    <message>
        <source>A fixed number stands for the timestep in the way of %who</source>
        <translation>Für %who hängt der zurückgelegte Weg von einer festen Zahl ab statt vom Zeitschritt</translation>
    </message>
    <message>
        <source>The way of %who in a step is not v Δt</source>
        <translation>Für %who ist der Weg eines Schritts nicht v Δt</translation>
    </message>
    <message>
        <source>Look at the line that changes the position.</source>
        <translation>Sieh dir die Zeile an, die den Ort ändert.</translation>
    </message>
    <message>
        <source>The way of %who is subtracted instead of added</source>
        <translation>Für %who wird der Weg abgezogen statt addiert</translation>
    </message>
    <message>
        <source>Look at the sign in the line that moves it.</source>
        <translation>Sieh dir das Vorzeichen in der Zeile an, die den Kreis bewegt.</translation>
    </message>
    <message>
        <source>Every step moves %who twice as far</source>
        <translation>Jeder Schritt bewegt %who doppelt so weit</translation>
    </message>
    <message>
        <source>Look at what your program keeps from one step to the next, and at what it has of that before the first.</source>
        <translation>Sieh dir an, was dein Programm von einem Schritt zum nächsten behält und was davon vor dem ersten da ist.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it goes %2 m in the first step of %3 s; made as the second is, that step goes %4 m.</source>
        <translation>Mit %1 m/s gestartet, kommt er im ersten Schritt von %3 s um %2 m weiter; ginge dieser wie der zweite, wären es %4 m.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s after the first step of %3 s; made as the second is, that step gives it %4 m/s.</source>
        <translation>Mit %1 m/s gestartet, hat er nach dem ersten Schritt von %3 s %2 m/s; ginge dieser wie der zweite, hätte er %4 m/s.</translation>
    </message>
    <message>
        <source>The first step of %who is made in another way</source>
        <translation>Der erste Schritt von %who geschieht anders</translation>
    </message>
    <message>
        <source>Count the lines that change the position in a step without a hit, and look at their factors.</source>
        <translation>Zähle die Zeilen, die in einem Schritt ohne Stoß den Ort ändern, und sieh dir ihre Faktoren an.</translation>
    </message>
    <message>
        <source>The way of %who in a step is %1 times v Δt</source>
        <translation>Für %who ist der Weg eines Schritts das %1-Fache von v Δt</translation>
    </message>
    <message>
        <source>Look at the factors in the line that moves it.</source>
        <translation>Sieh dir die Faktoren in der Zeile an, die den Kreis bewegt.</translation>
    </message>
    <message>
        <source>The velocity of %who changes although no force acts</source>
        <translation>Die Geschwindigkeit ändert sich, obwohl keine Kraft wirkt: %who</translation>
    </message>
    <message>
        <source>Without a force a velocity stays as it is: look for the line that changes it in free flight.</source>
        <translation>Ohne Kraft bleibt eine Geschwindigkeit, wie sie ist: Suche die Zeile, die sie im freien Flug ändert.</translation>
    </message>
    <message>
        <source>The same fault shows in this, too: %1.</source>
        <translation>Derselbe Fehler zeigt sich auch hierin: %1.</translation>
    </message>
    <message>
        <source>Line %1 sets a field `%2` of your own, which nothing reads: a circle has a `%3`.</source>
        <translation>Zeile %1 setzt ein eigenes Feld `%2`, das nichts liest: Ein Kreis hat `%3`.</translation>
    </message>
    <message>
        <source>The whole velocities change hands and are turned round as well</source>
        <translation>Die ganzen Geschwindigkeiten werden getauscht und obendrein umgekehrt</translation>
    </message>
    <message>
        <source>Both circles get their new part along the normal besides the old</source>
        <translation>Beide Kreise bekommen ihren neuen Anteil längs der Normalen zum alten dazu</translation>
    </message>
    <message>
        <source>Circle 1 gets its new part along the normal besides the old</source>
        <translation>Kreis 1 bekommt seinen neuen Anteil längs der Normalen zum alten dazu</translation>
    </message>
    <message>
        <source>Circle 2 gets its new part along the normal besides the old</source>
        <translation>Kreis 2 bekommt seinen neuen Anteil längs der Normalen zum alten dazu</translation>
    </message>
    <message>
        <source>A hit gives a new part along the line of centres in place of the old one: look at what the new part is added to.</source>
        <translation>Ein Stoß gibt einen neuen Anteil längs der Verbindungslinie anstelle des alten: Sieh nach, wozu der neue Anteil addiert wird.</translation>
    </message>
    <message>
        <source>The circles answer each other although they are far apart</source>
        <translation>Die Kreise antworten aufeinander, obwohl sie weit voneinander entfernt sind</translation>
    </message>
    <message>
        <source>Started with %1 and %2 m/s, far from each other, they have %3 and %4 m/s one step of %5 s later; where circle %6 starts at %7 m, circle %8 keeps its velocity. Look at how your program tests whether they touch.</source>
        <translation>Mit %1 und %2 m/s gestartet, weit voneinander entfernt, haben sie einen Schritt von %5 s später %3 und %4 m/s; startet Kreis %6 bei %7 m, behält Kreis %8 seine Geschwindigkeit. Sieh dir an, wie dein Programm prüft, ob sie sich berühren.</translation>
    </message>
    <message>
        <source>Started with %1 and %2 m/s, far from each other, they have %3 and %4 m/s one step of %5 s later: the velocities change against each other, as in a hit. Look at how your program tests whether they touch.</source>
        <translation>Mit %1 und %2 m/s gestartet, weit voneinander entfernt, haben sie einen Schritt von %5 s später %3 und %4 m/s: Die Geschwindigkeiten ändern sich gegeneinander, wie bei einem Stoß. Sieh dir an, wie dein Programm prüft, ob sie sich berühren.</translation>
    </message>
    <message>
        <source>A number stands for gravity in the motion of %who</source>
        <translation>Für %who steht in der Bewegung eine Zahl statt der Schwerkraft</translation>
    </message>
    <message>
        <source>Gravity pulls %who in a wrong direction</source>
        <translation>Die Schwerkraft zieht %who in eine falsche Richtung</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² the velocity changes by %2 m/s in a step of %3 s; it should change by %4 m/s.</source>
        <translation>Unter der Schwerkraft %1 m/s² ändert sich die Geschwindigkeit in einem Schritt von %3 s um %2 m/s; ändern sollte sie sich um %4 m/s.</translation>
    </message>
    <message>
        <source>Gravity moves %who at once and changes no velocity</source>
        <translation>Die Schwerkraft bewegt %who sofort und ändert keine Geschwindigkeit</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² a circle at rest is %2 m away after a step of %3 s, and its velocity is still 0. Gravity is an acceleration: it changes the velocity, and that moves the circle.</source>
        <translation>Unter der Schwerkraft %1 m/s² ist ein ruhender Kreis nach einem Schritt von %3 s um %2 m versetzt, und seine Geschwindigkeit ist immer noch 0. Die Schwerkraft ist eine Beschleunigung: Sie ändert die Geschwindigkeit, und die bewegt den Kreis.</translation>
    </message>
    <message>
        <source>Gravity acts on %who for a whole second in every step</source>
        <translation>Die Schwerkraft wirkt auf %who in jedem Schritt eine ganze Sekunde</translation>
    </message>
    <message>
        <source>An acceleration says what a second changes; a step lasts only Δt. Compare the units on both sides.</source>
        <translation>Eine Beschleunigung sagt, was eine Sekunde ändert; ein Schritt dauert nur Δt. Vergleiche die Einheiten auf beiden Seiten.</translation>
    </message>
    <message>
        <source>Gravity on %who is multiplied by the timestep twice</source>
        <translation>Für %who wird die Schwerkraft zweimal mit dem Zeitschritt multipliziert</translation>
    </message>
    <message>
        <source>Count how often the timestep stands in the line that changes the velocity.</source>
        <translation>Zähle, wie oft der Zeitschritt in der Zeile steht, die die Geschwindigkeit ändert.</translation>
    </message>
    <message>
        <source>A fixed number stands for the timestep in the fall of %who</source>
        <translation>Für %who steht im Fall eine feste Zahl statt des Zeitschritts</translation>
    </message>
    <message>
        <source>Look at the signs.</source>
        <translation>Sieh dir die Vorzeichen an.</translation>
    </message>
    <message>
        <source>Gravity acts on %who twice as strongly</source>
        <translation>Die Schwerkraft wirkt doppelt so stark auf %who</translation>
    </message>
    <message>
        <source>Count the lines of a step that change the velocity, and look at their factors.</source>
        <translation>Zähle in einem Schritt die Zeilen, die die Geschwindigkeit ändern, und sieh dir ihre Faktoren an.</translation>
    </message>
    <message>
        <source>The velocity of %who gets only half of gravity</source>
        <translation>Für %who bekommt die Geschwindigkeit nur die halbe Schwerkraft</translation>
    </message>
    <message>
        <source>Look for a factor ½, or for a second half that is missing.</source>
        <translation>Suche einen Faktor ½ oder eine zweite Hälfte, die fehlt.</translation>
    </message>
    <message>
        <source>Look at the factors in the line that changes the velocity.</source>
        <translation>Sieh dir die Faktoren in der Zeile an, die die Geschwindigkeit ändert.</translation>
    </message>
    <message>
        <source>The fall of %who is not that of the gravity in the scene</source>
        <translation>Für %who ist der Fall nicht der mit der Schwerkraft der Szene</translation>
    </message>
    <message>
        <source>In your own scene gravity is %1 m/s², and the velocity changes by %2 m/s in a second. A copy of gravity keeps the value of the moment when it was made: before or after `on_load` has set it?</source>
        <translation>In deiner eigenen Szene ist die Schwerkraft %1 m/s², und die Geschwindigkeit ändert sich in einer Sekunde um %2 m/s. Eine Kopie der Schwerkraft behält den Wert des Augenblicks, in dem sie gemacht wurde: bevor oder nachdem `on_load` sie gesetzt hat?</translation>
    </message>
    <message>
        <source>The place of %who acts on its velocity otherwise than asked</source>
        <translation>Für %who wirkt der Ort anders auf die Geschwindigkeit als verlangt</translation>
    </message>
    <message>
        <source>Something slows %who down on the way</source>
        <translation>Etwas bremst %who unterwegs</translation>
    </message>
    <message>
        <source>Something makes %who faster on the way</source>
        <translation>Etwas beschleunigt %who unterwegs</translation>
    </message>
    <message>
        <source>Nothing slows %who down on the way</source>
        <translation>Nichts bremst %who unterwegs</translation>
    </message>
    <message>
        <source>Nothing makes %who faster on the way</source>
        <translation>Nichts beschleunigt %who unterwegs</translation>
    </message>
    <message>
        <source>What should slow %who down makes it faster</source>
        <translation>Was %who bremsen sollte, beschleunigt</translation>
    </message>
    <message>
        <source>What should make %who faster slows it down</source>
        <translation>Was %who beschleunigen sollte, bremst</translation>
    </message>
    <message>
        <source>What acts on the velocity of %who is %1 times as strong as it should be</source>
        <translation>Für %who ist das, was auf die Geschwindigkeit wirkt, %1-mal so stark, wie es sein soll</translation>
    </message>
    <message>
        <source>The motion of %who is no known method</source>
        <translation>Für %who folgt die Bewegung keinem bekannten Verfahren</translation>
    </message>
    <message>
        <source>The motion of %who is %1, not %2</source>
        <translation>Falsches Verfahren für %who: %1, nicht %2</translation>
    </message>
    <message>
        <source>The motion of %who is no known method; %1 is asked for</source>
        <translation>Für %who folgt die Bewegung keinem bekannten Verfahren; verlangt ist: %1</translation>
    </message>
    <message>
        <source>Here two circles of the same mass meet. </source>
        <translation>Hier treffen sich zwei Kreise gleicher Masse. </translation>
    </message>
    <message>
        <source>Here two circles of the same mass meet, with e = %1. </source>
        <translation>Hier treffen sich zwei Kreise gleicher Masse, mit e = %1. </translation>
    </message>
    <message>
        <source>Both velocities change equally much, whatever the masses are</source>
        <translation>Beide Geschwindigkeiten ändern sich gleich stark, wie groß die Massen auch sind</translation>
    </message>
    <message>
        <source>The heavier of two circles changes its velocity less. Look at where the masses of both enter your answer.</source>
        <translation>Der schwerere von zwei Kreisen ändert seine Geschwindigkeit weniger. Sieh nach, wo die Massen beider in deine Antwort eingehen.</translation>
    </message>
    <message>
        <source>The mass grows with r to the power of %1, not %2</source>
        <translation>Die Masse wächst mit r hoch %1, nicht hoch %2</translation>
    </message>
    <message>
        <source>A ball that is twice as wide is also twice as high and as deep: its mass grows with r³.</source>
        <translation>Eine Kugel, die doppelt so breit ist, ist auch doppelt so hoch und doppelt so tief: Ihre Masse wächst mit r³.</translation>
    </message>
    <message>
        <source>The mass grows with the density to the power of %1, not %2</source>
        <translation>Die Masse wächst mit der Dichte hoch %1, nicht hoch %2</translation>
    </message>
    <message>
        <source>With e = %1: </source>
        <translation>Mit e = %1: </translation>
    </message>
    <message>
        <source>e multiplies the whole velocities after the hit</source>
        <translation>e multipliziert die ganzen Geschwindigkeiten nach dem Stoß</translation>
    </message>
    <message>
        <source>e belongs to the rebound along the line of centres alone; the total momentum stays.</source>
        <translation>e gehört allein zum Rückprall längs der Verbindungslinie der Mittelpunkte; der Gesamtimpuls bleibt.</translation>
    </message>
    <message>
        <source>e also shortens the parts across the line of centres</source>
        <translation>e verkürzt auch die Anteile quer zur Verbindungslinie der Mittelpunkte</translation>
    </message>
    <message>
        <source>Nothing pushes there: they stay as they were.</source>
        <translation>Dort drückt nichts: Sie bleiben, wie sie waren.</translation>
    </message>
    <message>
        <source>e changes nothing in the hits tried</source>
        <translation>In den erprobten Stößen ändert e nichts</translation>
    </message>
    <message>
        <source>e is squared in the hit of two circles</source>
        <translation>Im Stoß zweier Kreise wird e quadriert</translation>
    </message>
    <message>
        <source>The root of e is used in the hit of two circles</source>
        <translation>Im Stoß zweier Kreise steht die Wurzel aus e</translation>
    </message>
    <message>
        <source>e works the wrong way round: the factor is 2 − e, not 1 + e</source>
        <translation>e wirkt verkehrt herum: Der Faktor ist 2 − e, nicht 1 + e</translation>
    </message>
    <message>
        <source>The push is multiplied by 2 e instead of 1 + e</source>
        <translation>Der Kraftstoß wird mit 2 e statt mit 1 + e multipliziert</translation>
    </message>
    <message>
        <source>The push is multiplied by e instead of 1 + e</source>
        <translation>Der Kraftstoß wird mit e statt mit 1 + e multipliziert</translation>
    </message>
    <message>
        <source>The push is multiplied by e (1 + e) instead of 1 + e</source>
        <translation>Der Kraftstoß wird mit e (1 + e) statt mit 1 + e multipliziert</translation>
    </message>
    <message>
        <source>The rebound is divided by e</source>
        <translation>Der Rückprall wird durch e geteilt</translation>
    </message>
    <message>
        <source>The sign of e is wrong in the hit of two circles</source>
        <translation>Im Stoß zweier Kreise hat e das falsche Vorzeichen</translation>
    </message>
    <message>
        <source>e does not act on the rebound as it should</source>
        <translation>e wirkt nicht so auf den Rückprall, wie es soll</translation>
    </message>
    <message>
        <source>A number stands for e in the hit of two circles</source>
        <translation>Im Stoß zweier Kreise steht eine Zahl für e</translation>
    </message>
    <message>
        <source>After a hit the circles part faster than they met</source>
        <translation>Nach einem Stoß trennen sich die Kreise schneller, als sie sich trafen</translation>
    </message>
    <message>
        <source>After a hit the circles still run into each other</source>
        <translation>Nach einem Stoß laufen die Kreise noch immer ineinander</translation>
    </message>
    <message>
        <source>Numbers stand for e in the hit of two circles</source>
        <translation>Im Stoß zweier Kreise stehen Zahlen für e</translation>
    </message>
    <message>
        <source>A hit acts on both circles.</source>
        <translation>Ein Stoß wirkt auf beide Kreise.</translation>
    </message>
    <message>
        <source>A hit leaves circle 2 as it was</source>
        <translation>Ein Stoß lässt Kreis 2, wie er war</translation>
    </message>
    <message>
        <source>A hit leaves circle 1 as it was</source>
        <translation>Ein Stoß lässt Kreis 1, wie er war</translation>
    </message>
    <message>
        <source>A hit stops both circles</source>
        <translation>Ein Stoß hält beide Kreise an</translation>
    </message>
    <message>
        <source>That was right in the step that only looked for the contact.</source>
        <translation>Das war in dem Schritt richtig, der nur die Berührung suchte.</translation>
    </message>
    <message>
        <source>A hit stops circle 1 and leaves circle 2 as it was</source>
        <translation>Ein Stoß hält Kreis 1 an und lässt Kreis 2, wie er war</translation>
    </message>
    <message>
        <source>A hit stops circle 2 and leaves circle 1 as it was</source>
        <translation>Ein Stoß hält Kreis 2 an und lässt Kreis 1, wie er war</translation>
    </message>
    <message>
        <source>Each circle is turned back on its own way</source>
        <translation>Jeder Kreis kehrt auf seinem eigenen Weg um</translation>
    </message>
    <message>
        <source>Each circle bounces as off a wall</source>
        <translation>Jeder Kreis prallt ab wie von einer Wand</translation>
    </message>
    <message>
        <source>Circle 1 bounces as off a wall</source>
        <translation>Kreis 1 prallt ab wie von einer Wand</translation>
    </message>
    <message>
        <source>Circle 2 bounces as off a wall</source>
        <translation>Kreis 2 prallt ab wie von einer Wand</translation>
    </message>
    <message>
        <source>Circle 1 bounces as off a wall, and circle 2 stays as it was</source>
        <translation>Kreis 1 prallt ab wie von einer Wand, und Kreis 2 bleibt, wie er war</translation>
    </message>
    <message>
        <source>Circle 2 bounces as off a wall, and circle 1 stays as it was</source>
        <translation>Kreis 2 prallt ab wie von einer Wand, und Kreis 1 bleibt, wie er war</translation>
    </message>
    <message>
        <source>The parts across the line of centres turn round, not those along it</source>
        <translation>Die Anteile quer zur Verbindungslinie der Mittelpunkte kehren um, nicht die längs dazu</translation>
    </message>
    <message>
        <source>The push acts along the line of centres.</source>
        <translation>Der Kraftstoß wirkt längs der Verbindungslinie der Mittelpunkte.</translation>
    </message>
    <message>
        <source>A smooth circle pushes along the line of centres only; each keeps its own part across.</source>
        <translation>Ein glatter Kreis stößt nur längs der Verbindungslinie der Mittelpunkte; jeder behält seinen eigenen Anteil quer dazu.</translation>
    </message>
    <message>
        <source>Both new velocities come from those *before* the hit: look at which lines read a velocity that has been written.</source>
        <translation>Beide neuen Geschwindigkeiten kommen aus denen *vor* dem Stoß: Sieh nach, welche Zeilen eine Geschwindigkeit lesen, die schon geschrieben wurde.</translation>
    </message>
    <message>
        <source>The parts across change hands, and those along the normal stay</source>
        <translation>Die Anteile quer zur Normalen werden getauscht, und die längs der Normalen bleiben</translation>
    </message>
    <message>
        <source>The parts across the normal are lost</source>
        <translation>Die Anteile quer zur Normalen gehen verloren</translation>
    </message>
    <message>
        <source>Both circles leave with the velocity of circle 2</source>
        <translation>Beide Kreise verlassen den Stoß mit der Geschwindigkeit von Kreis 2</translation>
    </message>
    <message>
        <source>Both circles leave with the velocity of circle 1</source>
        <translation>Beide Kreise verlassen den Stoß mit der Geschwindigkeit von Kreis 1</translation>
    </message>
    <message>
        <source>The velocity of circle 2 is worked out from what circle 1 has become</source>
        <translation>Die Geschwindigkeit von Kreis 2 wird aus dem berechnet, was aus Kreis 1 geworden ist</translation>
    </message>
    <message>
        <source>The velocity of circle 1 is worked out from what circle 2 has become</source>
        <translation>Die Geschwindigkeit von Kreis 1 wird aus dem berechnet, was aus Kreis 2 geworden ist</translation>
    </message>
    <message>
        <source>After a hit both circles have the same velocity</source>
        <translation>Nach einem Stoß haben beide Kreise dieselbe Geschwindigkeit</translation>
    </message>
    <message>
        <source>The part of circle 2 along the normal is forgotten</source>
        <translation>Der Anteil von Kreis 2 längs der Normalen wird vergessen</translation>
    </message>
    <message>
        <source>Circle 1 gives its part away and gets nothing for it.</source>
        <translation>Kreis 1 gibt seinen Anteil ab und bekommt nichts dafür.</translation>
    </message>
    <message>
        <source>The part of circle 1 along the normal is forgotten</source>
        <translation>Der Anteil von Kreis 1 längs der Normalen wird vergessen</translation>
    </message>
    <message>
        <source>Circle 2 gives its part away and gets nothing for it.</source>
        <translation>Kreis 2 gibt seinen Anteil ab und bekommt nichts dafür.</translation>
    </message>
    <message>
        <source>Circle 1 keeps the part that it hands over</source>
        <translation>Kreis 1 behält den Anteil, den er weitergibt</translation>
    </message>
    <message>
        <source>What circle 2 gets, circle 1 must lose.</source>
        <translation>Was Kreis 2 bekommt, muss Kreis 1 verlieren.</translation>
    </message>
    <message>
        <source>The parts along the normal change hands and are turned round as well</source>
        <translation>Die Anteile längs der Normalen werden getauscht und außerdem umgekehrt</translation>
    </message>
    <message>
        <source>The exchange alone is the whole answer.</source>
        <translation>Der Tausch allein ist die ganze Antwort.</translation>
    </message>
    <message>
        <source>The push on circle 1 has the wrong sign</source>
        <translation>Der Kraftstoß auf Kreis 1 hat das falsche Vorzeichen</translation>
    </message>
    <message>
        <source>It gains the part that it should lose.</source>
        <translation>Er gewinnt den Anteil, den er verlieren sollte.</translation>
    </message>
    <message>
        <source>The push on circle 2 has the wrong sign</source>
        <translation>Der Kraftstoß auf Kreis 2 hat das falsche Vorzeichen</translation>
    </message>
    <message>
        <source>It loses the part that it should gain.</source>
        <translation>Er verliert den Anteil, den er gewinnen sollte.</translation>
    </message>
    <message>
        <source>Both pushes have the wrong sign</source>
        <translation>Beide Kraftstöße haben das falsche Vorzeichen</translation>
    </message>
    <message>
        <source>The circles are drawn into each other.</source>
        <translation>Die Kreise werden ineinander gezogen.</translation>
    </message>
    <message>
        <source>A direction has length 1: divide it by its own length, else its length comes into the push, and twice.</source>
        <translation>Eine Richtung hat die Länge 1: Teile sie durch ihre eigene Länge, sonst geht diese in den Kraftstoß ein, und zwar zweimal.</translation>
    </message>
    <message>
        <source>The push acts along the line from centre to centre.</source>
        <translation>Der Kraftstoß wirkt längs der Linie von Mittelpunkt zu Mittelpunkt.</translation>
    </message>
    <message>
        <source>The normal does not have length 1</source>
        <translation>Die Normale hat nicht die Länge 1</translation>
    </message>
    <message>
        <source>The perpendicular of the line of centres is taken for the normal</source>
        <translation>Die Senkrechte zur Verbindungslinie der Mittelpunkte wird für die Normale gehalten</translation>
    </message>
    <message>
        <source>The parts x and y of the normal are exchanged</source>
        <translation>Die Anteile x und y der Normalen sind vertauscht</translation>
    </message>
    <message>
        <source>The normal is mirrored: the sign of its y is wrong</source>
        <translation>Die Normale ist gespiegelt: Das Vorzeichen ihres y ist falsch</translation>
    </message>
    <message>
        <source>The push acts along the velocity of circle 1</source>
        <translation>Der Kraftstoß wirkt längs der Geschwindigkeit von Kreis 1</translation>
    </message>
    <message>
        <source>The x parts change hands, not those along the line of centres</source>
        <translation>Getauscht werden die x-Anteile, nicht die längs der Verbindungslinie der Mittelpunkte</translation>
    </message>
    <message>
        <source>The y parts change hands, not those along the line of centres</source>
        <translation>Getauscht werden die y-Anteile, nicht die längs der Verbindungslinie der Mittelpunkte</translation>
    </message>
    <message>
        <source>The new velocities are turned back by the wrong angle</source>
        <translation>Die neuen Geschwindigkeiten werden um den falschen Winkel zurückgedreht</translation>
    </message>
    <message>
        <source>Who turns by −φ before must turn by +φ afterwards.</source>
        <translation>Wer vorher um −φ dreht, muss danach um +φ drehen.</translation>
    </message>
    <message>
        <source>The new velocities are not turned back</source>
        <translation>Die neuen Geschwindigkeiten werden nicht zurückgedreht</translation>
    </message>
    <message>
        <source>They are still taken apart along the line of centres: put them together again.</source>
        <translation>Sie sind noch in Anteile längs und quer zur Verbindungslinie der Mittelpunkte zerlegt: Setz sie wieder zusammen.</translation>
    </message>
    <message>
        <source>The parts across the line of centres are changed</source>
        <translation>Die Anteile quer zur Verbindungslinie der Mittelpunkte ändern sich</translation>
    </message>
    <message>
        <source>A smooth circle pushes along the line of centres only.</source>
        <translation>Ein glatter Kreis stößt nur längs der Verbindungslinie der Mittelpunkte.</translation>
    </message>
    <message>
        <source>The two pushes are not equal and opposite</source>
        <translation>Die beiden Kraftstöße sind nicht gleich groß und entgegengesetzt</translation>
    </message>
    <message>
        <source>What one circle of the same mass gains, the other loses: else the total momentum changes.</source>
        <translation>Was ein Kreis der gleichen Masse gewinnt, verliert der andere: Sonst ändert sich der Gesamtimpuls.</translation>
    </message>
    <message>
        <source>The push is not along the line of centres</source>
        <translation>Der Kraftstoß wirkt nicht längs der Verbindungslinie</translation>
    </message>
    <message>
        <source>The parts across it must stay as they were.</source>
        <translation>Die Anteile quer dazu müssen bleiben, wie sie waren.</translation>
    </message>
    <message>
        <source>The push has the wrong size</source>
        <translation>Der Kraftstoß hat die falsche Größe</translation>
    </message>
    <message>
        <source>In meetings with a timestep of %1 s it was between %2 and %3 times as large as it should be.</source>
        <translation>In Begegnungen mit einem Zeitschritt von %1 s war er zwischen dem %2- und dem %3-Fachen dessen, was er sein soll.</translation>
    </message>
    <message>
        <source>In your own scene the circles answer as if they had other masses</source>
        <translation>In deiner eigenen Szene antworten die Kreise, als hätten sie andere Massen</translation>
    </message>
    <message>
        <source>In your own scene the hit does not use the e that it has</source>
        <translation>In deiner eigenen Szene benutzt der Stoß nicht das e, das sie hat</translation>
    </message>
    <message>
        <source>The normal of the side walls points along x, that of floor and ceiling along y.</source>
        <translation>Die Normale der Seitenwände zeigt längs x, die von Boden und Decke längs y.</translation>
    </message>
    <message>
        <source>Its velocity still points into the wall: look at the sign.</source>
        <translation>Die Geschwindigkeit zeigt immer noch in die Wand: Sieh dir das Vorzeichen an.</translation>
    </message>
    <message>
        <source>Heights go with e², speeds with e.</source>
        <translation>Höhen gehen mit e², Geschwindigkeiten mit e.</translation>
    </message>
    <message>
        <source>1 − e is what is lost; e is what is left.</source>
        <translation>1 − e ist, was verloren geht; e ist, was bleibt.</translation>
    </message>
    <message>
        <source>1 + e is the whole change of the velocity, e what comes back.</source>
        <translation>1 + e ist die ganze Änderung der Geschwindigkeit, e das, was zurückkommt.</translation>
    </message>
    <message>
        <source>In a corner only one part of the velocity of %who turns round</source>
        <translation>In einer Ecke wird für %who nur ein Anteil der Geschwindigkeit umgekehrt</translation>
    </message>
    <message>
        <source>Along the line of centres circle 1 had %1 m/s and circle 2 %2 m/s, so they came nearer with %3 m/s, and ran into each other; other meetings are answered. What counts is the velocity of one relative to the other.</source>
        <translation>Längs der Verbindungslinie der Mittelpunkte hatte Kreis 1 %1 m/s und Kreis 2 %2 m/s; sie kamen sich also mit %3 m/s näher und liefen ineinander, während andere Begegnungen beantwortet werden. Es zählt die Geschwindigkeit des einen relativ zum anderen.</translation>
    </message>
    <message>
        <source>The circles are held and keep their velocities</source>
        <translation>Die Kreise werden festgehalten und behalten ihre Geschwindigkeiten</translation>
    </message>
    <message>
        <source>Every step puts %who where circle %1 is</source>
        <translation>Jeder Schritt setzt %who dorthin, wo Kreis %1 ist</translation>
    </message>
    <message>
        <source> Both parts of the position must change, each by its own part of the velocity.</source>
        <translation> Beide Koordinaten des Orts müssen sich ändern, jede mit ihrem eigenen Anteil der Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Each part of the position changes by its own part of the velocity.</source>
        <translation>Jede Koordinate des Orts ändert sich mit ihrem eigenen Anteil der Geschwindigkeit.</translation>
    </message>
    <message>
        <source>The x part of the velocity moves %who in y</source>
        <translation>Der x-Anteil der Geschwindigkeit bewegt %who in y</translation>
    </message>
    <message>
        <source>The y part of the velocity moves %who in x</source>
        <translation>Der y-Anteil der Geschwindigkeit bewegt %who in x</translation>
    </message>
    <message>
        <source>x and y of the velocity are exchanged in the way of %who</source>
        <translation>x und y der Geschwindigkeit sind vertauscht, wo %who sich bewegt</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7), the change of v₁ was %5 times that of v₂; m₂/m₁ = %6 is right.</source>
        <translation>Mit r₁ = %1 und r₂ = %2 m, ρ₁ = %3 und ρ₂ = %4 (e = %7) war die Änderung von v₁ das %5-Fache der von v₂; richtig ist m₂/m₁ = %6.</translation>
    </message>
    <message>
        <source>Where the masses differ, only circle %1 leaves as it should</source>
        <translation>Wo die Massen verschieden sind, verlässt nur Kreis %1 den Stoß, wie er soll</translation>
    </message>
    <message>
        <source>The two masses are not worked out in the same way</source>
        <translation>Die beiden Massen werden nicht auf dieselbe Art berechnet</translation>
    </message>
    <message>
        <source>Two circles of the same radius and density answer as if circle 2 were %1 times as heavy as circle 1, and with another density that both have %2 times. Compare the lines for the two masses.</source>
        <translation>Zwei Kreise mit gleichem Radius und gleicher Dichte antworten, als wäre Kreis 2 %1-mal so schwer wie Kreis 1, und mit einer anderen Dichte, die beide haben, %2-mal. Vergleiche die Zeilen für die beiden Massen.</translation>
    </message>
    <message>
        <source>The hits do not depend on the radii</source>
        <translation>Die Stöße hängen nicht von den Radien ab</translation>
    </message>
    <message>
        <source>The masses do not follow the radii as those of balls do</source>
        <translation>Die Massen folgen den Radien nicht wie die von Kugeln</translation>
    </message>
    <message>
        <source>The hits do not depend on the densities</source>
        <translation>Die Stöße hängen nicht von den Dichten ab</translation>
    </message>
    <message>
        <source>The masses do not follow the densities</source>
        <translation>Die Massen folgen den Dichten nicht</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %5) they came nearer with u = %6 m/s along the line of centres.</source>
        <translation>Mit r₁ = %1 und r₂ = %2 m, ρ₁ = %3 und ρ₂ = %4 (e = %5) kamen sie sich längs der Verbindungslinie der Mittelpunkte mit u = %6 m/s näher.</translation>
    </message>
    <message>
        <source>Circle 1 changed its velocity by %1 m/s and circle 2 by %2, together %3 m/s; (1 + e) u = %4 m/s is right. However heavy they are, the share of circle 1 is m₂/(m₁ + m₂) and that of circle 2 m₁/(m₁ + m₂).</source>
        <translation>Kreis 1 änderte seine Geschwindigkeit um %1 m/s und Kreis 2 um %2, zusammen %3 m/s; richtig ist (1 + e) u = %4 m/s. Wie schwer sie auch sind, der Anteil von Kreis 1 ist m₂/(m₁ + m₂) und der von Kreis 2 m₁/(m₁ + m₂).</translation>
    </message>
    <message>
        <source>Some hits drive the circles towards each other</source>
        <translation>Manche Stöße treiben die Kreise aufeinander zu</translation>
    </message>
    <message>
        <source>Along it, from 1 to 2, the velocity of circle 1 changed by %1 m/s and that of circle 2 by %2 m/s, so that they come nearer still faster. A hit takes (1 + e) u = %3 m/s of that, and each circle changes by its share: circle 1 by m₂/(m₁ + m₂) and circle 2 by m₁/(m₁ + m₂) of it.</source>
        <translation>Längs dieser Linie, von 1 nach 2, änderte sich die Geschwindigkeit von Kreis 1 um %1 m/s und die von Kreis 2 um %2 m/s, so dass sie sich noch schneller nähern. Ein Stoß nimmt davon (1 + e) u = %3 m/s, und jeder Kreis ändert sich um seinen Anteil: Kreis 1 um m₂/(m₁ + m₂) und Kreis 2 um m₁/(m₁ + m₂) davon.</translation>
    </message>
    <message>
        <source>The shares of the two circles do not add up to 1</source>
        <translation>Die Anteile der beiden Kreise ergeben zusammen nicht 1</translation>
    </message>
    <message>
        <source>Mass is density times volume, for each circle its own.</source>
        <translation>Masse ist Dichte mal Volumen, für jeden Kreis die eigene.</translation>
    </message>
    <message>
        <source>Nobody holds the other circle as a wall is held: look at what each circle gets of the other.</source>
        <translation>Niemand hält den anderen Kreis fest wie eine Wand: Sieh nach, was jeder Kreis vom anderen bekommt.</translation>
    </message>
    <message>
        <source>There circle 2 answers as if it were %1 times as heavy as circle 1; with its radii %2 and %3 m and densities %4 and %5 it is %6 times. In other scenes the masses come out right.</source>
        <translation>Dort antwortet Kreis 2, als wäre er %1-mal so schwer wie Kreis 1; mit den Radien %2 und %3 m und den Dichten %4 und %5 ist er es %6-mal. In anderen Szenen stimmen die Massen.</translation>
    </message>
    <message>
        <source>So it is with radii or densities from before `on_load`: a mass that is worked out before they are set keeps the old value. Look at the order there, and at what is asked before the answer.</source>
        <translation>So ist es mit Radien oder Dichten von vor `on_load`: Eine Masse, die berechnet wird, bevor sie gesetzt sind, behält den alten Wert. Sieh dir die Reihenfolge dort an und was vor der Antwort gefragt wird.</translation>
    </message>
    <message>
        <source>Look at what the answer takes for the masses there, and at what is asked before it.</source>
        <translation>Sieh dir an, was die Antwort dort für die Massen nimmt und was vorher gefragt wird.</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4, e = %5: </source>
        <translation>Mit r₁ = %1 und r₂ = %2 m, ρ₁ = %3 und ρ₂ = %4, e = %5: </translation>
    </message>
    <message>
        <source>e = %1 is not the value that is asked for</source>
        <translation>e = %1 ist nicht der verlangte Wert</translation>
    </message>
    <message>
        <source>Circle %5 came to the %1 with %2 m/s and left it with %3 m/s; %4 m/s is right.</source>
        <translation>Kreis %5 kam mit %2 m/s an %1 an und ging mit %3 m/s; richtig ist %4 m/s.</translation>
    </message>
    <message>
        <source>In your own scene the first step changes the velocity of %who</source>
        <translation>In deiner eigenen Szene ändert der erste Schritt die Geschwindigkeit für %who</translation>
    </message>
    <message>
        <source>The x of the velocity of %who is 0 after every step</source>
        <translation>Das x der Geschwindigkeit ist für %who nach jedem Schritt 0</translation>
    </message>
    <message>
        <source>The x of the velocity of %who is set anew in every step</source>
        <translation>Das x der Geschwindigkeit wird für %who in jedem Schritt neu gesetzt</translation>
    </message>
    <message>
        <source>The y of the velocity of %who is 0 after every step</source>
        <translation>Das y der Geschwindigkeit ist für %who nach jedem Schritt 0</translation>
    </message>
    <message>
        <source>The y of the velocity of %who is set anew in every step</source>
        <translation>Das y der Geschwindigkeit wird für %who in jedem Schritt neu gesetzt</translation>
    </message>
    <message>
        <source>The old place of %who is multiplied, too</source>
        <translation>Auch der alte Ort wird für %who multipliziert</translation>
    </message>
    <message>
        <source>Two that start 1 m apart, at rest, are %1 m apart one step of %2 s later. The old position is kept as it is; the way v Δt is added to it: look at the brackets.</source>
        <translation>Zwei, die in Ruhe 1 m voneinander entfernt starten, sind nach einem Schritt von %2 s %1 m voneinander entfernt. Der alte Ort bleibt, wie er ist, und der Weg v Δt kommt hinzu: Sieh dir die Klammern an.</translation>
    </message>
    <message>
        <source>The heavier circle is pushed away faster</source>
        <translation>Der schwerere Kreis wird schneller weggestoßen</translation>
    </message>
    <message>
        <source>The masses do not only change places. Look at every place where one enters your answer.</source>
        <translation>Die Massen sind nicht nur vertauscht. Sieh dir jede Stelle an, an der eine in deine Antwort eingeht.</translation>
    </message>
    <message>
        <source>e also shortens the part of circle %1 across the line of centres</source>
        <translation>e verkürzt auch den Anteil von Kreis %1 quer zur Verbindungslinie der Mittelpunkte</translation>
    </message>
    <message>
        <source>Nothing pushes there: it stays as it was.</source>
        <translation>Dort stößt nichts: Er bleibt, wie er war.</translation>
    </message>
    <message>
        <source>Of two equal circles only circle %1 leaves as it should</source>
        <translation>Von zwei gleichen Kreisen verlässt nur Kreis %1 den Stoß, wie er soll</translation>
    </message>
    <message>
        <source>With e = %1 a hit does not come out right</source>
        <translation>Mit e = %1 geht ein Stoß nicht richtig aus</translation>
    </message>
    <message>
        <source>Something away from every wall changes the velocity of %who</source>
        <translation>Etwas ändert fern von jeder Wand die Geschwindigkeit für %who</translation>
    </message>
    <message>
        <source>In your own scene gravity is %1 m/s²; the velocity changes by %2 m/s in the first step and by %3 m/s in the second. Look at what else changes the velocity, away from any hit.</source>
        <translation>In deiner eigenen Szene beträgt die Schwerkraft %1 m/s²; die Geschwindigkeit ändert sich im ersten Schritt um %2 m/s und im zweiten um %3 m/s. Sieh nach, was die Geschwindigkeit sonst noch ändert, fern von jedem Stoß.</translation>
    </message>
    <message>
        <source>A hit soon after another is not answered</source>
        <translation>Ein Stoß bald nach einem anderen wird nicht beantwortet</translation>
    </message>
    <message>
        <source>The velocity of %who is taken from circle %1</source>
        <translation>Für %who kommt die Geschwindigkeit von Kreis %1</translation>
    </message>
    <message>
        <source>Away from every wall a low speed of %who is taken away</source>
        <translation>Fern von jeder Wand wird für %who eine kleine Geschwindigkeit weggenommen</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later, far from every wall and every other circle; a faster one goes on. Look at the conditions in front of the lines that change the velocity.</source>
        <translation>Aus %1 m/s am Anfang werden einen Schritt später %2 m/s, fern von jeder Wand und jedem anderen Kreis; ein schnellerer läuft weiter. Sieh dir die Bedingungen vor den Zeilen an, die die Geschwindigkeit ändern.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: half of that. From the centre to the rim it is the whole radius.</source>
        <translation>Der Radius von Kreis %3 ist %1 m, und umgekehrt wird, wenn der Mittelpunkt %2 m von der Wand entfernt ist: die Hälfte davon. Vom Mittelpunkt zum Rand ist es der ganze Radius.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: twice the radius. From the centre to the rim it is one.</source>
        <translation>Der Radius von Kreis %3 ist %1 m, und umgekehrt wird, wenn der Mittelpunkt %2 m von der Wand entfernt ist: das Doppelte des Radius. Vom Mittelpunkt zum Rand ist es einer.</translation>
    </message>
    <message>
        <source>Circle %3 turns when its centre is one radius, %1 m, past the wall. Of its two ends the near one touches first: look at the sign in front of the radius.</source>
        <translation>Kreis %3 kehrt um, wenn sein Mittelpunkt einen Radius, %1 m, hinter der Wand ist. Von seinen beiden Enden berührt das nähere zuerst: Sieh dir das Vorzeichen vor dem Radius an.</translation>
    </message>
    <message>
        <source>Thrown towards the %1, circle %6 changed its velocity from %2 to %3 m/s in the first step, with its centre still %4 m from that wall; its radius is %5 m. Look at the conditions: which of them is true away from every wall?</source>
        <translation>Zu %1 hin geworfen, änderte Kreis %6 im ersten Schritt seine Geschwindigkeit von %2 auf %3 m/s, mit dem Mittelpunkt noch %4 m von dieser Wand; der Radius ist %5 m. Sieh dir die Bedingungen an: Welche ist fern von jeder Wand wahr?</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it goes %2 m in the second step of a run and %3 m where it starts alike %4 s later, with the same Δt.</source>
        <translation>Mit %1 m/s gestartet, kommt er im zweiten Schritt eines Laufs %2 m weit, und %3 m, wenn er %4 s später ebenso startet, bei gleichem Δt.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s after the first step of a run and %3 m/s where it starts alike %4 s later.</source>
        <translation>Mit %1 m/s gestartet, hat er nach dem ersten Schritt eines Laufs %2 m/s, und %3 m/s, wenn er %4 s später ebenso startet.</translation>
    </message>
    <message>
        <source>The step of %who depends on how long the run has lasted</source>
        <translation>Der Zeitschritt für %who hängt davon ab, wie lange der Lauf schon dauert</translation>
    </message>
    <message>
        <source>How long a step lasts is the parameter of `on_update`; `time` is the time since the start, and `step` counts.</source>
        <translation>Wie lange ein Zeitschritt dauert, ist der Parameter von `on_update`; `time` ist die Zeit seit dem Start, und `step` zählt.</translation>
    </message>
    <message>
        <source>Two circles of the same radius and density answer as if circle 2 were %1 times as heavy as circle 1, and with r₁ = %2 and r₂ = %3 m as if it were %4 times. Compare the lines for the two masses.</source>
        <translation>Zwei Kreise mit gleichem Radius und gleicher Dichte antworten, als wäre Kreis 2 %1-mal so schwer wie Kreis 1, und mit r₁ = %2 und r₂ = %3 m, als wäre er es %4-mal. Vergleiche die Zeilen für die beiden Massen.</translation>
    </message>
    <message>
        <source>The hits hardly depend on the radii</source>
        <translation>Die Stöße hängen kaum von den Radien ab</translation>
    </message>
    <message>
        <source>e acts on more than the rebound</source>
        <translation>e wirkt auf mehr als den Rückprall</translation>
    </message>
    <message>
        <source>The circles part e times as fast as they met, as they should; but what both have together, their momentum, changes, too.</source>
        <translation>Die Kreise trennen sich e-mal so schnell, wie sie sich trafen, wie es sein soll; aber auch was beide zusammen haben, ihr Impuls, ändert sich.</translation>
    </message>
    <message>
        <source>A hit changes the places of the circles, not their velocities</source>
        <translation>Ein Stoß ändert die Orte der Kreise, nicht ihre Geschwindigkeiten</translation>
    </message>
    <message>
        <source>When they touched, circle %1 was put to %2 m, far from where it came from, and both kept their velocities. A hit changes velocities; each circle stays near its own way.</source>
        <translation>Als sie sich berührten, wurde Kreis %1 nach %2 m gesetzt, weit weg von dort, woher er kam, und beide behielten ihre Geschwindigkeiten. Ein Stoß ändert Geschwindigkeiten; jeder Kreis bleibt nahe an seinem eigenen Weg.</translation>
    </message>
    <message>
        <source>Circles that come nearer slowly are not answered</source>
        <translation>Kreise, die sich langsam nähern, antworten nicht</translation>
    </message>
    <message>
        <source>With ρ₁ = %1 and ρ₂ = %2, e = %3: </source>
        <translation>Mit ρ₁ = %1 und ρ₂ = %2, e = %3: </translation>
    </message>
    <message>
        <source>What both have in common comes out right. Of the rebound, the part with e, circle 1 gets the share m₁/(m₁ + m₂) and circle 2 the share m₂/(m₁ + m₂): the lighter one should get more.</source>
        <translation>Was beide gemeinsam haben, stimmt. Vom Rückprall, dem Teil mit e, bekommt Kreis 1 den Anteil m₁/(m₁ + m₂) und Kreis 2 den Anteil m₂/(m₁ + m₂): Der leichtere sollte mehr bekommen.</translation>
    </message>
    <message>
        <source>The other one leaves as it should. Look at what is worked out for this one.</source>
        <translation>Der andere verlässt den Stoß, wie er soll. Sieh dir an, was für diesen errechnet wird.</translation>
    </message>
    <message>
        <source>Of two equal circles circle 2 leaves a hit as it came</source>
        <translation>Von zwei gleichen Kreisen geht Kreis 2 aus dem Stoß, wie er kam</translation>
    </message>
    <message>
        <source>Of two equal circles circle 1 leaves a hit as it came</source>
        <translation>Von zwei gleichen Kreisen geht Kreis 1 aus dem Stoß, wie er kam</translation>
    </message>
    <message>
        <source>There circle 2 answers as if it were %1 times as heavy as circle 1; as your program does in other scenes, it would be %2 times.</source>
        <translation>Dort antwortet Kreis 2, als wäre er %1-mal so schwer wie Kreis 1; so wie dein Programm in anderen Szenen rechnet, wäre er es %2-mal.</translation>
    </message>
    <message>
        <source>They met with %1 m/s and parted with %2 m/s, which is e = %3, and `restitution` is %4. In %5 hits tried in other scenes they part with e times the speed.</source>
        <translation>Sie trafen sich mit %1 m/s und trennten sich mit %2 m/s, das ist e = %3, und `restitution` ist %4. In %5 Stößen, die in anderen Szenen versucht wurden, trennen sie sich mit dem e-Fachen des Tempos.</translation>
    </message>
    <message>
        <source>A copy of e that is made before e is set keeps the old value.</source>
        <translation>Eine Kopie von e, die entsteht, bevor e gesetzt ist, behält den alten Wert.</translation>
    </message>
    <message>
        <source>A later hit is answered along the line of an earlier one</source>
        <translation>Ein späterer Stoß wird längs der Linie eines früheren beantwortet</translation>
    </message>
    <message>
        <source>Two circles met with their line of centres at %1°, and again, back from a wall, with it at %2°. Both times they were pushed along %3°. Every hit has a normal of its own: work it out anew.</source>
        <translation>Zwei Kreise trafen sich mit der Verbindungslinie der Mittelpunkte bei %1° und, von einer Wand zurück, noch einmal mit ihr bei %2°. Beide Male wurden sie längs %3° gestoßen. Jeder Stoß hat seine eigene Normale: Errechne sie jedes Mal neu.</translation>
    </message>
    <message>
        <source>A later hit is answered with another e</source>
        <translation>Ein späterer Stoß wird mit einem anderen e beantwortet</translation>
    </message>
    <message>
        <source>With e = %1 two circles parted with %2 times the speed that they met with; in their second hit, back from a wall, it was %3 times. Look at what your program keeps from one hit to the next.</source>
        <translation>Mit e = %1 trennten sich zwei Kreise mit dem %2-Fachen des Tempos, mit dem sie sich trafen; bei ihrem zweiten Stoß, von einer Wand zurück, war es das %3-Fache. Sieh dir an, was dein Programm von einem Stoß zum nächsten behält.</translation>
    </message>
    <message>
        <source>Circles that meet slowly are answered in another way</source>
        <translation>Kreise, die sich langsam treffen, werden anders beantwortet</translation>
    </message>
    <message>
        <source>Where they meet with %1 m/s, it comes out right. The law is the same for every speed.</source>
        <translation>Wo sie sich mit %1 m/s treffen, geht es richtig aus. Das Gesetz ist für jedes Tempo dasselbe.</translation>
    </message>
    <message>
        <source>twice the smaller radius</source>
        <translation>das Doppelte des kleineren Radius</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and went on past it; with %4 m/s it is turned round. How fast it comes does not matter: what counts is whether its rim is past the wall, and which way it moves.</source>
        <translation>Kreis %1 kam mit %3 m/s an %2 an und lief darüber hinaus; mit %4 m/s kehrt er um. Wie schnell er kommt, spielt keine Rolle: Es zählt, ob sein Rand über die Wand hinaus ist und wohin er sich bewegt.</translation>
    </message>
    <message>
        <source>Here the line of centres was at %1°; with %2° the hits come out right.</source>
        <translation>Hier lag die Verbindungslinie der Mittelpunkte bei %1°; bei %2° gehen die Stöße richtig aus.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, one step later it is %2 m from where it was at the start of a run, and %3 m where it starts alike %4 s later. A step *adds* a way to the old position.</source>
        <translation>Mit %1 m/s gestartet, ist er am Anfang eines Laufs nach einem Schritt %2 m von seinem Ort entfernt, und %3 m, wenn er %4 s später ebenso startet. Ein Schritt *addiert* einen Weg zum alten Ort.</translation>
    </message>
    <message>
        <source> (only in y)</source>
        <translation> (nur in y)</translation>
    </message>
    <message>
        <source> (only in x)</source>
        <translation> (nur in x)</translation>
    </message>
    <message>
        <source>Where the masses differ, the total momentum is not kept</source>
        <translation>Bei verschiedenen Massen bleibt der Gesamtimpuls nicht erhalten</translation>
    </message>
    <message>
        <source>With ρ₁ = %1 and ρ₂ = %2 the change of v₁ was %3 times that of v₂ where e is %4, and %5 times where it is %6; m₂/m₁ = %7 is right, whatever e is. One push changes both: look at what the two formulas have in common.</source>
        <translation>Mit ρ₁ = %1 und ρ₂ = %2 war die Änderung von v₁ das %3-Fache der von v₂, wo e = %4 ist, und das %5-Fache, wo e = %6 ist; richtig ist m₂/m₁ = %7, wie groß e auch ist. Ein einziger Kraftstoß ändert beide: Sieh nach, was die beiden Formeln gemeinsam haben.</translation>
    </message>
    <message>
        <source>e acts only after the first hit</source>
        <translation>e wirkt erst nach dem ersten Stoß</translation>
    </message>
    <message>
        <source>With e = %1 two circles parted with %2 times the speed that they met with; in their second hit, back from a wall, it was %3 times. Look at when your answer learns what e is: that comes too late.</source>
        <translation>Mit e = %1 trennten sich zwei Kreise mit dem %2-Fachen des Tempos, mit dem sie sich trafen; bei ihrem zweiten Stoß, zurück von einer Wand, war es das %3-Fache. Sieh nach, wann deine Antwort erfährt, was e ist: Das kommt zu spät.</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and turned when its rim was between %4 and %5 m from it; with %6 m/s between %7 and %8 m. That is the way of a second: a step takes it v Δt further, not v.</source>
        <translation>Kreis %1 kam mit %3 m/s an %2 an und kehrte um, als sein Rand zwischen %4 und %5 m davon entfernt war; mit %6 m/s zwischen %7 und %8 m. Das ist der Weg einer Sekunde: Ein Schritt bringt ihn um v Δt weiter, nicht um v.</translation>
    </message>
    <message>
        <source>Beside a wall the velocity of both circles changes at once</source>
        <translation>Neben einer Wand ändert sich die Geschwindigkeit beider Kreise zugleich</translation>
    </message>
    <message>
        <source>At %1 s of its run they met at %2 m, with %3 m/s, and ran into each other.</source>
        <translation>Nach %1 s ihres Laufs trafen sie sich bei %2 m mit %3 m/s und liefen ineinander.</translation>
    </message>
    <message>
        <source>At %1 s of its run they met at %2 m, with %3 m/s and e = %4.</source>
        <translation>Nach %1 s ihres Laufs trafen sie sich bei %2 m mit %3 m/s und e = %4.</translation>
    </message>
    <message>
        <source>At %1 s of its run they met at %2 m, with %3 m/s.</source>
        <translation>Nach %1 s ihres Laufs trafen sie sich bei %2 m mit %3 m/s.</translation>
    </message>
    <message>
        <source>At %1 s of its run they met at %2 m, with %3 m/s, and were answered before they touched.</source>
        <translation>Nach %1 s ihres Laufs trafen sie sich bei %2 m mit %3 m/s und antworteten, bevor sie sich berührten.</translation>
    </message>
    <message>
        <source>It was meeting number %1 of that run, %2 s after the one before.</source>
        <translation>Es war Begegnung Nummer %1 dieses Laufs, %2 s nach der davor.</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2 came to the %3 at %4 m with %5 m/s and left it with %6 m/s; %7 m/s is right.</source>
        <translation>Nach %1 s seines Laufs kam Kreis %2 bei %4 m mit %5 m/s an %3 an und ging mit %6 m/s; richtig ist %7 m/s.</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2 came to the %3 at %4 m with %5 m/s and went on past it.</source>
        <translation>Nach %1 s seines Laufs kam Kreis %2 bei %4 m mit %5 m/s an %3 an und lief darüber hinaus.</translation>
    </message>
    <message>
        <source>In a scene in which circle %1 alone has a velocity, %who goes on by that times Δt. Each circle moves with its own velocity: look at the names in the line that moves it.</source>
        <translation>In einer Szene, in der nur Kreis %1 eine Geschwindigkeit hat, geht %who um sie mal Δt weiter. Jeder Kreis bewegt sich mit seiner eigenen Geschwindigkeit: Sieh dir die Namen in der Zeile an, die ihn bewegt.</translation>
    </message>
    <message>
        <source>Its velocity still points into the wall: look at what it is worked out from.</source>
        <translation>Die Geschwindigkeit zeigt immer noch in die Wand: Sieh dir an, woraus sie berechnet wird.</translation>
    </message>
    <message>
        <source>The flight of %who depends on another circle</source>
        <translation>Der Flug hängt für %who von einem anderen Kreis ab</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it goes %2 m in the second step of %3 s; with every other circle at rest and elsewhere %4 m.</source>
        <translation>Mit %1 m/s gestartet, kommt er im zweiten Schritt von %3 s um %2 m weiter; ruht jeder andere Kreis an einem anderen Ort, um %4 m.</translation>
    </message>
    <message>
        <source>They are far from each other. Look at what the lines that move one circle take from another, and at what is asked before them.</source>
        <translation>Sie sind weit voneinander entfernt. Sieh dir an, was die Zeilen, die einen Kreis bewegen, von einem anderen nehmen und was vor ihnen gefragt wird.</translation>
    </message>
    <message>
        <source>What gravity adds to the way of %who goes with Δt, not with Δt²</source>
        <translation>Was die Schwerkraft für %who zum Weg hinzufügt, geht mit Δt, nicht mit Δt²</translation>
    </message>
    <message>
        <source>A way is a length, as g Δt² is; g Δt is a velocity and g an acceleration.</source>
        <translation>Ein Weg ist eine Länge, wie g Δt²; g Δt ist eine Geschwindigkeit und g eine Beschleunigung.</translation>
    </message>
    <message>
        <source>Every step moves %who by a fixed way besides v Δt</source>
        <translation>Jeder Schritt bewegt %who außer um v Δt um einen festen Weg</translation>
    </message>
    <message>
        <source>Something besides its own velocity moves %who</source>
        <translation>Außer der eigenen Geschwindigkeit bewegt noch etwas %who</translation>
    </message>
    <message>
        <source>What a step adds to the way of %who besides v Δt is no method&apos;s</source>
        <translation>Was ein Schritt für %who außer v Δt zum Weg hinzufügt, ist von keinem Verfahren</translation>
    </message>
    <message>
        <source>Besides v Δt it goes %1 m in a step of %2 s under gravity %3 m/s², and %4 m in one of %5 s. Euler adds nothing to v Δt, symplectic Euler g Δt², the exact methods ½ g Δt².</source>
        <translation>Außer v Δt kommt er unter der Schwerkraft %3 m/s² in einem Schritt von %2 s um %1 m weiter, und in einem von %5 s um %4 m. Euler fügt zu v Δt nichts hinzu, der symplektische Euler g Δt², die genauen Verfahren ½ g Δt².</translation>
    </message>
    <message>
        <source>The name `gravity` holds the value of the scene; look where your program has one of its own.</source>
        <translation>Der Name `gravity` enthält den Wert der Szene; sieh nach, wo dein Programm einen eigenen hat.</translation>
    </message>
    <message>
        <source>Something besides gravity accelerates %who</source>
        <translation>Außer der Schwerkraft beschleunigt noch etwas %who</translation>
    </message>
    <message>
        <source>Each time that is %1 m/s² more than gravity gives.</source>
        <translation>Das sind jedes Mal %1 m/s² mehr, als die Schwerkraft gibt.</translation>
    </message>
    <message>
        <source>The acceleration of %who is not that of gravity</source>
        <translation>Die Beschleunigung ist für %who nicht die der Schwerkraft</translation>
    </message>
    <message>
        <source>In one of %1 s it changes by %2 m/s, and should by %3 m/s.</source>
        <translation>In einem von %1 s ändert sie sich um %2 m/s und sollte es um %3 m/s.</translation>
    </message>
    <message>
        <source>How gravity acts on %who depends on the timestep</source>
        <translation>Wie die Schwerkraft auf %who wirkt, hängt vom Zeitschritt ab</translation>
    </message>
    <message>
        <source>In every step gravity must change its velocity: look for the line that does it, and at what is asked before it.</source>
        <translation>In jedem Schritt muss die Schwerkraft seine Geschwindigkeit ändern: Suche die Zeile, die das tut, und sieh dir an, was vor ihr gefragt wird.</translation>
    </message>
    <message>
        <source>The velocity of %who changes far from everything</source>
        <translation>Fern von allem ändert sich die Geschwindigkeit für %who</translation>
    </message>
    <message>
        <source>Thrown with %1 m/s, it has %2 m/s one step of %3 s later, far from every wall and every other circle; gravity gives it %4 m/s in a step. Look at which lines change its velocity there, and at what is asked before them.</source>
        <translation>Mit %1 m/s geworfen, hat er einen Schritt von %3 s später %2 m/s, fern von jeder Wand und jedem anderen Kreis; die Schwerkraft gibt ihm %4 m/s in einem Schritt. Sieh nach, welche Zeilen dort seine Geschwindigkeit ändern und was vor ihnen gefragt wird.</translation>
    </message>
    <message>
        <source>A slower one goes on as it should.</source>
        <translation>Ein langsamerer läuft weiter, wie er soll.</translation>
    </message>
    <message>
        <source>A faster one goes on as it should.</source>
        <translation>Ein schnellerer läuft weiter, wie er soll.</translation>
    </message>
    <message>
        <source>Look at what the lines that change the velocity take, and at what is asked before them.</source>
        <translation>Sieh dir an, was die Zeilen nehmen, die die Geschwindigkeit ändern, und was vor ihnen gefragt wird.</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² and with the velocity %2 m/s it changes by %3 m/s in a step of %4 s, with %5 m/s by %6 m/s; %7 and %8 m/s are right. Look at what the lines that change the velocity take, and at what is asked before them.</source>
        <translation>Unter der Schwerkraft %1 m/s² und mit der Geschwindigkeit %2 m/s ändert sie sich in einem Schritt von %4 s um %3 m/s, mit %5 m/s um %6 m/s; richtig sind %7 und %8 m/s. Sieh dir an, was die Zeilen nehmen, die die Geschwindigkeit ändern, und was vor ihnen gefragt wird.</translation>
    </message>
    <message>
        <source>The acceleration of %who depends on the place</source>
        <translation>Die Beschleunigung hängt für %who vom Ort ab</translation>
    </message>
    <message>
        <source>At rest under gravity %1 m/s² it is accelerated by %2 m/s² at %3 m and by %4 m/s² at %5 m; %6 and %7 m/s² are right.</source>
        <translation>In Ruhe unter der Schwerkraft %1 m/s² wird er bei %3 m mit %2 m/s² beschleunigt und bei %5 m mit %4 m/s²; richtig sind %6 und %7 m/s².</translation>
    </message>
    <message>
        <source>The velocity of %who changes by itself otherwise than asked</source>
        <translation>Die Geschwindigkeit ändert sich für %who durch sich selbst anders als verlangt</translation>
    </message>
    <message>
        <source>It had %1 m/s, and %2 m/s one step of %3 s later, with nothing near that it could hit. Look at the lines that turn it, and at what is asked before them: is it true although nothing touches?</source>
        <translation>Er hatte %1 m/s und einen Schritt von %3 s später %2 m/s; nichts, was zu treffen wäre, war nahe. Sieh dir die Zeilen an, die ihn umkehren, und was vor ihnen gefragt wird: Ist es wahr, obwohl nichts sich berührt?</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is accelerated by %2 m/s² for every m/s of its velocity; %3 is right.</source>
        <translation>Mit Δt = %1 s wird er je m/s seiner Geschwindigkeit mit %2 m/s² beschleunigt; richtig ist %3.</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is accelerated in x by %2 m/s² for every m/s of its velocity in x; %3 is right.</source>
        <translation>Mit Δt = %1 s wird er in x je m/s seiner Geschwindigkeit in x mit %2 m/s² beschleunigt; richtig ist %3.</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is accelerated in y by %2 m/s² for every m/s of its velocity in y; %3 is right.</source>
        <translation>Mit Δt = %1 s wird er in y je m/s seiner Geschwindigkeit in y mit %2 m/s² beschleunigt; richtig ist %3.</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is accelerated by %2 m/s² for every m/s of its velocity in x, and by %3 m/s² for every m/s in y; %4 and %5 are right.</source>
        <translation>Mit Δt = %1 s wird er je m/s seiner Geschwindigkeit in x mit %2 m/s² beschleunigt, und je m/s in y mit %3 m/s²; richtig sind %4 und %5.</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is %2 m/s².</source>
        <translation>Mit Δt = %1 s sind es %2 m/s².</translation>
    </message>
    <message>
        <source>It starts with %1 m/s, and has %2 m/s one step later; nothing that it could hit is near. Look at which lines change its velocity there, and at what is asked before them.</source>
        <translation>Am Start sind es %1 m/s, einen Schritt später %2 m/s; nichts, was zu treffen wäre, ist nahe. Sieh nach, welche Zeilen dort die Geschwindigkeit ändern und was vor ihnen gefragt wird.</translation>
    </message>
    <message>
        <source>It is the value that the scene has.</source>
        <translation>Das ist der Wert, den die Szene hat.</translation>
    </message>
    <message>
        <source>Look at what your program assigns to %1 before the first step.</source>
        <translation>Sieh dir an, was dein Programm vor dem ersten Schritt an %1 zuweist.</translation>
    </message>
    <message>
        <source>Behind `local`, %1 is the name of another variable: the scene keeps its own value.</source>
        <translation>Hinter `local` ist %1 der Name einer anderen Variablen: Die Szene behält ihren eigenen Wert.</translation>
    </message>
    <message>
        <source>Nothing in your program assigns to %1 before the first step: it is the value that the scene has.</source>
        <translation>Nichts in deinem Programm weist vor dem ersten Schritt etwas an %1 zu: Es ist der Wert, den die Szene hat.</translation>
    </message>
    <message>
        <source>Gravity is %1 m/s², not %2

So it is when the run begins.</source>
        <translation>Die Schwerkraft ist %1 m/s², nicht %2

So ist es, wenn der Lauf beginnt.</translation>
    </message>
    <message>
        <source>So it is when the run begins; in this step your own scene should have e = %1.</source>
        <translation>So ist es, wenn der Lauf beginnt; in diesem Schritt soll deine eigene Szene e = %1 haben.</translation>
    </message>
    <message>
        <source>What gravity adds to the way of %who does not depend on Δt</source>
        <translation>Was die Schwerkraft für %who zum Weg hinzufügt, hängt nicht von Δt ab</translation>
    </message>
    <message>
        <source>In a step of %1 s it keeps as much of it, %2 times: so what happens in a second depends on Δt.</source>
        <translation>In einem Schritt von %1 s behält er davon ebenso viel, das %2-Fache: So hängt von Δt ab, was in einer Sekunde geschieht.</translation>
    </message>
    <message>
        <source>Every step moves %who on from where circle %1 is</source>
        <translation>Jeder Schritt bewegt %who von dort weiter, wo Kreis %1 ist</translation>
    </message>
    <message>
        <source>Started with %1 m/s, its velocity changes by %2 m/s in the second step of %3 s; with every other circle at rest and elsewhere by %4 m/s.</source>
        <translation>Mit %1 m/s gestartet, ändert er im zweiten Schritt von %3 s seine Geschwindigkeit um %2 m/s; ruht jeder andere Kreis an einem anderen Ort, um %4 m/s.</translation>
    </message>
    <message>
        <source>The acceleration of %who is opposite to gravity</source>
        <translation>Die Beschleunigung ist für %who der Schwerkraft entgegengesetzt</translation>
    </message>
    <message>
        <source>Nothing changes the velocity of circle %1

In your own scene it has %2 m/s from the start to the end of %3 s, though it comes to a wall and to another circle. Both must give it a new velocity: look for where that is assigned.</source>
        <translation>Nichts ändert die Geschwindigkeit von Kreis %1

In deiner eigenen Szene hat er vom Start bis zum Ende von %3 s %2 m/s, obwohl er an eine Wand und an einen anderen Kreis kommt. Beides muss ihm eine neue Geschwindigkeit geben: Suche, wo diese zugewiesen wird.</translation>
    </message>
    <message>
        <source>Circle %1 does not move as its velocity says

At %2 s of your own scene it moves by %3 m in a step of %4 s; its velocity is still the %5 m/s of the start. A program that keeps velocities in variables of its own must also assign them to the circles, as to `circle%1.velocity`.

Until this is right, no more can be said of walls and hits.</source>
        <translation>Kreis %1 bewegt sich anders, als seine Geschwindigkeit sagt

Bei %2 s deiner eigenen Szene bewegt er sich in einem Schritt von %4 s um %3 m; seine Geschwindigkeit ist noch die %5 m/s vom Start. Ein Programm, das Geschwindigkeiten in eigenen Variablen hält, muss sie auch den Kreisen zuweisen, etwa `circle%1.velocity`.

Bevor das stimmt, lässt sich über Wände und Stöße nichts Weiteres sagen.</translation>
    </message>
    <message>
        <source>Circle %1 does not move as its velocity says

At %2 s of your own scene it moves by %3 m in a step of %4 s; its velocity is %5 m/s, of which the %6 is still that of the start. A program that keeps velocities in variables of its own must assign both parts of them to the circles, as to `circle%1.velocity`.

Until this is right, no more can be said of walls and hits.</source>
        <translation>Kreis %1 bewegt sich anders, als seine Geschwindigkeit sagt

Bei %2 s deiner eigenen Szene bewegt er sich in einem Schritt von %4 s um %3 m; seine Geschwindigkeit ist %5 m/s, und deren %6 ist noch das vom Start. Ein Programm, das Geschwindigkeiten in eigenen Variablen hält, muss beide Anteile den Kreisen zuweisen, etwa `circle%1.velocity`.

Bevor das stimmt, lässt sich über Wände und Stöße nichts Weiteres sagen.</translation>
    </message>
    <message>
        <source>Look at what the line that changes the position takes, and at what is asked before it.</source>
        <translation>Sieh dir an, was die Zeile nimmt, die den Ort ändert, und was vor ihr gefragt wird.</translation>
    </message>
    <message>
        <source>The method that moves %who depends on the velocity</source>
        <translation>Das Verfahren, das %who bewegt, hängt von der Geschwindigkeit ab</translation>
    </message>
    <message>
        <source>Where nothing rubs, a push points along the normal only.</source>
        <translation>Wo nichts reibt, wirkt ein Stoß nur längs der Normalen.</translation>
    </message>
    <message>
        <source>Hits at the %walls hold %who and turn no velocity round</source>
        <translation>Stöße an %walls halten %who auf und kehren keine Geschwindigkeit um</translation>
    </message>
    <message>
        <source>At the %walls the way of %who turns round, not its velocity</source>
        <translation>An %walls kehrt der Weg von %who um, nicht seine Geschwindigkeit</translation>
    </message>
    <message>
        <source>Hits at the %walls turn the velocity of %who round too late</source>
        <translation>Stöße an %walls kehren die Geschwindigkeit zu spät um, für %who</translation>
    </message>
    <message>
        <source>It is put back at once, and its velocity points away from the wall only %1 s later.</source>
        <translation>Der Kreis wird sofort zurückgesetzt, und erst %1 s später zeigt seine Geschwindigkeit von der Wand weg.</translation>
    </message>
    <message>
        <source>In every step it is kept from going on, and its velocity still points into it.</source>
        <translation>In jedem Schritt kommt der Kreis nicht weiter, und seine Geschwindigkeit zeigt weiter in sie hinein.</translation>
    </message>
    <message>
        <source>It is kept from going on, and its velocity stays as it was.</source>
        <translation>Der Kreis kommt nicht weiter, und seine Geschwindigkeit bleibt, wie sie war.</translation>
    </message>
    <message>
        <source>It goes back from the wall while its velocity still points into it: look at what is assigned to that.</source>
        <translation>Er geht von der Wand zurück, während seine Geschwindigkeit noch hineinzeigt: Sieh nach, was ihr zugewiesen wird.</translation>
    </message>
    <message>
        <source>At the %walls %who gets the velocity of the other circle</source>
        <translation>An %walls bekommt %who die Geschwindigkeit des anderen Kreises</translation>
    </message>
    <message>
        <source>The other circle had %1 m/s. Look at whose velocity the line takes.</source>
        <translation>Der andere Kreis hatte %1 m/s. Sieh dir an, wessen Geschwindigkeit die Zeile nimmt.</translation>
    </message>
    <message>
        <source>Hits at the %walls turn the wrong part of the velocity of %who</source>
        <translation>Stöße an %walls kehren für %who den falschen Anteil der Geschwindigkeit um</translation>
    </message>
    <message>
        <source>Hits at the %walls turn the whole velocity of %who round</source>
        <translation>Stöße an %walls kehren für %who die ganze Geschwindigkeit um</translation>
    </message>
    <message>
        <source>At the %walls e also shortens the part of %who along the wall</source>
        <translation>An %walls verkürzt e für %who auch den Anteil längs der Wand</translation>
    </message>
    <message>
        <source>At the %walls e acts on the wrong part of the velocity of %who</source>
        <translation>An %walls wirkt e für %who auf den falschen Anteil der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Hits at the %walls turn the part of %who along the wall round, too</source>
        <translation>Stöße an %walls kehren für %who auch den Anteil längs der Wand um</translation>
    </message>
    <message>
        <source>Hits at the %walls take the part of %who along the wall away</source>
        <translation>Stöße an %walls nehmen für %who den Anteil längs der Wand weg</translation>
    </message>
    <message>
        <source>Hits at the %walls change the part of %who along the wall</source>
        <translation>Stöße an %walls ändern für %who den Anteil längs der Wand</translation>
    </message>
    <message>
        <source>At the %walls a number stands for e, for %who</source>
        <translation>An %walls steht für %who eine Zahl statt e</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who %1 e of the speed back, not e</source>
        <translation>An %walls kommt für %who das Tempo mal %1 e zurück, nicht mal e</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who a speed of their own</source>
        <translation>Stöße an %walls geben für %who ein eigenes Tempo vor</translation>
    </message>
    <message>
        <source>With e = %1 a hit with %2 m/s into the wall gives %3 times the speed back, one with %4 m/s %5 times: the share should be the same for every speed.</source>
        <translation>Mit e = %1 gibt ein Stoß mit %2 m/s in die Wand das %3-Fache des Tempos zurück, einer mit %4 m/s das %5-Fache: Der Anteil soll für jedes Tempo derselbe sein.</translation>
    </message>
    <message>
        <source>With e = %1 it is %2 times the speed, with e = %3 %4 times.</source>
        <translation>Mit e = %1 ist es das %2-Fache des Tempos, mit e = %3 das %4-Fache.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who between %1 and %2 times the speed back</source>
        <translation>An %walls kommt für %who das %1- bis %2-Fache des Tempos zurück</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who %1 times the speed back</source>
        <translation>An %walls kommt für %who das %1-Fache des Tempos zurück</translation>
    </message>
    <message>
        <source>Look at what the new velocity is worked out from.</source>
        <translation>Sieh dir an, woraus die neue Geschwindigkeit berechnet wird.</translation>
    </message>
    <message>
        <source>The least came at the %1 with %2 m/s into it, the most at the %3 with %4 m/s.</source>
        <translation>Am wenigsten kam an %1 mit %2 m/s hinein zurück, am meisten an %3 mit %4 m/s.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who all of the speed back</source>
        <translation>An %walls kommt für %who das ganze Tempo zurück</translation>
    </message>
    <message>
        <source>At the %walls e acts on %who twice</source>
        <translation>An %walls wirkt e zweimal auf %who</translation>
    </message>
    <message>
        <source>At the %walls the root of e acts on %who</source>
        <translation>An %walls wirkt die Wurzel aus e auf %who</translation>
    </message>
    <message>
        <source>Of the part along the normal nothing comes back.</source>
        <translation>Vom Anteil längs der Normalen kommt nichts zurück.</translation>
    </message>
    <message>
        <source>At the %walls 1 − e stands where e belongs, for %who</source>
        <translation>An %walls steht für %who 1 − e, wo e hingehört</translation>
    </message>
    <message>
        <source>At the %walls 1 + e stands where e belongs, for %who</source>
        <translation>An %walls steht für %who 1 + e, wo e hingehört</translation>
    </message>
    <message>
        <source>Hits at the %walls slow %who and turn nothing round</source>
        <translation>Stöße an %walls bremsen %who und kehren nichts um</translation>
    </message>
    <message>
        <source>Here e is %1. </source>
        <translation>Hier ist e = %1. </translation>
    </message>
    <message>
        <source>walls</source>
        <comment>behind: at the</comment>
        <translation>den Wänden</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <comment>walls</comment>
        <extracomment>&quot;left wall, floor&quot; and &quot;ceiling&quot;</extracomment>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2 came to the %3 at %4 m with %5 m/s and went on past it at first.</source>
        <translation>Nach %1 s seines Laufs kam Kreis %2 bei %4 m mit %5 m/s an %3 an und lief erst einmal darüber hinaus.</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s, circle %3 went on past it. Look at what your program asks for it, and whether the answer is ever yes.</source>
        <translation>Mit %2 m/s zu %1 geworfen, ging Kreis %3 darüber hinaus. Sieh dir an, was dein Programm dafür fragt und ob die Antwort je Ja ist.</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round too early</source>
        <translation>Stöße an %walls lassen %who zu früh umkehren</translation>
    </message>
    <message>
        <source>At the %walls the centre of %who is asked for, not the rim</source>
        <translation>An %walls wird für %who nach dem Mittelpunkt gefragt, nicht nach dem Rand</translation>
    </message>
    <message>
        <source>At the %walls the radius of another circle stands for that of %who</source>
        <translation>An %walls steht der Radius eines anderen Kreises statt des eigenen (%who)</translation>
    </message>
    <message>
        <source>At the %walls the larger radius stands for that of %who</source>
        <translation>An %walls steht der größere Radius statt des eigenen (%who)</translation>
    </message>
    <message>
        <source>At the %walls the smaller radius stands for that of %who</source>
        <translation>An %walls steht der kleinere Radius statt des eigenen (%who)</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round too late</source>
        <translation>Stöße an %walls lassen %who zu spät umkehren</translation>
    </message>
    <message>
        <source>At the %walls a number stands for the radius of %who</source>
        <translation>An %walls steht für %who eine Zahl statt des Radius</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round at the far side of the rim</source>
        <translation>Stöße an %walls lassen %who erst am hinteren Rand umkehren</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round a whole second too early</source>
        <translation>Stöße an %walls lassen %who eine ganze Sekunde zu früh umkehren</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round at the wrong place</source>
        <translation>Stöße an %walls lassen %who am falschen Ort umkehren</translation>
    </message>
    <message>
        <source>Slow hits at the %walls give %who another share of the speed back</source>
        <translation>Von langsamen Stößen an %walls kommt für %who ein anderer Teil des Tempos zurück</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and left it with %4 times that speed; %5 times is right, however slow it is.</source>
        <translation>Kreis %1 kam mit %3 m/s an %2 an und verließ sie mit dem %4-Fachen dieses Tempos; das %5-Fache ist richtig, wie langsam er auch ist.</translation>
    </message>
    <message>
        <source>Hits at the %walls put %who somewhere else</source>
        <translation>Stöße an %walls versetzen %who</translation>
    </message>
    <message>
        <source>At the %1 circle %4 was put %2 m away from its own path, at %3 m.</source>
        <translation>An %1 wurde Kreis %4 um %2 m von seiner eigenen Bahn weg gesetzt, auf %3 m.</translation>
    </message>
    <message>
        <source>There the other circle was: each circle goes back to its *own* place.</source>
        <translation>Dort war der andere Kreis: Jeder Kreis geht an seinen *eigenen* Ort zurück.</translation>
    </message>
    <message>
        <source>It belongs where its rim is at the wall, or back where it was before that step.</source>
        <translation>Er gehört dorthin, wo sein Rand an der Wand ist, oder zurück, wo er vor diesem Schritt war.</translation>
    </message>
    <message>
        <source>Hits at the %walls put %who further out</source>
        <translation>Stöße an %walls setzen %who weiter nach außen</translation>
    </message>
    <message>
        <source>At the %1 the centre of circle %5 would have come to %2 m from the wall and was put %3 m from it; its radius is %4 m. Put it where its rim is at the wall, or back where it came from.</source>
        <translation>An %1 wäre der Mittelpunkt von Kreis %5 auf %2 m an die Wand herangekommen und wurde auf %3 m gesetzt; der Radius ist %4 m. Setze den Kreis dorthin, wo sein Rand an der Wand ist, oder zurück, woher er kam.</translation>
    </message>
    <message>
        <source>When circle %1 was %2 m from the %3 its velocity changed, and in the same step that of the other, far from it and from every wall. A wall turns the circle that touches it, and no other.</source>
        <translation>Als Kreis %1 noch %2 m von %3 entfernt war, änderte sich seine Geschwindigkeit und im selben Schritt die des anderen, der weit von ihm und von jeder Wand war. Eine Wand lässt den Kreis umkehren, der sie berührt, und keinen anderen.</translation>
    </message>
    <message>
        <source>Hits at the %walls leave %who outside</source>
        <translation>Stöße an %walls lassen %who draußen</translation>
    </message>
    <message>
        <source>After the hit the rim of circle %1 is %2 m past the %3, and its velocity takes it back by %4 m a step: slower than it came, it is still outside after the next one. Put it where its rim is at the wall, or back where it came from.</source>
        <translation>Nach dem Stoß ist der Rand von Kreis %1 um %2 m jenseits von: %3, und seine Geschwindigkeit bringt ihn um %4 m je Schritt zurück: langsamer, als er kam, ist er auch nach dem nächsten noch draußen. Setze den Kreis dorthin, wo sein Rand an der Wand ist, oder zurück, woher er kam.</translation>
    </message>
    <message>
        <source>Hits at the %walls put %who too far in</source>
        <translation>Stöße an %walls setzen %who zu weit nach innen</translation>
    </message>
    <message>
        <source>At the %1 the centre of circle %5 was %2 m from the wall before that step and was put %3 m from it; its radius is %4 m, so that there is a gap. Put it where its rim is at the wall, or back where it came from.</source>
        <translation>An %1 war der Mittelpunkt von Kreis %5 vor diesem Schritt %2 m von der Wand entfernt und wurde auf %3 m gesetzt; der Radius ist %4 m, also bleibt eine Lücke. Setze den Kreis dorthin, wo sein Rand an der Wand ist, oder zurück, woher er kam.</translation>
    </message>
    <message>
        <source>In the step in which circle %1 was answered by the %2, the other circle, far from every wall, did not go on freely: its place is %3 m and its velocity %4 m/s off. A wall acts on the circle that touches it, and on no other.</source>
        <translation>In dem Schritt, in dem Kreis %1 an %2 ankam, lief der andere Kreis, weit von jeder Wand, nicht frei weiter: Sein Ort liegt um %3 m und seine Geschwindigkeit um %4 m/s daneben. Eine Wand wirkt auf den Kreis, der sie berührt, und auf keinen anderen.</translation>
    </message>
    <message>
        <source>Circle %3 came with %1 m/s and left with %2 m/s. Both walls are hit in the same step, and each must turn its own part, whichever comes first.</source>
        <translation>Kreis %3 kam mit %1 m/s an und ging mit %2 m/s weg. Beide Wände werden im selben Schritt getroffen, und jede muss ihren Anteil umkehren, welche auch zuerst kommt.</translation>
    </message>
    <message>
        <source>circle 1 came with %1 m/s, circle 2 with %2 m/s</source>
        <translation>Kreis 1 kam mit %1 m/s, Kreis 2 mit %2 m/s</translation>
    </message>
    <message>
        <source>near %1 m</source>
        <translation>bei %1 m</translation>
    </message>
    <message>
        <source>They touched, their places were changed and their velocities kept, until they moved apart.</source>
        <translation>Sie berührten sich, ihre Orte wurden geändert und ihre Geschwindigkeiten behalten, bis sie sich voneinander entfernten.</translation>
    </message>
    <message>
        <source>They ran into each other until their centres were %1 m apart, and were answered when that grew again.</source>
        <translation>Sie liefen ineinander, bis ihre Mittelpunkte %1 m voneinander entfernt waren, und wurden beantwortet, als das wieder wuchs.</translation>
    </message>
    <message>
        <source>Circles that come nearer have a positive closing speed (v₁ − v₂)·n, with n from 1 to 2: look at the comparison, and at which way your normal points.</source>
        <translation>Kreise, die sich nähern, haben eine positive Annäherungsgeschwindigkeit (v₁ − v₂)·n mit n von 1 nach 2: Sieh dir den Vergleich an, und wohin deine Normale zeigt.</translation>
    </message>
    <message>
        <source>circle 2 is to the right of circle 1</source>
        <translation>Kreis 2 rechts von Kreis 1 ist</translation>
    </message>
    <message>
        <source>circle 2 is to the left of circle 1</source>
        <translation>Kreis 2 links von Kreis 1 ist</translation>
    </message>
    <message>
        <source>circle 2 is above circle 1</source>
        <translation>Kreis 2 über Kreis 1 ist</translation>
    </message>
    <message>
        <source>circle 2 is below circle 1</source>
        <translation>Kreis 2 unter Kreis 1 ist</translation>
    </message>
    <message>
        <source>circle %1 is at rest</source>
        <translation>Kreis %1 ruht</translation>
    </message>
    <message>
        <source>circle %1 comes towards circle %2</source>
        <translation>Kreis %1 auf Kreis %2 zukommt</translation>
    </message>
    <message>
        <source>circle %1 moves away from circle %2</source>
        <translation>Kreis %1 sich von Kreis %2 entfernt</translation>
    </message>
    <message>
        <source>circle %1 is the faster one along the line of centres</source>
        <translation>Kreis %1 entlang der Verbindungslinie der Mittelpunkte der schnellere ist</translation>
    </message>
    <message>
        <source>circle %1 is the faster one</source>
        <translation>Kreis %1 der schnellere ist</translation>
    </message>
    <message>
        <source>both move the same way along the line of centres</source>
        <translation>sich beide entlang der Verbindungslinie der Mittelpunkte in dieselbe Richtung bewegen</translation>
    </message>
    <message>
        <source>both come towards each other</source>
        <translation>beide aufeinander zukommen</translation>
    </message>
    <message>
        <source>one of them is at rest</source>
        <translation>einer von ihnen ruht</translation>
    </message>
    <message>
        <source>both are equally fast along the line of centres</source>
        <translation>beide entlang der Verbindungslinie der Mittelpunkte gleich schnell sind</translation>
    </message>
    <message>
        <source>both are equally fast</source>
        <translation>beide gleich schnell sind</translation>
    </message>
    <message>
        <source>circle %1 moves to the right</source>
        <translation>sich Kreis %1 nach rechts bewegt</translation>
    </message>
    <message>
        <source>circle %1 moves to the left</source>
        <translation>sich Kreis %1 nach links bewegt</translation>
    </message>
    <message>
        <source>circle %1 moves upward</source>
        <translation>sich Kreis %1 nach oben bewegt</translation>
    </message>
    <message>
        <source>circle %1 moves downward</source>
        <translation>sich Kreis %1 nach unten bewegt</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves to the right</source>
        <translation>sich Kreis 1, von Kreis 2 aus gesehen, nach rechts bewegt</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves to the left</source>
        <translation>sich Kreis 1, von Kreis 2 aus gesehen, nach links bewegt</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves upward</source>
        <translation>sich Kreis 1, von Kreis 2 aus gesehen, nach oben bewegt</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves downward</source>
        <translation>sich Kreis 1, von Kreis 2 aus gesehen, nach unten bewegt</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves away from (0, 0)</source>
        <translation>sich Kreis 1, von Kreis 2 aus gesehen, von (0, 0) entfernt</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves towards (0, 0)</source>
        <translation>sich Kreis 1, von Kreis 2 aus gesehen, auf (0, 0) zubewegt</translation>
    </message>
    <message>
        <source>circle %1 is the larger one</source>
        <translation>Kreis %1 der größere ist</translation>
    </message>
    <message>
        <source>circle %1 is the heavier one</source>
        <translation>Kreis %1 der schwerere ist</translation>
    </message>
    <message>
        <source>circle %1 is the denser one</source>
        <translation>Kreis %1 der dichtere ist</translation>
    </message>
    <message>
        <source>both are equally large</source>
        <translation>beide gleich groß sind</translation>
    </message>
    <message>
        <source>both are equally heavy</source>
        <translation>beide gleich schwer sind</translation>
    </message>
    <message>
        <source>both are equally dense</source>
        <translation>beide gleich dicht sind</translation>
    </message>
    <message>
        <source>Circle 2 was hit, was back from the wall close behind it within a few steps and ran into circle 1 without an answer; from a wall farther off it gets one. What counts is whether they overlap and come nearer, not when the last hit was, nor whether a wall is near.</source>
        <translation>Kreis 2 wurde gestoßen, war innerhalb weniger Schritte von der Wand dicht hinter ihm zurück und lief ohne Antwort in Kreis 1; von einer ferneren Wand bekommt er eine. Es zählt, ob sie sich überlappen und einander nähern, nicht, wann der letzte Stoß war oder ob eine Wand nahe ist.</translation>
    </message>
    <message>
        <source>Circle 2 was hit, came back from the wall behind it and ran through circle 1. What counts is whether they overlap and come nearer: look at what else is asked, and at what your program keeps of a hit.</source>
        <translation>Kreis 2 wurde gestoßen, kam von der Wand hinter ihm zurück und lief durch Kreis 1. Es zählt, ob sie sich überlappen und einander nähern: Sieh dir an, was sonst gefragt wird und was dein Programm von einem Stoß behält.</translation>
    </message>
    <message>
        <source>In all these hits the new part of circle %1 along that line was %2 times that of circle 1 before the hit and %3 times that of circle 2; right is %4 and %5 times.</source>
        <translation>In allen diesen Stößen war der neue Anteil von Kreis %1 entlang dieser Linie das %2-Fache des Anteils von Kreis 1 vor dem Stoß und das %3-Fache dessen von Kreis 2; richtig ist das %4- und das %5-Fache.</translation>
    </message>
    <message>
        <source>The push has a wrong size that depends on the radius</source>
        <translation>Der Kraftstoß hat eine falsche Größe, die vom Radius abhängt</translation>
    </message>
    <message>
        <source>With r = %1 m for both the push is %2 times as large as it should be, with r = %3 m it is %4 times.</source>
        <translation>Mit r = %1 m für beide ist der Kraftstoß %2-mal so groß, wie er sein soll, mit r = %3 m %4-mal.</translation>
    </message>
    <message>
        <source>The push has a wrong size that depends on the circles</source>
        <translation>Der Kraftstoß hat eine falsche Größe, die von den Kreisen abhängt</translation>
    </message>
    <message>
        <source>With r = %1 m and ρ = %2 for both the push is %3 times as large as it should be, with r = %4 m and ρ = %5 it is %6 times.</source>
        <translation>Mit r = %1 m und ρ = %2 für beide ist der Kraftstoß %3-mal so groß, wie er sein soll, mit r = %4 m und ρ = %5 %6-mal.</translation>
    </message>
    <message>
        <source>The push has a wrong size that depends on the timestep</source>
        <translation>Der Kraftstoß hat eine falsche Größe, die vom Zeitschritt abhängt</translation>
    </message>
    <message>
        <source>With a timestep of %1 s the push is %2 times as large as it should be, and with %3 s about %4 times.</source>
        <translation>Mit einem Zeitschritt von %1 s ist der Kraftstoß %2-mal so groß, wie er sein soll, und mit %3 s etwa %4-mal.</translation>
    </message>
    <message>
        <source>Only circle %1 leaves a hit as it should</source>
        <translation>Nur Kreis %1 verlässt einen Stoß, wie er soll</translation>
    </message>
    <message>
        <source>Hits at the %walls take the part of %who along the normal away</source>
        <translation>Stöße an %walls nehmen für %who den Anteil längs der Normalen weg</translation>
    </message>
    <message>
        <source>Some meetings are answered before they touch</source>
        <translation>Manche Begegnungen werden beantwortet, bevor die Kreise sich berühren</translation>
    </message>
    <message>
        <source>Some meetings are answered too late</source>
        <translation>Manche Begegnungen werden zu spät beantwortet</translation>
    </message>
    <message>
        <source>Circle %1 does not keep its part across in a hit</source>
        <translation>Kreis %1 behält im Stoß seinen Anteil quer nicht</translation>
    </message>
    <message>
        <source>From every start tried the two are at the same place one step later. Each circle has a place and a velocity of its own and goes on from those: look at what the lines for one take from the other.</source>
        <translation>Nach jedem versuchten Start sind die beiden einen Schritt später am selben Ort. Jeder Kreis hat einen eigenen Ort und eine eigene Geschwindigkeit und geht von diesen weiter: Sieh nach, was die Zeilen für den einen vom anderen nehmen.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later, and so it has from every other start tried. A step works the new velocity out from the one that the circle has, which a hit may have changed; a start is set once, in `on_load`.</source>
        <translation>Mit %1 m/s gestartet, hat er einen Schritt später %2 m/s, und das nach jedem anderen versuchten Start. Ein Schritt rechnet die neue Geschwindigkeit aus der aus, die der Kreis hat und die ein Stoß geändert haben kann; der Start wird einmal gesetzt, in `on_load`.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later, and that part is the same from every other start tried. A step works each part out from the one that the circle has, and keeps it for the next.</source>
        <translation>Mit %1 m/s gestartet, sind es einen Schritt später %2 m/s, und dieser Anteil ist nach jedem anderen versuchten Start derselbe. Ein Schritt rechnet jeden Anteil aus dem aus, den der Kreis hat, und behält ihn für den nächsten.</translation>
    </message>
    <message>
        <source>From every start tried the two are near each other one step later. Each circle goes on from its own place: look at the names in the line that moves it.</source>
        <translation>Nach jedem versuchten Start sind die beiden einen Schritt später nahe beieinander. Jeder Kreis geht von seinem eigenen Ort weiter: Sieh dir die Namen in der Zeile an, die ihn bewegt.</translation>
    </message>
    <message>
        <source>Look at what your program asks there, and at what it keeps from one step to the next.</source>
        <translation>Sieh dir an, was dein Programm dort fragt und was es von einem Schritt zum nächsten behält.</translation>
    </message>
    <message>
        <source>With all radii tried they answer at the same distance, between %1 and %2 m.</source>
        <translation>Mit allen versuchten Radien antworten sie beim selben Abstand, zwischen %1 und %2 m.</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered in time.</source>
        <translation>
            <numerusform>Von %1 versuchten Begegnungen wurde %n rechtzeitig beantwortet.</numerusform>
            <numerusform>Von %1 versuchten Begegnungen wurden %n rechtzeitig beantwortet.</numerusform>
        </translation>
    </message>
    <message>
        <source>This one came out wrong: %1.</source>
        <translation>Diese ging falsch aus: %1.</translation>
    </message>
    <message>
        <source>This one was answered in time: %1.</source>
        <translation>Diese wurde rechtzeitig beantwortet: %1.</translation>
    </message>
    <message>
        <source>Look at what changes from one side to the other: the sign of a difference, or an angle.</source>
        <translation>Sieh dir an, was sich von einer Seite zur anderen ändert: das Vorzeichen einer Differenz oder ein Winkel.</translation>
    </message>
    <message>
        <source>A hit is due where they overlap and come nearer along the line of centres, and nowhere else.</source>
        <translation>Ein Stoß ist fällig, wo sie sich überlappen und entlang der Verbindungslinie der Mittelpunkte näher kommen, sonst nirgends.</translation>
    </message>
    <message>
        <source>Some hits do not act along the line of centres</source>
        <translation>Manche Stöße wirken nicht entlang der Verbindungslinie der Mittelpunkte</translation>
    </message>
    <message>
        <source>Some hits of the two circles are answered too late</source>
        <translation>Manche Stöße der beiden Kreise werden zu spät beantwortet</translation>
    </message>
    <message>
        <source>Some hits of the two circles are not answered</source>
        <translation>Manche Stöße der beiden Kreise bleiben unbeantwortet</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered in time and along the line of centres: %2.</source>
        <translation>
            <numerusform>Von %1 versuchten Begegnungen wurde %n rechtzeitig und entlang der Verbindungslinie der Mittelpunkte beantwortet: %2.</numerusform>
            <numerusform>Von %1 versuchten Begegnungen wurden %n rechtzeitig und entlang der Verbindungslinie der Mittelpunkte beantwortet: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered in time: %2.</source>
        <translation>
            <numerusform>Von %1 versuchten Begegnungen wurde %n rechtzeitig beantwortet: %2.</numerusform>
            <numerusform>Von %1 versuchten Begegnungen wurden %n rechtzeitig beantwortet: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>their line of centres at %1°</source>
        <translation>die Verbindungslinie ihrer Mittelpunkte bei %1°</translation>
    </message>
    <message>
        <source>At every timestep, gravity and velocity tried it goes on by %1 m besides. Look at what is added to the position.</source>
        <translation>Bei jedem versuchten Δt, jeder Schwerkraft und jeder Geschwindigkeit kommen %1 m hinzu. Sieh dir an, was zum Ort addiert wird.</translation>
    </message>
    <message>
        <source>At every gravity and velocity tried it goes on by %1 m/s times Δt besides. Look at what is added to the position.</source>
        <translation>Bei jeder versuchten Schwerkraft und Geschwindigkeit kommen %1 m/s mal Δt hinzu. Sieh dir an, was zum Ort addiert wird.</translation>
    </message>
    <message>
        <source>At every timestep tried gravity acts for %1 s. Take the parameter of `on_update`.</source>
        <translation>Bei jedem versuchten Zeitschritt wirkt die Schwerkraft %1 s lang. Nimm den Parameter von `on_update`.</translation>
    </message>
    <message>
        <source>At times gravity acts wrongly on %who</source>
        <translation>Manchmal wirkt die Schwerkraft falsch auf %who</translation>
    </message>
    <message>
        <source>At times the velocity of %who changes wrongly</source>
        <translation>Manchmal ändert sich die Geschwindigkeit falsch (%who)</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2, at %3 m and touching nothing, changed its velocity by %4 m/s in a step of %5 s; %6 m/s is right.</source>
        <translation>Nach %1 s seines Laufs änderte Kreis %2 bei %3 m, ohne etwas zu berühren, seine Geschwindigkeit in einem Schritt von %5 s um %4 m/s; richtig ist %6 m/s.</translation>
    </message>
    <message>
        <source>At times the way of %who in a step is not v Δt</source>
        <translation>Manchmal ist der Weg eines Schritts nicht v Δt (%who)</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2, at %3 m and touching nothing, went %4 m in a step of %5 s; %6 m is right.</source>
        <translation>Nach %1 s seines Laufs kam Kreis %2 bei %3 m, ohne etwas zu berühren, in einem Schritt von %5 s um %4 m weiter; richtig ist %6 m.</translation>
    </message>
    <message>
        <source>At times the motion of %who is not %1</source>
        <translation>Manchmal ist die Bewegung nicht %1 (%who)</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2, at %3 m and touching nothing, went %4 m in a step of %5 s; by that method it is %6 m.</source>
        <translation>Nach %1 s seines Laufs kam Kreis %2 bei %3 m, ohne etwas zu berühren, in einem Schritt von %5 s um %4 m weiter; nach jenem Verfahren sind es %6 m.</translation>
    </message>
    <message>
        <source>the exact parabola</source>
        <translation>die genaue Parabel</translation>
    </message>
    <message>
        <source>The acceleration of %who depends wrongly on the velocity</source>
        <translation>Die Beschleunigung hängt falsch von der Geschwindigkeit ab (%who)</translation>
    </message>
    <message>
        <source>Far from everything the velocity of %who turns round</source>
        <translation>Fern von allem kehrt sich die Geschwindigkeit um (%who)</translation>
    </message>
    <message>
        <source>%1, where circle %2 was</source>
        <translation>%1, wo Kreis %2 war</translation>
    </message>
    <message>
        <source>Some hits of the two circles come out wrong</source>
        <translation>Manche Stöße der beiden Kreise gehen falsch aus</translation>
    </message>
    <message>
        <source>%1, for circle %2 alone</source>
        <translation>%1, nur für Kreis %2</translation>
    </message>
    <message>
        <source>With every e tried the rebound is that of e = %1.</source>
        <translation>Mit jedem versuchten e ist der Rückprall der von e = %1.</translation>
    </message>
    <message>
        <source>With every e tried circle 1 answers as with e = %1 and circle 2 as with e = %2.</source>
        <translation>Mit jedem versuchten e antwortet Kreis 1 wie mit e = %1 und Kreis 2 wie mit e = %2.</translation>
    </message>
    <message>
        <source>Two equal circles exchange their whole velocities</source>
        <translation>Zwei gleiche Kreise tauschen ihre ganzen Geschwindigkeiten</translation>
    </message>
    <message>
        <source>After an elastic hit the circles do not part</source>
        <translation>Nach einem elastischen Stoß trennen sich die Kreise nicht</translation>
    </message>
    <message>
        <source>Along the line of centres, from 1 to 2, circle 1 came with %1 m/s and circle 2 with %2 m/s; they left with %3 and %4; %5 and %6 are right.</source>
        <translation>Entlang der Verbindungslinie der Mittelpunkte, von 1 nach 2, kam Kreis 1 mit %1 m/s und Kreis 2 mit %2 m/s; danach hatten sie %3 und %4; richtig sind %5 und %6.</translation>
    </message>
    <message>
        <source>Across the line of centres circle 1 came with %1 m/s and circle 2 with %2 m/s; they left with %3 and %4; %5 and %6 are right.</source>
        <translation>Quer zur Verbindungslinie der Mittelpunkte kam Kreis 1 mit %1 m/s und Kreis 2 mit %2 m/s; danach hatten sie %3 und %4; richtig sind %5 und %6.</translation>
    </message>
    <message>
        <source>of each circle in a run</source>
        <translation>jedes Kreises eines Laufs</translation>
    </message>
    <message>
        <source>of each circle at each wall in a run</source>
        <translation>jedes Kreises an jeder Wand eines Laufs</translation>
    </message>
    <message>
        <source>in a run</source>
        <translation>eines Laufs</translation>
    </message>
    <message>
        <source>all that came %1 s or more after the one before, none that came within %2 s</source>
        <translation>alle, die %1 s oder mehr nach dem vorigen kamen, keine innerhalb von %2 s</translation>
    </message>
    <message>
        <source>all up to %1 s of a run, none from %2 s on</source>
        <translation>alle bis %1 s eines Laufs, keine ab %2 s</translation>
    </message>
    <message>
        <source>all from %1 s of a run on, none up to %2 s</source>
        <translation>alle ab %1 s eines Laufs, keine bis %2 s</translation>
    </message>
    <message>
        <source>all at y = %1 m and above, none at y = %2 m and below</source>
        <translation>alle bei y = %1 m und darüber, keine bei y = %2 m und darunter</translation>
    </message>
    <message>
        <source>all at y = %1 m and below, none at y = %2 m and above</source>
        <translation>alle bei y = %1 m und darunter, keine bei y = %2 m und darüber</translation>
    </message>
    <message>
        <source>all at x = %1 m and left of it, none at x = %2 m and right of it</source>
        <translation>alle bei x = %1 m und links davon, keine bei x = %2 m und rechts davon</translation>
    </message>
    <message>
        <source>all at x = %1 m and right of it, none at x = %2 m and left of it</source>
        <translation>alle bei x = %1 m und rechts davon, keine bei x = %2 m und links davon</translation>
    </message>
    <message>
        <source>all with up to %1 m/s, none with %2 m/s or more</source>
        <translation>alle mit höchstens %1 m/s, keine mit %2 m/s oder mehr</translation>
    </message>
    <message>
        <source>all with %1 m/s or more, none with up to %2 m/s</source>
        <translation>alle mit %1 m/s oder mehr, keine mit höchstens %2 m/s</translation>
    </message>
    <message>
        <source>all with up to %1 m/s into the wall, none with %2 m/s or more</source>
        <translation>alle mit höchstens %1 m/s in die Wand hinein, keine mit %2 m/s oder mehr</translation>
    </message>
    <message>
        <source>all with %1 m/s or more into the wall, none with up to %2 m/s</source>
        <translation>alle mit %1 m/s oder mehr in die Wand hinein, keine mit höchstens %2 m/s</translation>
    </message>
    <message>
        <source>all with up to %1 m/s along the wall, none with %2 m/s or more</source>
        <translation>alle mit höchstens %1 m/s längs der Wand, keine mit %2 m/s oder mehr</translation>
    </message>
    <message>
        <source>all with %1 m/s or more along the wall, none with up to %2 m/s</source>
        <translation>alle mit %1 m/s oder mehr längs der Wand, keine mit höchstens %2 m/s</translation>
    </message>
    <message>
        <source>the first %1, none of the later ones</source>
        <translation>der erste %1, keine der späteren</translation>
    </message>
    <message>
        <source>all but the first %1</source>
        <translation>alle außer dem ersten %1</translation>
    </message>
    <message>
        <source>all up to number %1, none from number %2 on, counted %3</source>
        <translation>alle bis Nummer %1, keine ab Nummer %2, gezählt unter denen %3</translation>
    </message>
    <message>
        <source>all from number %1 on, none up to number %2, counted %3</source>
        <translation>alle ab Nummer %1, keine bis Nummer %2, gezählt unter denen %3</translation>
    </message>
    <message>
        <source>the first, the third and so on %1, none between them</source>
        <translation>der erste, der dritte und so weiter %1, keine dazwischen</translation>
    </message>
    <message>
        <source>the second, the fourth and so on %1, none between them</source>
        <translation>der zweite, der vierte und so weiter %1, keine dazwischen</translation>
    </message>
    <message>
        <source>all before the two circles had hit each other, none after it</source>
        <translation>alle, bevor die beiden Kreise einander gestoßen hatten, keine danach</translation>
    </message>
    <message>
        <source>all before the circles had hit a wall, none after it</source>
        <translation>alle, bevor die Kreise eine Wand getroffen hatten, keine danach</translation>
    </message>
    <message>
        <source>all after the circles had hit a wall, none before it</source>
        <translation>alle, nachdem die Kreise eine Wand getroffen hatten, keine davor</translation>
    </message>
    <message>
        <source>all that moved to the right, no others</source>
        <translation>alle, die sich nach rechts bewegten, keine anderen</translation>
    </message>
    <message>
        <source>all that moved to the left, no others</source>
        <translation>alle, die sich nach links bewegten, keine anderen</translation>
    </message>
    <message>
        <source>all that moved upward, no others</source>
        <translation>alle, die sich nach oben bewegten, keine anderen</translation>
    </message>
    <message>
        <source>all that moved downward, no others</source>
        <translation>alle, die sich nach unten bewegten, keine anderen</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n came out right.</source>
        <translation>
            <numerusform>Von %1 Versuchen, früh und spät, hier und dort, ging %n richtig aus.</numerusform>
            <numerusform>Von %1 Versuchen, früh und spät, hier und dort, gingen %n richtig aus.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n came out right: %2.</source>
        <translation>
            <numerusform>Von %1 Versuchen, früh und spät, hier und dort, ging %n richtig aus: %2.</numerusform>
            <numerusform>Von %1 Versuchen, früh und spät, hier und dort, gingen %n richtig aus: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Which of these counts, the tries do not show.</source>
        <translation>Was davon zählt, zeigen die Versuche nicht.</translation>
    </message>
    <message>
        <source>With every e tried %1 of the speed comes back.</source>
        <translation>Mit jedem versuchten e kommen %1 des Tempos zurück.</translation>
    </message>
    <message>
        <source>Hits at the %walls leave %who moving outward</source>
        <translation>Nach Stößen an %walls geht es weiter hinaus (%who)</translation>
    </message>
    <message>
        <source>With every e tried nothing of it is lost.</source>
        <translation>Mit jedem versuchten e geht nichts davon verloren.</translation>
    </message>
    <message>
        <source>Some hits of %who at the %walls are not answered</source>
        <translation>Manche Stöße an %walls bleiben unbeantwortet (%who)</translation>
    </message>
    <message>
        <source>Some hits of %who at the %walls come out wrong</source>
        <translation>Manche Stöße an %walls gehen falsch aus (%who)</translation>
    </message>
    <message>
        <source>Some hits of %who at the %walls are answered too late</source>
        <translation>Manche Stöße an %walls werden zu spät beantwortet (%who)</translation>
    </message>
    <message>
        <source>This one came out right: circle %1 at %2 s, at the %3 at %4 m with %5 m/s.</source>
        <translation>Dieser ging richtig aus: Kreis %1 nach %2 s, an %3 bei %4 m mit %5 m/s.</translation>
    </message>
    <message>
        <source>At every wall %who went out</source>
        <translation>An jeder Wand ging es hinaus (%who)</translation>
    </message>
    <message>
        <source>At the %walls %who went out</source>
        <translation>An %walls ging es hinaus (%who)</translation>
    </message>
    <message>
        <source>Slow hits at the %walls leave %who moving outward</source>
        <translation>Nach langsamen Stößen an %walls geht es weiter hinaus (%who)</translation>
    </message>
    <message>
        <source>The x of %who does not change</source>
        <translation>x ändert sich nicht (%who)</translation>
    </message>
    <message>
        <source>The x of %who changes without its velocity</source>
        <translation>x ändert sich ohne die Geschwindigkeit (%who)</translation>
    </message>
    <message>
        <source>The y of %who does not change</source>
        <translation>y ändert sich nicht (%who)</translation>
    </message>
    <message>
        <source>The y of %who changes without its velocity</source>
        <translation>y ändert sich ohne die Geschwindigkeit (%who)</translation>
    </message>
    <message>
        <source>At every timestep tried it goes as far as in %1 s. Take the parameter of `on_update`.</source>
        <translation>Bei jedem versuchten Zeitschritt kommt er so weit wie in %1 s. Nimm den Parameter von `on_update`.</translation>
    </message>
    <message>
        <source>The velocity has no part in the way of %who</source>
        <translation>Die Geschwindigkeit hat am Weg keinen Anteil (%who)</translation>
    </message>
    <message>
        <source>Along the normal only circle 1 feels e</source>
        <translation>Längs der Normalen spürt nur Kreis 1 e</translation>
    </message>
    <message>
        <source>Along the normal only circle 2 feels e</source>
        <translation>Längs der Normalen spürt nur Kreis 2 e</translation>
    </message>
    <message>
        <source>Not every hit stops both circles</source>
        <translation>Nicht jeder Stoß hält beide Kreise an</translation>
    </message>
    <message>
        <source>Equal circles answer rightly, not all unequal ones do</source>
        <translation>Gleiche Kreise antworten richtig, nicht alle ungleichen</translation>
    </message>
    <message>
        <source>Equal circles answer rightly, no unequal ones tried do</source>
        <translation>Gleiche Kreise antworten richtig, keine der versuchten ungleichen</translation>
    </message>
    <message>
        <source>all while another circle moved to the right, no others</source>
        <translation>alle, während ein anderer Kreis sich nach rechts bewegte, sonst keiner</translation>
    </message>
    <message>
        <source>all while another circle moved to the left, no others</source>
        <translation>alle, während ein anderer Kreis sich nach links bewegte, sonst keiner</translation>
    </message>
    <message>
        <source>all while another circle moved upward, no others</source>
        <translation>alle, während ein anderer Kreis sich nach oben bewegte, sonst keiner</translation>
    </message>
    <message>
        <source>all while another circle moved downward, no others</source>
        <translation>alle, während ein anderer Kreis sich nach unten bewegte, sonst keiner</translation>
    </message>
    <message>
        <source>In the step of a hit at the %walls gravity does not act on %who</source>
        <translation>Im Schritt eines Stoßes an %walls wirkt die Schwerkraft nicht auf %who</translation>
    </message>
    <message>
        <source>In a step of %1 s gravity changes the velocity by %2 m/s, in the step of a hit, too. When circle %4 was turned at the %3, the part along the wall stayed as it was before the step.</source>
        <translation>In einem Schritt von %1 s ändert die Schwerkraft die Geschwindigkeit um %2 m/s, auch im Schritt eines Stoßes. Als Kreis %4 an %3 umkehrte, blieb der Anteil längs der Wand, wie er vor dem Schritt war.</translation>
    </message>
    <message>
        <source>At the %walls the parts of the velocity of %who are mixed up</source>
        <translation>An %walls sind die Anteile der Geschwindigkeit von %who vertauscht</translation>
    </message>
    <message>
        <source>The part into the wall is turned round, the part along it stays: look at which part stands where.</source>
        <translation>Der Anteil zur Wand hin kehrt um, der längs der Wand bleibt: Sieh dir an, welcher Anteil wo steht.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who %1 times the whole velocity back</source>
        <translation>An %walls kommt für %who das %1-Fache der ganzen Geschwindigkeit zurück</translation>
    </message>
    <message>
        <source>At the %walls the place of circle %1 is asked for, not that of %who</source>
        <translation>An %walls wird nach dem Ort von Kreis %1 gefragt, nicht nach dem von %who</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s, circle %3 went on past it. In the middle its velocity changed from %4 to %5 m/s, with circle %6 beyond that wall. Look at whose place stands in the question.</source>
        <translation>Mit %2 m/s zu %1 geworfen, ging Kreis %3 darüber hinaus. In der Mitte änderte sich seine Geschwindigkeit von %4 auf %5 m/s, während Kreis %6 hinter dieser Wand war. Sieh dir an, wessen Ort in der Frage steht.</translation>
    </message>
    <message>
        <source>Some hits at the %walls turn %who round too early</source>
        <translation>Manche Stöße an %walls lassen %who zu früh umkehren</translation>
    </message>
    <message>
        <source>Some hits at the %walls turn %who round too late</source>
        <translation>Manche Stöße an %walls lassen %who zu spät umkehren</translation>
    </message>
    <message>
        <source>Of %1 hits tried there, %2 came at the rim.</source>
        <translation>Von %1 dort versuchten Stößen am Rand: %2.</translation>
    </message>
    <message>
        <source>The radius of circle %1 is %2 m, and at the %3 it turned when its centre was between %4 and %5 m from the wall. It should turn when its rim is there.</source>
        <translation>Der Radius von Kreis %1 ist %2 m, und an %3 kehrte er um, als sein Mittelpunkt zwischen %4 und %5 m von der Wand entfernt war. Umkehren sollte er, wenn sein Rand dort ist.</translation>
    </message>
    <message>
        <source>The radius of circle %1 is %2 m, and at the %3 it turned when its centre was between %4 m past the wall and %5 m short of it. It should turn when its rim is there.</source>
        <translation>Der Radius von Kreis %1 ist %2 m, und an %3 kehrte er um, als sein Mittelpunkt zwischen %4 m hinter der Wand und %5 m vor ihr war. Umkehren sollte er, wenn sein Rand dort ist.</translation>
    </message>
    <message>
        <source>The radius of circle %1 is %2 m, and at the %3 it turned when its centre was between %4 and %5 m past the wall. It should turn when its rim is there.</source>
        <translation>Der Radius von Kreis %1 ist %2 m, und an %3 kehrte er um, als sein Mittelpunkt zwischen %4 und %5 m hinter der Wand war. Umkehren sollte er, wenn sein Rand dort ist.</translation>
    </message>
    <message>
        <source>Hits at the %walls put %who back to the start of the run</source>
        <translation>Stöße an %walls setzen %who dorthin, wo der Lauf begann</translation>
    </message>
    <message>
        <source>At the %1 the centre of circle %3 was put %2 m from the wall, as far as it was when the run began. The old place is that before the step: keep it anew in every step.</source>
        <translation>An %1 wurde der Mittelpunkt von Kreis %3 auf %2 m von der Wand gesetzt, so weit, wie er bei Beginn des Laufs war. Der alte Ort ist der vor dem Schritt: Merke ihn dir in jedem Schritt neu.</translation>
    </message>
    <message>
        <source>Of the %1 meetings that were tried %2 were answered in time; in %3 no velocity was changed.</source>
        <translation>Von den %1 versuchten Begegnungen wurden %2 rechtzeitig beantwortet; in %3 wurde keine Geschwindigkeit geändert.</translation>
    </message>
    <message>
        <source>Some meetings are answered before they touch, others too late</source>
        <translation>Manche Begegnungen werden vor der Berührung beantwortet, andere zu spät</translation>
    </message>
    <message>
        <source>A distance is the root of the sum of the squares of both differences.</source>
        <translation>Ein Abstand ist die Wurzel aus der Summe der Quadrate beider Differenzen.</translation>
    </message>
    <message>
        <source>The circles are compared in x alone</source>
        <translation>Die Kreise werden nur in x verglichen</translation>
    </message>
    <message>
        <source>The circles are compared in y alone</source>
        <translation>Die Kreise werden nur in y verglichen</translation>
    </message>
    <message>
        <source>|Δx + Δy| is not the distance</source>
        <translation>|Δx + Δy| ist nicht der Abstand</translation>
    </message>
    <message>
        <source>In your own scene the circles answer before they touch</source>
        <translation>In deiner eigenen Szene antworten die Kreise, bevor sie sich berühren</translation>
    </message>
    <message>
        <source>In your own scene the circles answer too late</source>
        <translation>In deiner eigenen Szene antworten die Kreise zu spät</translation>
    </message>
    <message>
        <source>The distance of the centres comes into the push</source>
        <translation>Der Abstand der Mittelpunkte geht in den Kraftstoß ein</translation>
    </message>
    <message>
        <source>Where an angle is used: x is its cosine and y its sine, and `math.atan` takes y first, then x.</source>
        <translation>Wo ein Winkel benutzt wird: x ist sein Kosinus und y sein Sinus, und `math.atan` nimmt erst y, dann x.</translation>
    </message>
    <message>
        <source>e is less than 1</source>
        <translation>e kleiner als 1 ist</translation>
    </message>
    <message>
        <source>e is 1</source>
        <translation>e gleich 1 ist</translation>
    </message>
    <message>
        <source>all with circle %1 at up to %2 m/s, none with it at %3 m/s or more</source>
        <translation>alle, bei denen Kreis %1 bis zu %2 m/s hatte, keiner, bei dem es %3 m/s oder mehr waren</translation>
    </message>
    <message>
        <source>all with circle %1 at %2 m/s or more, none with it at up to %3 m/s</source>
        <translation>alle, bei denen Kreis %1 mindestens %2 m/s hatte, keiner, bei dem es höchstens %3 m/s waren</translation>
    </message>
    <message>
        <source>all up to %1 m from (0, 0), none from %2 m on</source>
        <translation>alle bis %1 m von (0, 0), keiner ab %2 m</translation>
    </message>
    <message>
        <source>all from %1 m from (0, 0) on, none up to %2 m</source>
        <translation>alle ab %1 m von (0, 0), keiner bis %2 m</translation>
    </message>
    <message>
        <source>Circles that come nearer fast are not answered</source>
        <translation>Kreise, die sich schnell nähern, werden nicht beantwortet</translation>
    </message>
    <message>
        <source>Not every meeting is answered</source>
        <translation>Nicht jede Begegnung wird beantwortet</translation>
    </message>
    <message>
        <source>Near %1 m circle 1 came with %2 m/s and circle 2 with %3 m/s, and they ran into each other; elsewhere others are answered. What counts is whether they overlap and come nearer.</source>
        <translation>Bei %1 m kamen Kreis 1 mit %2 m/s und Kreis 2 mit %3 m/s und liefen ineinander; anderswo werden andere beantwortet. Es zählt, ob sie überlappen und sich nähern.</translation>
    </message>
    <message>
        <source>Look at which masses and which signs stand in what is worked out for the other one.</source>
        <translation>Sieh nach, welche Massen und welche Vorzeichen in dem stehen, was für den anderen berechnet wird.</translation>
    </message>
    <message>
        <source>No hit that was tried comes out right</source>
        <translation>Kein Stoß, der versucht wurde, geht richtig aus</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried, %n came out right: %2.</source>
        <translation>
            <numerusform>Von %1 versuchten Stößen ging %n richtig aus: %2.</numerusform>
            <numerusform>Von %1 versuchten Stößen gingen %n richtig aus: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried, %n came out right.</source>
        <translation>
            <numerusform>Von %1 versuchten Stößen ging %n richtig aus.</numerusform>
            <numerusform>Von %1 versuchten Stößen gingen %n richtig aus.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried with e = %2, %n came out right: %3.</source>
        <translation>
            <numerusform>Von %1 versuchten Stößen mit e = %2 ging %n richtig aus: %3.</numerusform>
            <numerusform>Von %1 versuchten Stößen mit e = %2 gingen %n richtig aus: %3.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried with e = %2, %n came out right.</source>
        <translation>
            <numerusform>Von %1 versuchten Stößen mit e = %2 ging %n richtig aus.</numerusform>
            <numerusform>Von %1 versuchten Stößen mit e = %2 gingen %n richtig aus.</numerusform>
        </translation>
    </message>
    <message>
        <source>In your own scene the first hit comes out right.</source>
        <translation>In deiner eigenen Szene geht der erste Stoß richtig aus.</translation>
    </message>
    <message>
        <source>In all hits that were tried circle 2 was at rest.</source>
        <translation>In allen Stößen, die versucht wurden, ruhte Kreis 2.</translation>
    </message>
    <message>
        <source>With e = %1 it comes out right.</source>
        <translation>Mit e = %1 geht es richtig aus.</translation>
    </message>
    <message>
        <source>A step exchanges x and y in the place of %who</source>
        <translation>Ein Schritt vertauscht für %who x und y des Ortes</translation>
    </message>
    <message>
        <source>A step takes y for x in the place of %who</source>
        <translation>Ein Schritt nimmt für %who das y des Ortes als x</translation>
    </message>
    <message>
        <source>A step takes x for y in the place of %who</source>
        <translation>Ein Schritt nimmt für %who das x des Ortes als y</translation>
    </message>
    <message>
        <source>Each part of the place goes on from itself: look at which part stands where.</source>
        <translation>Jeder Teil des Ortes geht von sich selbst aus: Sieh nach, welcher Teil wo steht.</translation>
    </message>
    <message>
        <source>Every step puts %who at the same place</source>
        <translation>Jeder Schritt setzt %who an denselben Ort</translation>
    </message>
    <message>
        <source>Every step puts %who at the same x</source>
        <translation>Jeder Schritt setzt %who auf dasselbe x</translation>
    </message>
    <message>
        <source>Every step puts %who at the same y</source>
        <translation>Jeder Schritt setzt %who auf dasselbe y</translation>
    </message>
    <message>
        <source>Started at %1 m with %2 m/s, it is at %3 m one step of %4 s later.</source>
        <translation>Bei %1 m mit %2 m/s gestartet, ist der Kreis einen Schritt von %4 s später bei %3 m.</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7), circle %8 leaves as if m₂/m₁ were %5; %6 is right.</source>
        <translation>Mit r₁ = %1 und r₂ = %2 m, ρ₁ = %3 und ρ₂ = %4 (e = %7) geht Kreis %8 davon, als wäre m₂/m₁ = %5; richtig ist %6.</translation>
    </message>
    <message>
        <source>e multiplies the whole velocity of circle %1 after the hit</source>
        <translation>e multipliziert die ganze Geschwindigkeit von Kreis %1 nach dem Stoß</translation>
    </message>
    <message>
        <source>e belongs to the rebound along the line of centres alone.</source>
        <translation>e gehört allein zum Rückprall längs der Verbindungslinie der Mittelpunkte.</translation>
    </message>
    <message>
        <source>Both new velocities come from those *before* the hit: look at what each circle gets, and whether it is read before or after a velocity is written.</source>
        <translation>Beide neuen Geschwindigkeiten kommen aus denen *vor* dem Stoß: Sieh nach, was jeder Kreis bekommt und ob es gelesen wird, bevor oder nachdem eine Geschwindigkeit geschrieben ist.</translation>
    </message>
    <message>
        <source>So it is when the run begins. With that e a right program fails the check “%1”, too.</source>
        <translation>So ist es, wenn der Lauf beginnt. Mit diesem e besteht auch ein richtiges Programm die Prüfung „%1“ nicht.</translation>
    </message>
    <message>
        <source>%1 (in some hits)</source>
        <translation>%1 (in manchen Stößen)</translation>
    </message>
    <message>
        <source>%1 (equal circles)</source>
        <translation>%1 (gleiche Kreise)</translation>
    </message>
    <message>
        <source>The distance is taken between places of two moments

Both circles flew with %1 m/s along the line of centres, the one behind %2 m/s faster: where circle 2 was ahead, they answered with the centres %3 m apart, where circle 1 was, %4 m; rims touch at %5 m. The two differ from that by what a circle flies in a step: look at whether both places are of the same moment, after both have moved.</source>
        <translation>Der Abstand gilt zwischen Orten zweier Zeitpunkte

Beide Kreise flogen mit %1 m/s längs der Verbindungslinie der Mittelpunkte, der hintere um %2 m/s schneller: War Kreis 2 vorn, antworteten sie bei %3 m Abstand der Mittelpunkte, war es Kreis 1, bei %4 m; die Ränder berühren sich bei %5 m. Beides weicht davon um das ab, was ein Kreis in einem Schritt fliegt: Sieh nach, ob beide Orte vom selben Zeitpunkt sind, nachdem sich beide bewegt haben.</translation>
    </message>
    <message>
        <source>Every step moves %who on from the place of the start</source>
        <translation>Jeder Schritt bewegt %who vom Ort des Starts weiter</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it is %2 m from its start after the first step of %3 s, and %4 m after the second. The way of a step is added to the place before that step: is the old place kept anew in every step?</source>
        <translation>Mit %1 m/s gestartet, ist er nach dem ersten Schritt von %3 s um %2 m von seinem Start entfernt und nach dem zweiten um %4 m. Der Weg eines Schritts kommt zum Ort vor diesem Schritt hinzu: Wird der alte Ort in jedem Schritt neu gemerkt?</translation>
    </message>
    <message>
        <source>Gravity on %who is divided by the timestep</source>
        <translation>Für %who wird die Schwerkraft durch den Zeitschritt geteilt</translation>
    </message>
    <message>
        <source>An acceleration times a time is a velocity. Look at what stands before the timestep in the line that changes the velocity.</source>
        <translation>Eine Beschleunigung mal eine Zeit ist eine Geschwindigkeit. Sieh nach, was in der Zeile, die die Geschwindigkeit ändert, vor dem Zeitschritt steht.</translation>
    </message>
    <message>
        <source>Not every step of %who is made alike</source>
        <translation>Nicht jeder Schritt ist gleich gemacht, für %who</translation>
    </message>
    <message>
        <source>A step or two later it is as at the start again. Look at what your program counts, or keeps from one step to the next.</source>
        <translation>Ein oder zwei Schritte später ist es wieder wie am Start. Sieh nach, was dein Programm zählt oder von einem Schritt zum nächsten behält.</translation>
    </message>
    <message>
        <source>Only the first step changes the velocity of %who rightly</source>
        <translation>Nur der erste Schritt ändert die Geschwindigkeit richtig, für %who</translation>
    </message>
    <message>
        <source>Thrown with %1 m/s, it has %2 m/s one step of %3 s later, which is right; in the next step that changes by %4 m/s, and gravity gives it %5 m/s. Look at which velocity the line that changes it goes on from, and at what your program keeps from one step to the next.</source>
        <translation>Mit %1 m/s geworfen, hat er einen Schritt von %3 s später %2 m/s, und das ist richtig; im nächsten Schritt ändert sie sich um %4 m/s, und die Schwerkraft gibt ihm %5 m/s. Sieh nach, von welcher Geschwindigkeit die Zeile ausgeht, die sie ändert, und was dein Programm von einem Schritt zum nächsten behält.</translation>
    </message>
    <message>
        <source>Let go at rest, it has %1 m/s one step of %2 s later, far from every wall and every other circle; gravity gives it %3 m/s in a step. Thrown with %4 m/s it goes on as it should.</source>
        <translation>In Ruhe losgelassen, hat er einen Schritt von %2 s später %1 m/s, fern von jeder Wand und jedem anderen Kreis; die Schwerkraft gibt ihm %3 m/s in einem Schritt. Mit %4 m/s geworfen, fliegt er so weiter, wie er soll.</translation>
    </message>
    <message>
        <source>e changes the velocity of %who away from any hit</source>
        <translation>Fern von jedem Stoß ändert e die Geschwindigkeit, für %who</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s two steps of %3 s later with e = %4, and %5 m/s with e = 1; nothing is near. e belongs to hits alone: look at what is asked before the line that takes it.</source>
        <translation>Mit %1 m/s gestartet, hat er zwei Schritte von %3 s später mit e = %4 noch %2 m/s und mit e = 1 noch %5 m/s; nichts ist in der Nähe. e gehört allein zu Stößen: Sieh nach, was vor der Zeile gefragt wird, die es nimmt.</translation>
    </message>
    <message>
        <source>With some timesteps the way of %who is not v Δt</source>
        <translation>Mit manchen Zeitschritten ist der Weg nicht v Δt, für %who</translation>
    </message>
    <message>
        <source>With Δt = %1 s it goes v Δt. Look at which Δt the line that changes the position takes.</source>
        <translation>Mit Δt = %1 s kommt er um v Δt weiter. Sieh nach, welches Δt die Zeile nimmt, die den Ort ändert.</translation>
    </message>
    <message>
        <source>Let go at rest, it goes as it should.</source>
        <translation>In Ruhe losgelassen, bewegt er sich, wie er soll.</translation>
    </message>
    <message>
        <source>The way of %who in a step is wrong</source>
        <translation>Der Weg eines Schritts ist falsch, für %who</translation>
    </message>
    <message>
        <source>The way of %who is divided by the timestep</source>
        <translation>Für %who wird der Weg durch den Zeitschritt geteilt</translation>
    </message>
    <message>
        <source>A velocity times a time is a length. Look at what stands before the timestep in the line that moves it.</source>
        <translation>Eine Geschwindigkeit mal eine Zeit ist eine Länge. Sieh nach, was in der Zeile, die den Kreis bewegt, vor dem Zeitschritt steht.</translation>
    </message>
    <message>
        <source>The velocity of %who gets %1 times what gravity gives</source>
        <translation>Für %who bekommt die Geschwindigkeit das %1-Fache der Schwerkraft</translation>
    </message>
    <message>
        <source>From every speed tried it has %1 m/s along the normal afterwards: work the new velocity out from the old one.</source>
        <translation>Nach jeder versuchten Geschwindigkeit hat er danach %1 m/s längs der Normalen: Rechne die neue Geschwindigkeit aus der alten aus.</translation>
    </message>
    <message>
        <source>Started at rest at two places, it is at one and the same place two steps later. A step *adds* a way to the old position.</source>
        <translation>An zwei Orten in Ruhe gestartet, ist der Kreis zwei Schritte später an ein und demselben Ort. Ein Schritt *addiert* einen Weg zum alten Ort.</translation>
    </message>
    <message>
        <source>%1 (in most hits)</source>
        <translation>%1 (bei den meisten Stößen)</translation>
    </message>
    <message>
        <source>The circles do not stop in a hit</source>
        <translation>Die Kreise bleiben im Stoß nicht stehen</translation>
    </message>
    <message>
        <source>Each circle keeps its direction and gets the other&apos;s speed</source>
        <translation>Jeder Kreis behält seine Richtung und bekommt das Tempo des anderen</translation>
    </message>
    <message>
        <source>A velocity has a direction, too: what changes hands is the whole part along the line of centres, not its length.</source>
        <translation>Eine Geschwindigkeit hat auch eine Richtung: Ausgetauscht wird der ganze Anteil längs der Verbindungslinie der Mittelpunkte, nicht sein Betrag.</translation>
    </message>
    <message>
        <source>Thrown at each of them, %who went on through it; at the %1 with %2 m/s. Look at whether your program asks about walls for %who, and whether the answer is ever yes.</source>
        <translation>Gegen jede geworfen, ging es hindurch (%who); an %1 mit %2 m/s. Sieh dir an, ob dein Programm dafür nach Wänden fragt (%who) und ob die Antwort je Ja ist.</translation>
    </message>
    <message>
        <source>In its first %1 s their rims come no nearer than %2 m, at %3 s. Look at the positions and velocities that they start with.</source>
        <translation>In ihren ersten %1 s kommen sich ihre Ränder nicht näher als %2 m, bei %3 s. Sieh nach, mit welchen Orten und Geschwindigkeiten sie beginnen.</translation>
    </message>
    <message>
        <source>The circles of your scene do not meet in its first %1 s</source>
        <translation>Die Kreise deiner Szene treffen sich in den ersten %1 s nicht</translation>
    </message>
    <message>
        <source>Circle %5 came to the %1 with %2 m/s and has %3 m/s after the hit, still into it; %4 m/s is right.</source>
        <translation>Kreis %5 kam mit %2 m/s an %1 an und hat nach dem Stoß %3 m/s, immer noch nach außen; richtig ist %4 m/s.</translation>
    </message>
    <message>
        <source>However it is started, what it has one step later comes from the velocity of circle %1: started with %2 m/s, it has %3 m/s. Each circle goes on from its own velocity: look at the names in the line that changes it.</source>
        <translation>Wie auch gestartet, kommt die Geschwindigkeit einen Schritt später von der von Kreis %1: Aus %2 m/s am Anfang werden %3 m/s. Jeder Kreis geht von seiner eigenen Geschwindigkeit aus: Sieh dir die Namen in der Zeile an, die sie ändert.</translation>
    </message>
    <message>
        <source>A step *adds* a way to the old position: look at the lines that put it there, and at what is asked before them.</source>
        <translation>Ein Schritt *addiert* einen Weg zum alten Ort: Sieh dir die Zeilen an, die den Kreis dorthin setzen, und was vor ihnen gefragt wird.</translation>
    </message>
    <message>
        <source>No hit tried is answered but that of your own scene</source>
        <translation>Kein versuchter Stoß wird beantwortet, nur der deiner Szene</translation>
    </message>
    <message>
        <source>The circles are answered much too late, or not at all</source>
        <translation>Die Kreise werden viel zu spät beantwortet oder gar nicht</translation>
    </message>
    <message>
        <source>A hit puts the circles too far apart</source>
        <translation>Ein Stoß setzt die Kreise zu weit auseinander</translation>
    </message>
    <message>
        <source>They came until their centres were %1 m apart, and the step with the answer put them %2 m apart; rims touch at %3 m. It is enough that they touch: look at how far each of the two is moved.</source>
        <translation>Sie kamen, bis ihre Mittelpunkte %1 m Abstand hatten, und der Schritt mit der Antwort setzte sie auf %2 m; die Ränder berühren sich bei %3 m. Es genügt, dass sie sich berühren: Sieh dir an, wie weit jeder der beiden versetzt wird.</translation>
    </message>
    <message>
        <source>A hit stops the x parts alone</source>
        <translation>Ein Stoß hält nur die x-Anteile an</translation>
    </message>
    <message>
        <source>A hit stops the y parts alone</source>
        <translation>Ein Stoß hält nur die y-Anteile an</translation>
    </message>
    <message>
        <source>The floor does not hold circle %1 up

Here e is %4. After %2 s near the floor its rim is %3 m below it, and deeper than before: the floor changes its velocity, and yet gravity pulls it on. Put the circle back where it touches.</source>
        <translation>Der Boden hält Kreis %1 nicht oben

Hier ist e = %4. Nach %2 s in der Nähe des Bodens liegt sein Rand %3 m darunter, und tiefer als vorher: Der Boden ändert seine Geschwindigkeit, und doch zieht ihn die Schwerkraft weiter. Setze den Kreis dorthin zurück, wo er den Boden berührt.</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² the acceleration is %2 m/s², and %3 m/s² under %4 m/s².</source>
        <translation>Unter der Schwerkraft %1 m/s² ist die Beschleunigung %2 m/s², und %3 m/s² unter %4 m/s².</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² the way of a step is %2, with v from before it.</source>
        <translation>Unter der Schwerkraft %1 m/s² ist der Weg eines Schritts %2, mit v von davor.</translation>
    </message>
    <message>
        <source>Euler adds nothing to v Δt, symplectic Euler g Δt², the exact methods (Verlet, Runge-Kutta 4) ½ g Δt²; one of these is asked for.</source>
        <translation>Euler fügt zu v Δt nichts hinzu, der symplektische Euler g Δt², die genauen Verfahren (Verlet, Runge-Kutta 4) ½ g Δt²; verlangt ist eines davon.</translation>
    </message>
    <message>
        <source>Euler moves by the velocity from before the step alone.</source>
        <translation>Euler bewegt allein mit der Geschwindigkeit von vor dem Schritt.</translation>
    </message>
    <message>
        <source>Symplectic Euler changes the velocity first and moves by the new one, which is v Δt + g Δt².</source>
        <translation>Der symplektische Euler ändert zuerst die Geschwindigkeit und bewegt mit der neuen, und das ist v Δt + g Δt².</translation>
    </message>
    <message>
        <source>%1 is asked for.</source>
        <translation>Verlangt ist %1.</translation>
    </message>
    <message>
        <source>The sign of ½ g Δt² is wrong in the motion of %who</source>
        <translation>Für %who ist das Vorzeichen von ½ g Δt² falsch</translation>
    </message>
    <message>
        <source>The circles have each other&apos;s method

Under gravity the way of circle 1 in a step is %1, that of circle 2 %2; it should be the other way round. Look at which circle goes with which method.</source>
        <translation>Jeder Kreis hat das Verfahren des anderen

Unter der Schwerkraft ist der Weg von Kreis 1 in einem Schritt %1, der von Kreis 2 %2; es sollte umgekehrt sein. Sieh nach, welcher Kreis zu welchem Verfahren gehört.</translation>
    </message>
    <message>
        <source>The circles move by different methods

Under gravity circle 1 moves by %1, with the way %2 in a step, and circle 2 by %3, with %4; both need the same. Look at which lines move which circle.</source>
        <translation>Die Kreise bewegen sich nach verschiedenen Verfahren

Unter der Schwerkraft bewegt sich Kreis 1 nach %1, mit dem Weg %2 in einem Schritt, und Kreis 2 nach %3, mit %4; beide brauchen dasselbe. Sieh nach, welche Zeilen welchen Kreis bewegen.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: the radius of the other circle there. Look at whose radius stands in the questions.</source>
        <translation>Der Radius von Kreis %3 ist %1 m, und umgekehrt wird, wenn der Mittelpunkt %2 m von der Wand entfernt ist: der Radius des anderen Kreises dabei. Sieh nach, wessen Radius in den Fragen steht.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: the radius of the other circle there, which is larger. Each circle has its own.</source>
        <translation>Der Radius von Kreis %3 ist %1 m, und er kehrt um, wenn sein Mittelpunkt %2 m von der Wand entfernt ist: der Radius des anderen Kreises dabei, der größer ist. Jeder Kreis hat seinen eigenen.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: the radius of the other circle there, which is smaller. Each circle has its own.</source>
        <translation>Der Radius von Kreis %3 ist %1 m, und er kehrt um, wenn sein Mittelpunkt %2 m von der Wand entfernt ist: der Radius des anderen Kreises dabei, der kleiner ist. Jeder Kreis hat seinen eigenen.</translation>
    </message>
    <message>
        <source>Here the radius of circle %3 is %1 m, and yet it turns when its centre is 0.2 m from the wall. Take the radius that the circle has.</source>
        <translation>Hier ist der Radius von Kreis %3 %1 m, und doch wird umgekehrt, wenn der Mittelpunkt 0.2 m von der Wand entfernt ist. Nimm den Radius, den der Kreis hat.</translation>
    </message>
    <message>
        <source>Circle %1 was turned round again while it left a wall

It was on its way back from the %2 and was turned into it once more. Put it back inside, or ask which way it moves before you turn it.</source>
        <translation>Kreis %1 wurde noch einmal umgekehrt, während er eine Wand verließ

Er war auf dem Rückweg von %2 und wurde noch einmal hineingekehrt. Setze ihn nach innen zurück, oder frage, wohin er sich bewegt, bevor du ihn umkehrst.</translation>
    </message>
    <message>
        <source>Circle %1 was turned round again while it left a wall

It was on its way back from the %2 and was turned into it once more; in a run that begins there it goes on. Look at what your program keeps from one step to the next.</source>
        <translation>Kreis %1 wurde noch einmal umgekehrt, während er eine Wand verließ

Er war auf dem Rückweg von %2 und wurde noch einmal hineingekehrt; in einem Lauf, der dort beginnt, fliegt er weiter. Sieh nach, was dein Programm von einem Schritt zum nächsten aufbewahrt.</translation>
    </message>
    <message>
        <source>With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m; v Δt is %4 m.</source>
        <translation>Mit der Geschwindigkeit %1 m/s und Δt = %2 s ist der Weg eines Schritts %3 m; v Δt ist %4 m.</translation>
    </message>
    <message>
        <source>With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m, with %4 m/s %5 m; v Δt is %6 and %7 m.</source>
        <translation>Mit der Geschwindigkeit %1 m/s und Δt = %2 s ist der Weg eines Schritts %3 m, mit %4 m/s %5 m; v Δt ist %6 und %7 m.</translation>
    </message>
    <message>
        <source>With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m, with %4 m/s %5 m; %6 and %7 m are right.</source>
        <translation>Mit der Geschwindigkeit %1 m/s und Δt = %2 s ist der Weg eines Schritts %3 m, mit %4 m/s %5 m; richtig sind %6 und %7 m.</translation>
    </message>
    <message>
        <source>The way of a step is %1 with the velocity %2 m/s, and %3 with %4 m/s. Euler adds nothing to v Δt, symplectic Euler g Δt², the exact methods ½ g Δt². Look at what is asked before the lines that change the position.</source>
        <translation>Der Weg eines Schritts ist %1 mit der Geschwindigkeit %2 m/s, und %3 mit %4 m/s. Euler fügt zu v Δt nichts hinzu, der symplektische Euler g Δt², die genauen Verfahren ½ g Δt². Sieh dir an, was vor den Zeilen gefragt wird, die den Ort ändern.</translation>
    </message>
    <message>
        <source>Every step must add v Δt to the position. Look at what the line that changes the position takes in its place.</source>
        <translation>Jeder Schritt muss zum Ort v Δt hinzufügen. Sieh nach, was die Zeile, die den Ort ändert, stattdessen nimmt.</translation>
    </message>
    <message>
        <source>Every step must add v Δt to the position.</source>
        <translation>Jeder Schritt muss zum Ort v Δt hinzufügen.</translation>
    </message>
    <message>
        <source>Started with %1 m/s under gravity %2 m/s², away from every wall and every other circle, its velocity is 0 one step later; without gravity it keeps it.</source>
        <translation>Mit %1 m/s unter der Schwerkraft %2 m/s² gestartet, fern von jeder Wand und jedem anderen Kreis, ist seine Geschwindigkeit einen Schritt später 0; ohne Schwerkraft behält er sie.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, away from every wall and every other circle, its velocity is 0 one step later.</source>
        <translation>Mit %1 m/s gestartet, fern von jeder Wand und jedem anderen Kreis, ist seine Geschwindigkeit einen Schritt später 0.</translation>
    </message>
    <message>
        <source>Under gravity a step took the velocity of %who away</source>
        <translation>Unter Schwerkraft nahm ein Schritt die Geschwindigkeit weg (%who)</translation>
    </message>
    <message>
        <source>Look at the lines that stop a circle, and at what is asked before they run: is it true although nothing touches?</source>
        <translation>Sieh dir die Zeilen an, die einen Kreis anhalten, und was davor gefragt wird: Trifft es zu, obwohl sich nichts berührt?</translation>
    </message>
    <message>
        <source>In free flight gravity leaves %who alone</source>
        <translation>Im freien Flug wirkt die Schwerkraft nicht auf %who</translation>
    </message>
    <message>
        <source>A fixed number stands for the timestep of %who</source>
        <translation>Eine feste Zahl steht für den Zeitschritt, für %who</translation>
    </message>
    <message>
        <source>At every timestep tried the whole step is made as if Δt were %1 s. Take the parameter of `on_update`.</source>
        <translation>Bei jedem versuchten Zeitschritt geht der ganze Schritt so, als wäre Δt %1 s. Nimm den Parameter von `on_update`.</translation>
    </message>
    <message>
        <source>In free flight a step leaves %who as it was</source>
        <translation>Im freien Flug ändert ein Schritt nichts, für %who</translation>
    </message>
    <message>
        <source>Far from the %1 something turns %who round</source>
        <translation>Weit vor %1 lässt etwas %who umkehren</translation>
    </message>
    <message>
        <source>A start towards the %1 turns %who round</source>
        <translation>Ein Start auf %1 zu kehrt %who um</translation>
    </message>
    <message>
        <source>Thrown straight towards the %1 with %2 m/s from %3 m, circle %4 has %5 m/s one step of %6 s later.</source>
        <translation>Gerade zu %1 hin geworfen, mit %2 m/s von %3 m aus, hat Kreis %4 einen Schritt von %6 s später %5 m/s.</translation>
    </message>
    <message>
        <source>It is at %1 m then.</source>
        <translation>Dann ist er bei %1 m.</translation>
    </message>
    <message>
        <source>So it is from all places tried; thrown the other way it goes on as it should.</source>
        <translation>So ist es von allen Orten aus, die versucht wurden; andersherum geworfen, fliegt er weiter, wie er soll.</translation>
    </message>
    <message>
        <source>So it is where its centre comes to %1 or farther, and its rim to %2; the wall is at %3.</source>
        <translation>So ist es, wo sein Mittelpunkt bis %1 oder weiter kommt und sein Rand bis %2; die Wand ist bei %3.</translation>
    </message>
    <message>
        <source>Look at what your program asks for that wall, at the lengths there and at their signs.</source>
        <translation>Sieh nach, was dein Programm für diese Wand fragt, welche Längen dort stehen und mit welchem Vorzeichen.</translation>
    </message>
    <message>
        <source>Turned towards it by the wall opposite, it goes on. Look at what your program takes over of the velocity that a run begins with.</source>
        <translation>Von der Wand gegenüber dorthin gekehrt, fliegt er weiter. Sieh nach, was dein Programm von der Geschwindigkeit übernimmt, mit der ein Lauf beginnt.</translation>
    </message>
    <message>
        <source>The position does not change, either. Look at whether the lines that move a circle are reached in every step, and for which circle.</source>
        <translation>Auch der Ort ändert sich nicht. Sieh nach, ob die Zeilen, die einen Kreis bewegen, in jedem Schritt erreicht werden, und für welchen Kreis.</translation>
    </message>
    <message>
        <source>The whole step of %who is made as with %1 Δt</source>
        <translation>Der ganze Schritt geht wie mit %1 Δt, für %who</translation>
    </message>
    <message>
        <source>The way is %1 times v Δt, too: look at which Δt the lines of a step take, and at how often they run.</source>
        <translation>Auch der Weg ist das %1-Fache von v Δt: Sieh nach, welches Δt die Zeilen eines Schritts nehmen und wie oft sie laufen.</translation>
    </message>
    <message>
        <source>Circle %1 moved only in a step in which a wall was hit</source>
        <translation>Kreis %1 bewegte sich nur in einem Schritt mit Wandstoß</translation>
    </message>
    <message>
        <source>In the step in which circle %1 was answered by the %2 the other circle went %3 m; in no step before did it move. Look at what lets a step end before its turn, as `return` and `break` do, and at what is asked before it moves.</source>
        <translation>In dem Schritt, in dem auf Kreis %1 geantwortet wurde (%2), kam der andere Kreis %3 m weit; in keinem Schritt davor bewegte er sich. Sieh nach, was einen Schritt enden lässt, bevor er an der Reihe ist, wie es `return` und `break` tun, und was gefragt wird, bevor er sich bewegt.</translation>
    </message>
    <message>
        <source>In free flight a step moves %who nowhere</source>
        <translation>Im freien Flug bewegt ein Schritt nichts vom Fleck (%who)</translation>
    </message>
    <message>
        <source>The circles are answered far apart, not where they touch</source>
        <translation>Die Kreise antworten weit voneinander, nicht wo sie sich berühren</translation>
    </message>
    <message>
        <source>At %1 and %2 m, opposite each other about the middle of the square, they were answered with their centres %3 m apart.</source>
        <translation>Bei %1 und %2 m, einander gegenüber um die Mitte des Quadrats, antworteten sie, als ihre Mittelpunkte %3 m Abstand hatten.</translation>
    </message>
    <message>
        <source>Look at whether the two places are subtracted: their sum is not the way from one to the other.</source>
        <translation>Sieh nach, ob die beiden Orte voneinander abgezogen werden: Ihre Summe ist nicht der Weg vom einen zum anderen.</translation>
    </message>
    <message>
        <source>From all %1 directions in which they were thrown at each other, with up to %2 m/s along the line of centres, neither of them changed its velocity.</source>
        <translation>Aus allen %1 Richtungen, in denen sie mit bis zu %2 m/s längs der Verbindungslinie der Mittelpunkte gegeneinander geworfen wurden, änderte keiner seine Geschwindigkeit.</translation>
    </message>
    <message>
        <source>In your own scene, with %1 m/s, they were answered in time: look at what your program asks before they answer.</source>
        <translation>In deiner eigenen Szene, mit %1 m/s, antworteten sie rechtzeitig: Sieh dir an, was dein Programm fragt, bevor sie antworten.</translation>
    </message>
    <message>
        <source>In your own scene their velocities changed where their centres were between %1 and %2 m apart; rims touch there at %3 m. Look at what their distance is compared with, and at what is asked besides.</source>
        <translation>In deiner eigenen Szene änderten sich die Geschwindigkeiten, als die Mittelpunkte zwischen %1 und %2 m Abstand hatten; die Ränder berühren sich dort bei %3 m. Sieh dir an, womit der Abstand verglichen wird und was außerdem gefragt wird.</translation>
    </message>
    <message>
        <source>Gravity leaves %who at rest</source>
        <translation>Die Schwerkraft lässt %who in Ruhe</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7) the masses, whichever stands where, are as 1 to %5; 1 to %6 is right.</source>
        <translation>Mit r₁ = %1 und r₂ = %2 m, ρ₁ = %3 und ρ₂ = %4 (e = %7) verhalten sich die Massen, welche auch wo steht, wie 1 zu %5; richtig ist 1 zu %6.</translation>
    </message>
    <message>
        <source>Circle %1 answers as if it had the mass of the other</source>
        <translation>Kreis %1 antwortet, als hätte er die Masse des anderen</translation>
    </message>
    <message>
        <source>Each circle answers as if it had the mass of the other</source>
        <translation>Jeder Kreis antwortet, als hätte er die Masse des anderen</translation>
    </message>
    <message>
        <source>The heavier one is pushed away faster. Look at what each mass is made of, and at which stands where.</source>
        <translation>Der schwerere wird schneller weggestoßen. Sieh nach, woraus jede Masse gemacht wird und welche wo steht.</translation>
    </message>
    <message>
        <source>Each circle answers as if it had the other&apos;s radius</source>
        <translation>Jeder Kreis antwortet, als hätte er den Radius des anderen</translation>
    </message>
    <message>
        <source>Each circle answers as if it had the other&apos;s density</source>
        <translation>Jeder Kreis antwortet, als hätte er die Dichte des anderen</translation>
    </message>
    <message>
        <source>Look at whose radius stands in which mass, and on which side of a division.</source>
        <translation>Sieh nach, wessen Radius in welcher Masse steht und auf welcher Seite einer Division.</translation>
    </message>
    <message>
        <source>Look at whose density stands in which mass, and on which side of a division.</source>
        <translation>Sieh nach, wessen Dichte in welcher Masse steht und auf welcher Seite einer Division.</translation>
    </message>
    <message>
        <source>In the rebound the two shares are exchanged</source>
        <translation>Beim Rückprall sind die beiden Anteile vertauscht</translation>
    </message>
    <message>
        <source>What comes back of the speed is e times it, not √e times.</source>
        <translation>Von der Geschwindigkeit kommt das e-fache zurück, nicht das √e-fache.</translation>
    </message>
    <message>
        <source>As one circle hit a wall the way of the other changed</source>
        <translation>Als ein Kreis eine Wand traf, änderte sich der Weg des anderen</translation>
    </message>
    <message>
        <source>They answer %2 m apart: that squared is about r₁ + r₂. A square is in m², a length in m.</source>
        <translation>Sie antworten bei %2 m Abstand: Das zum Quadrat ist etwa r₁ + r₂. Ein Quadrat hat die Einheit m², eine Länge m.</translation>
    </message>
    <message>
        <source>With r₁ = %1 m and r₂ = %2 m they answered when their centres were between %3 and %4 m apart; rims touch where that is %5 m.</source>
        <translation>Mit r₁ = %1 m und r₂ = %2 m antworteten sie, als ihre Mittelpunkte zwischen %3 und %4 m Abstand hatten; die Ränder berühren sich bei %5 m.</translation>
    </message>
    <message>
        <source>Thrown with up to %1 m/s along the line of centres they answer in time.</source>
        <translation>Geworfen mit bis zu %1 m/s längs der Verbindungslinie der Mittelpunkte, antworten sie rechtzeitig.</translation>
    </message>
    <message>
        <source>In scenes that have their radii before your program begins they answer in time.</source>
        <translation>In Szenen, deren Radien schon vor dem Beginn deines Programms feststehen, antworten sie rechtzeitig.</translation>
    </message>
    <message>
        <source>Look at when your program reads the radii: what is read before `on_load` sets them is an old value.</source>
        <translation>Sieh nach, wann dein Programm die Radien liest: Was gelesen wird, bevor `on_load` sie setzt, ist ein alter Wert.</translation>
    </message>
    <message>
        <source>Look at what the distance is compared with, and at what is asked besides.</source>
        <translation>Sieh dir an, womit der Abstand verglichen wird und was außerdem gefragt wird.</translation>
    </message>
    <message>
        <source>A hit puts the circles into each other</source>
        <translation>Ein Stoß setzt die Kreise ineinander</translation>
    </message>
    <message>
        <source>They came until their centres were %1 m apart, and the step with the answer put them %2 m apart; rims touch at %3 m. Look at the place that each of the two gets.</source>
        <translation>Sie kamen, bis ihre Mittelpunkte %1 m Abstand hatten, und der Schritt mit der Antwort setzte sie auf %2 m Abstand; die Ränder berühren sich bei %3 m. Sieh dir an, welchen Ort jeder der beiden bekommt.</translation>
    </message>
    <message>
        <source>The push is multiplied by the distance of the centres, in m. A direction has length 1: divide the way from one to the other by its length wherever it stands.</source>
        <translation>Der Kraftstoß wird mit dem Abstand der Mittelpunkte in m multipliziert. Eine Richtung hat die Länge 1: Teile den Weg vom einen zum anderen überall, wo er steht, durch seine Länge.</translation>
    </message>
    <message>
        <source>The rebound depends on how deep the circles overlap</source>
        <translation>Der Rückprall hängt davon ab, wie tief die Kreise überlappen</translation>
    </message>
    <message>
        <source>With a timestep of %1 s the circles parted with %2 times the speed along the push that they met with; %3 is right.</source>
        <translation>Mit einem Zeitschritt von %1 s trennten sich die Kreise mit dem %2-fachen der Geschwindigkeit längs des Kraftstoßes, mit der sie sich trafen; richtig ist %3.</translation>
    </message>
    <message>
        <source>In very short steps it comes out right: look at whether the normal has length 1 where they overlap.</source>
        <translation>In sehr kurzen Schritten stimmt es: Sieh nach, ob die Normale die Länge 1 hat, wo sie überlappen.</translation>
    </message>
    <message>
        <source>With e = %1 and a timestep of %2 s the circles parted with %3 times the speed along the push that they met with; %4 is right.</source>
        <translation>Mit e = %1 und einem Zeitschritt von %2 s trennten sich die Kreise mit dem %3-fachen der Geschwindigkeit längs des Kraftstoßes, mit der sie sich trafen; richtig ist %4.</translation>
    </message>
    <message>
        <source>e multiplies the whole new part of circle %1</source>
        <translation>e multipliziert den ganzen neuen Anteil von Kreis %1</translation>
    </message>
    <message>
        <source>e multiplies both whole new parts</source>
        <translation>e multipliziert beide neuen Anteile ganz</translation>
    </message>
    <message>
        <source>The push is divided by the distance of the centres</source>
        <translation>Der Kraftstoß wird durch den Abstand der Mittelpunkte geteilt</translation>
    </message>
    <message>
        <source>The push is divided by the square of the distance of the centres, in m. A direction has length 1: look at how often the way from one to the other is divided by its length.</source>
        <translation>Der Kraftstoß wird durch das Quadrat des Abstands der Mittelpunkte in m geteilt. Eine Richtung hat die Länge 1: Sieh nach, wie oft der Weg vom einen zum anderen durch seine Länge geteilt wird.</translation>
    </message>
    <message>
        <source>The distance, in m, must not change the size of the push. Look at how often the way from one to the other is divided by its length.</source>
        <translation>Der Abstand in m darf die Größe des Kraftstoßes nicht ändern. Sieh nach, wie oft der Weg vom einen zum anderen durch seine Länge geteilt wird.</translation>
    </message>
    <message>
        <source>The push acts along the velocity of circle 2</source>
        <translation>Der Kraftstoß wirkt längs der Geschwindigkeit von Kreis 2</translation>
    </message>
    <message>
        <source>Each circle gets the new part of the other</source>
        <translation>Jeder Kreis bekommt den neuen Anteil des anderen</translation>
    </message>
    <message>
        <source>In all hits tried both new parts along the line of centres are as they should be, but circle 1 has that of circle 2, and circle 2 that of circle 1. Look at which result goes to which circle.</source>
        <translation>In allen versuchten Stößen sind beide neuen Anteile längs der Verbindungslinie der Mittelpunkte, wie sie sein sollen, aber Kreis 1 hat den von Kreis 2 und Kreis 2 den von Kreis 1. Sieh nach, welches Ergebnis welcher Kreis bekommt.</translation>
    </message>
    <message>
        <source>What the two have in common does not depend on the masses</source>
        <translation>Was die beiden gemeinsam haben, hängt nicht von den Massen ab</translation>
    </message>
    <message>
        <source>In all hits tried what parts them again comes out right, but what both have in common is the mean of the two velocities along that line, whatever the masses are. The total momentum is not kept then, so no masses make it right. Look at where that mean is worked out.</source>
        <translation>In allen versuchten Stößen stimmt, was sie wieder trennt, aber was beide gemeinsam haben, ist der Mittelwert der beiden Geschwindigkeiten längs dieser Linie, wie auch immer die Massen sind. Der Gesamtimpuls bleibt dann nicht erhalten, also stimmt es mit keinen Massen. Sieh dir an, wo dieser Mittelwert errechnet wird.</translation>
    </message>
    <message>
        <source>The rebound is shared half and half, whatever the masses are</source>
        <translation>Der Rückprall wird halb und halb geteilt, wie auch immer die Massen sind</translation>
    </message>
    <message>
        <source>In all hits tried what both have in common comes out right, but of what parts them again each gets one half. The total momentum is not kept then, so no masses make it right: the lighter one should get more.</source>
        <translation>In allen versuchten Stößen stimmt, was beide gemeinsam haben, aber von dem, was sie wieder trennt, bekommt jeder die Hälfte. Der Gesamtimpuls bleibt dann nicht erhalten, also stimmt es mit keinen Massen: Der leichtere sollte mehr bekommen.</translation>
    </message>
    <message>
        <source>Each circle leaves with e times the momentum of the other</source>
        <translation>Jeder Kreis geht mit dem e-fachen Impuls des anderen weg</translation>
    </message>
    <message>
        <source>In all hits tried each circle has after the hit e times the momentum along that line that the other came with. The total momentum is not kept then: e acts on how fast they part alone.</source>
        <translation>In allen versuchten Stößen hat jeder Kreis nach dem Stoß das e-Fache des Impulses längs dieser Linie, mit dem der andere kam. Der Gesamtimpuls bleibt dann nicht erhalten: e wirkt nur darauf, wie schnell sie sich trennen.</translation>
    </message>
    <message>
        <source>The momenta along the line of centres change hands</source>
        <translation>Die Impulse längs der Verbindungslinie der Mittelpunkte werden getauscht</translation>
    </message>
    <message>
        <source>In all hits tried each circle has after the hit the momentum along that line that the other came with. That keeps the total momentum, but where the masses differ they do not part as fast as they met.</source>
        <translation>In allen versuchten Stößen hat jeder Kreis nach dem Stoß den Impuls längs dieser Linie, mit dem der andere kam. Das erhält den Gesamtimpuls, aber wo die Massen verschieden sind, trennen sie sich nicht so schnell, wie sie sich trafen.</translation>
    </message>
    <message>
        <source>The new parts along the line of centres have a wrong size</source>
        <translation>Die neuen Anteile längs der Verbindungslinie der Mittelpunkte haben eine falsche Größe</translation>
    </message>
    <message>
        <source>Both pushes have a wrong size</source>
        <translation>Beide Kraftstöße haben eine falsche Größe</translation>
    </message>
    <message>
        <source>Look at where the two masses are subtracted, and where they are added.</source>
        <translation>Sieh nach, wo die beiden Massen voneinander abgezogen und wo sie addiert werden.</translation>
    </message>
    <message>
        <source>In all hits tried of two masses both new parts are (m₁ + m₂) / (m₁ − m₂) times what is right.</source>
        <translation>In allen versuchten Stößen verschiedener Massen sind beide neuen Anteile das (m₁ + m₂) / (m₁ − m₂)-Fache des Richtigen.</translation>
    </message>
    <message>
        <source>In all hits tried of two masses both pushes are (m₁ + m₂) / (m₁ − m₂) times what is right.</source>
        <translation>In allen versuchten Stößen verschiedener Massen sind beide Kraftstöße das (m₁ + m₂) / (m₁ − m₂)-Fache des Richtigen.</translation>
    </message>
    <message>
        <source>In all %1 meetings tried circle 2 was at rest; in your own scene it came with %2 m/s, and there they were answered in time. Look at whose velocities the answer is made of, and at what is asked before it.</source>
        <translation>In allen %1 versuchten Begegnungen ruhte Kreis 2; in deiner eigenen Szene kam er mit %2 m/s, und dort antworteten sie rechtzeitig. Sieh nach, aus wessen Geschwindigkeiten die Antwort gemacht ist und was vor ihr gefragt wird.</translation>
    </message>
    <message>
        <source>They came nearer with %1 m/s, touched and kept their velocities; with %2 m/s they are answered.</source>
        <translation>Sie näherten sich mit %1 m/s, berührten sich und behielten ihre Geschwindigkeiten; mit %2 m/s antworten sie.</translation>
    </message>
    <message>
        <source>They came nearer with %1 m/s and ran into each other; with %2 m/s they are answered.</source>
        <translation>Sie näherten sich mit %1 m/s und liefen ineinander; mit %2 m/s antworten sie.</translation>
    </message>
    <message>
        <source>How fast they come does not matter: what counts is whether they overlap and come nearer.</source>
        <translation>Wie schnell sie kommen, spielt keine Rolle: Es zählt, ob sie überlappen und sich nähern.</translation>
    </message>
    <message>
        <source>%1 (with e = %2)</source>
        <translation>%1 (mit e = %2)</translation>
    </message>
    <message>
        <source>They go on side by side and do not part: each gets only half of the change that an elastic hit makes. Look for a factor 2 that is missing, or for a half or a mean.</source>
        <translation>Sie gehen nebeneinander weiter und trennen sich nicht: Jeder bekommt nur die Hälfte der Änderung, die ein elastischer Stoß macht. Such einen Faktor 2, der fehlt, oder eine Hälfte oder ein Mittel.</translation>
    </message>
    <message>
        <source>In your own scene the walls do not use the e that it has</source>
        <translation>In deiner eigenen Szene benutzen die Wände nicht das e, das sie hat</translation>
    </message>
    <message>
        <source>Each circle goes on with the velocity of the other</source>
        <translation>Jeder Kreis geht mit der Geschwindigkeit des anderen weiter</translation>
    </message>
    <message>
        <source>However they are started, what each has one step later comes from the velocity of the other: started with %1 m/s, circle %2 has %3 m/s. Each goes on from its own velocity: look at the names in the lines that change it, and at what is asked before them.</source>
        <translation>Wie auch gestartet, kommt bei jedem die Geschwindigkeit einen Schritt später von der des anderen: Kreis %2 wurde mit %1 m/s gestartet und hat %3 m/s. Jeder geht von seiner eigenen Geschwindigkeit aus: Sieh dir die Namen in den Zeilen an, die sie ändern, und wonach davor gefragt wird.</translation>
    </message>
    <message>
        <source>In free flight a step took the velocity of %who away</source>
        <translation>Im freien Flug nahm ein Schritt die Geschwindigkeit weg (%who)</translation>
    </message>
    <message>
        <source>What a hit makes is worked out from the velocities before it.</source>
        <translation>Was ein Stoß ergibt, wird aus den Geschwindigkeiten davor berechnet.</translation>
    </message>
    <message>
        <source>The velocities after a hit do not depend on those before</source>
        <translation>Die Geschwindigkeiten nach einem Stoß hängen nicht von denen davor ab</translation>
    </message>
    <message>
        <source>From all hits tried circle 1 leaves with %1 m/s and circle 2 with %2 m/s.</source>
        <translation>Aus allen versuchten Stößen geht Kreis 1 mit %1 m/s und Kreis 2 mit %2 m/s.</translation>
    </message>
    <message>
        <source>The new parts along the normal do not depend on the old ones</source>
        <translation>Die neuen Anteile längs der Normalen hängen nicht von den alten ab</translation>
    </message>
    <message>
        <source>Along the line of centres, from 1 to 2, circle 1 leaves all hits tried with %1 m/s and circle 2 with %2 m/s.</source>
        <translation>Längs der Verbindungslinie der Mittelpunkte, von 1 nach 2, geht Kreis 1 aus allen versuchten Stößen mit %1 m/s und Kreis 2 mit %2 m/s.</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered, in time or too early: %2.</source>
        <translation>
            <numerusform>Von %1 versuchten Begegnungen wurde %n beantwortet, rechtzeitig oder zu früh: %2.</numerusform>
            <numerusform>Von %1 versuchten Begegnungen wurden %n beantwortet, rechtzeitig oder zu früh: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered, in time or too early.</source>
        <translation>
            <numerusform>Von %1 versuchten Begegnungen wurde %n beantwortet, rechtzeitig oder zu früh.</numerusform>
            <numerusform>Von %1 versuchten Begegnungen wurden %n beantwortet, rechtzeitig oder zu früh.</numerusform>
        </translation>
    </message>
    <message>
        <source>A hit changes velocities: look at whether the lines for that run, at what is asked before them, and at whether later lines change the velocities back.</source>
        <translation>Ein Stoß ändert Geschwindigkeiten: Sieh nach, ob die Zeilen dafür laufen, was vor ihnen gefragt wird und ob spätere Zeilen die Geschwindigkeiten wieder zurückändern.</translation>
    </message>
    <message>
        <source>When they touched neither moved on as its velocity says, and after the step they had the velocities of before.</source>
        <translation>Als sie sich berührten, bewegte sich keiner so weiter, wie es seine Geschwindigkeit sagt, und nach dem Schritt hatten sie die Geschwindigkeiten von vorher.</translation>
    </message>
    <message>
        <source>When they touched circle %1 did not move on as its velocity says, and after the step both had the velocities of before.</source>
        <translation>Als sie sich berührten, bewegte sich Kreis %1 nicht so weiter, wie es seine Geschwindigkeit sagt, und nach dem Schritt hatten beide die Geschwindigkeiten von vorher.</translation>
    </message>
    <message>
        <source>In the first hit of a run the line of centres was at %1°, in a later one at %2°. Both times the push was along the first line. Every hit has a normal of its own: work it out anew.</source>
        <translation>Im ersten Stoß eines Laufs lag die Verbindungslinie der Mittelpunkte bei %1°, in einem späteren bei %2°. Beide Male ging der Kraftstoß längs der ersten Linie. Jeder Stoß hat seine eigene Normale: Errechne sie jedes Mal neu.</translation>
    </message>
    <message>
        <source>The larger of two circles answers as the lighter one</source>
        <translation>Der größere von zwei Kreisen antwortet wie der leichtere</translation>
    </message>
    <message>
        <source>Of the same density it is the heavier one. Look at whose radius stands in which mass, and at which mass stands where.</source>
        <translation>Bei gleicher Dichte ist er der schwerere. Sieh nach, wessen Radius in welcher Masse steht und welche Masse wo steht.</translation>
    </message>
    <message>
        <source>Two circles of the same radius and density answer as if circle 2 were %1 times as heavy as circle 1, and with ρ₁ = %2 and ρ₂ = %3 as if it were %4 times. Compare the lines for the two masses.</source>
        <translation>Zwei Kreise mit gleichem Radius und gleicher Dichte antworten, als wäre Kreis 2 %1-mal so schwer wie Kreis 1, und mit ρ₁ = %2 und ρ₂ = %3, als wäre er es %4-mal. Vergleiche die Zeilen für die beiden Massen.</translation>
    </message>
    <message>
        <source>The two masses have the same ratio in all hits tried</source>
        <translation>Die beiden Massen haben in allen versuchten Stößen dasselbe Verhältnis</translation>
    </message>
    <message>
        <source>Of whatever size and density the two are, they answer as if circle 2 were %1 times as heavy as circle 1. Work each mass out from the `radius` and `density` of its own circle, which other scenes change.</source>
        <translation>Wie groß und wie dicht die beiden auch sind, sie antworten, als wäre Kreis 2 %1-mal so schwer wie Kreis 1. Rechne jede Masse aus `radius` und `density` ihres eigenen Kreises aus, die sich in anderen Szenen ändern.</translation>
    </message>
    <message>
        <source>In your own scene even the first comes out wrong.</source>
        <translation>In deiner eigenen Szene geht sogar der erste falsch aus.</translation>
    </message>
    <message>
        <source>In your own scene, where circle 2 rests, the first hit comes out right.</source>
        <translation>In deiner eigenen Szene, in der Kreis 2 ruht, geht der erste Stoß richtig aus.</translation>
    </message>
    <message>
        <source>Equal circles get %1 times the right push</source>
        <translation>Gleiche Kreise bekommen das %1-Fache des richtigen Kraftstoßes</translation>
    </message>
    <message>
        <source>The push is multiplied by %1 + %2 e instead of 1 + e</source>
        <translation>Der Kraftstoß wird mit %1 + %2 e statt mit 1 + e multipliziert</translation>
    </message>
    <message>
        <source>The push is multiplied by %1 − %2 e instead of 1 + e</source>
        <translation>Der Kraftstoß wird mit %1 − %2 e statt mit 1 + e multipliziert</translation>
    </message>
    <message>
        <source>Both parts of a velocity have to become 0.</source>
        <translation>Beide Anteile einer Geschwindigkeit müssen 0 werden.</translation>
    </message>
    <message>
        <source>A hit stops circle 1 and not circle 2</source>
        <translation>Ein Stoß hält Kreis 1 an und Kreis 2 nicht</translation>
    </message>
    <message>
        <source>A hit stops circle 2 and not circle 1</source>
        <translation>Ein Stoß hält Kreis 2 an und Kreis 1 nicht</translation>
    </message>
    <message>
        <source>A hit has to stop both.</source>
        <translation>Ein Stoß muss beide anhalten.</translation>
    </message>
    <message>
        <source>Circle 1 came with %1 m/s and left with %2 m/s, circle 2 came with %3 m/s and left with %4 m/s.</source>
        <translation>Kreis 1 kam mit %1 m/s und ging mit %2 m/s, Kreis 2 kam mit %3 m/s und ging mit %4 m/s.</translation>
    </message>
    <message>
        <source>The circles exchange their whole velocities</source>
        <translation>Die Kreise tauschen ihre ganzen Geschwindigkeiten</translation>
    </message>
    <message>
        <source>Circle 1 loses its part across the normal</source>
        <translation>Kreis 1 verliert seinen Anteil quer zur Normalen</translation>
    </message>
    <message>
        <source>Circle 2 loses its part across the normal</source>
        <translation>Kreis 2 verliert seinen Anteil quer zur Normalen</translation>
    </message>
    <message>
        <source>Circle %3 is turned only when its centre is past the wall, with its rim one radius, %1 m, outside. A wall meets a body where the body ends.</source>
        <translation>Kreis %3 kehrt erst um, wenn sein Mittelpunkt hinter der Wand ist, mit dem Rand einen Radius, %1 m, draußen. Eine Wand trifft einen Körper dort, wo der Körper endet.</translation>
    </message>
    <message>
        <source>The acceleration is %1 m/s², under gravity %2 and under %3 m/s² alike.</source>
        <translation>Die Beschleunigung ist %1 m/s², unter der Schwerkraft %2 wie unter %3 m/s².</translation>
    </message>
    <message>
        <source>The fall of %who depends on radius or density</source>
        <translation>Der Fall hängt für %who von Radius oder Dichte ab</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² circle %4 is accelerated by %2 m/s², and by %3 m/s² when its radius is 1.25 times and its density 1.5 times as large. Gravity is an acceleration already: all bodies fall alike, whatever they weigh.</source>
        <translation>Unter der Schwerkraft %1 m/s² wird Kreis %4 mit %2 m/s² beschleunigt, und mit %3 m/s², wenn sein Radius das 1.25-Fache und seine Dichte das 1.5-Fache ist. Die Schwerkraft ist schon eine Beschleunigung: Alle Körper fallen gleich, wie schwer sie auch sind.</translation>
    </message>
    <message>
        <source>So it is from every start tried.</source>
        <translation>So ist es nach jedem versuchten Start.</translation>
    </message>
    <message>
        <source>It has that x from every start tried.</source>
        <translation>Dieses x hat der Kreis nach jedem versuchten Start.</translation>
    </message>
    <message>
        <source>It has that y from every start tried.</source>
        <translation>Dieses y hat der Kreis nach jedem versuchten Start.</translation>
    </message>
    <message>
        <source>Thrown at each of them without gravity, %who went on through it; at the %1 with %2 m/s. Look at whether your program asks about walls for %who, and whether the answer is ever yes.</source>
        <translation>Ohne Schwerkraft gegen jede geworfen, ging es hindurch (%who); an %1 mit %2 m/s. Sieh dir an, ob dein Programm dafür nach Wänden fragt (%who) und ob die Antwort je Ja ist.</translation>
    </message>
    <message>
        <source>Circle %1 turned when its centre was between %2 and %3 m from the wall, with the radius %4 m as with %5 m. Take the radius that the circle has.</source>
        <translation>Kreis %1 kehrte um, als sein Mittelpunkt zwischen %2 und %3 m von der Wand entfernt war, mit dem Radius %4 m wie mit %5 m. Nimm den Radius, den der Kreis hat.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who another share of the speed than e</source>
        <translation>Stöße an %walls geben für %who einen anderen Anteil des Tempos zurück als e</translation>
    </message>
    <message>
        <source>At the floor, none slower than %1 m/s was tried.</source>
        <translation>Am Boden wurde keiner versucht, der langsamer als %1 m/s ist.</translation>
    </message>
    <message>
        <source>With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m</source>
        <translation>Mit der Geschwindigkeit %1 m/s und Δt = %2 s ist der Weg eines Schritts %3 m</translation>
    </message>
    <message>
        <source>; %1 m is right.</source>
        <translation>; richtig sind %1 m.</translation>
    </message>
    <message>
        <source>, of which %1 m are not of the velocity; v Δt is %2 m.</source>
        <translation>, davon kommen %1 m nicht von der Geschwindigkeit; v Δt ist %2 m.</translation>
    </message>
    <message>
        <source>Only in your own scene a step moves %who</source>
        <translation>Nur in deiner eigenen Szene bewegt ein Schritt etwas (%who)</translation>
    </message>
    <message>
        <source>In the first step of your own scene it goes %1 m, as its velocity there makes it. So it should from every start: look at what is asked before the line that moves it.</source>
        <translation>Im ersten Schritt deiner eigenen Szene geht es %1 m weit, wie es die Geschwindigkeit dort verlangt. So soll es nach jedem Start sein: Sieh dir an, was vor der Zeile gefragt wird, die bewegt.</translation>
    </message>
    <message>
        <source>The circles are answered too late, or not at all</source>
        <translation>Die Kreise antworten zu spät oder gar nicht</translation>
    </message>
    <message>
        <source>Circle 1 answers where it meets circle 2</source>
        <translation>Kreis 1 antwortet, wo er Kreis 2 trifft</translation>
    </message>
    <message>
        <source>Circle 2 answers where it meets circle 1</source>
        <translation>Kreis 2 antwortet, wo er Kreis 1 trifft</translation>
    </message>
    <message>
        <source>Along the line of centres and across it alike the velocities are multiplied by one number. Both directions need length 1, else their length comes in twice.</source>
        <translation>Längs der Verbindungslinie der Mittelpunkte wie quer zu ihr sind die Geschwindigkeiten mit einer Zahl multipliziert. Beide Richtungen brauchen die Länge 1, sonst geht ihre Länge zweimal ein.</translation>
    </message>
    <message>
        <source>Normal and tangent are too short</source>
        <translation>Normale und Tangente sind zu kurz</translation>
    </message>
    <message>
        <source>Normal and tangent are too long</source>
        <translation>Normale und Tangente sind zu lang</translation>
    </message>
    <message>
        <source>Mass is density times volume, for each ball with its own radius: it grows with r³.</source>
        <translation>Masse ist Dichte mal Volumen, für jede Kugel mit ihrem eigenen Radius: Sie wächst mit r³.</translation>
    </message>
    <message>
        <source>Two equal circles do not count as equally heavy</source>
        <translation>Zwei gleiche Kreise gelten nicht als gleich schwer</translation>
    </message>
    <message>
        <source>They answer as if circle 2 were %1 times as heavy as circle 1. Compare the lines for the two masses, and those for the two pushes, number by number.</source>
        <translation>Sie antworten, als wäre Kreis 2 %1-mal so schwer wie Kreis 1. Vergleiche die Zeilen für die beiden Massen und die für die beiden Kraftstöße, Zahl für Zahl.</translation>
    </message>
    <message>
        <source>With e = %1 a hit changes no velocity</source>
        <translation>Mit e = %1 ändert ein Stoß keine Geschwindigkeit</translation>
    </message>
    <message>
        <source>They came nearer with %1 m/s along the line of centres, touched, and both kept their velocities; with e = %2 it comes out right. Look at what is asked before the lines with the answer, and at what e does there.</source>
        <translation>Sie kamen sich längs der Verbindungslinie der Mittelpunkte mit %1 m/s näher, berührten sich und behielten beide ihre Geschwindigkeit; mit e = %2 geht es richtig aus. Sieh nach, was vor den Zeilen mit der Antwort gefragt wird und was e dort tut.</translation>
    </message>
    <message>
        <source>all but those where %1</source>
        <translation>alle außer denen, bei denen %1</translation>
    </message>
    <message>
        <source>those where %1, no others</source>
        <translation>die, bei denen %1, keine anderen</translation>
    </message>
    <message>
        <source>In one of %1 s it changes as it should. Look at which Δt the line that changes the velocity takes.</source>
        <translation>In einem von %1 s ändert sie sich, wie sie soll. Sieh nach, welches Δt die Zeile nimmt, die die Geschwindigkeit ändert.</translation>
    </message>
    <message>
        <source>Let go at rest, it has %1 m/s one step of %2 s later, far from every wall and every other circle; gravity gives it %3 m/s in a step. Look at which lines change its velocity there, and at what is asked before them.</source>
        <translation>In Ruhe losgelassen, hat er einen Schritt von %2 s später %1 m/s, fern von jeder Wand und jedem anderen Kreis; die Schwerkraft gibt ihm %3 m/s in einem Schritt. Sieh nach, welche Zeilen dort seine Geschwindigkeit ändern und was vor ihnen gefragt wird.</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and left it with %4 m/s, which is about %5 times as much, and `restitution` is %6.</source>
        <translation>Kreis %1 kam mit %3 m/s an %2 an und ging mit %4 m/s, das ist etwa das %5-Fache, und `restitution` ist %6.</translation>
    </message>
    <message>
        <source>Other scenes come out right. A copy of e that is made before e is set keeps the old value.</source>
        <translation>Andere Szenen gehen richtig aus. Eine Kopie von e, die entsteht, bevor e gesetzt ist, behält den alten Wert.</translation>
    </message>
    <message>
        <source>In your own scene walls give another share of the speed back than e</source>
        <translation>In deiner eigenen Szene kommt von Wänden ein anderer Teil des Tempos zurück als e</translation>
    </message>
    <message>
        <source>Of %1 fast hits in that run, %2 came out right. Look at what the new velocity is worked out from, and at what is asked before.</source>
        <translation>Von %1 schnellen Stößen in diesem Lauf gingen richtig aus: %2. Sieh dir an, woraus die neue Geschwindigkeit berechnet wird und was vorher gefragt wird.</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n were answered.</source>
        <translation>
            <numerusform>Von %1 Versuchen, früh und spät, hier und dort, wurde %n beantwortet.</numerusform>
            <numerusform>Von %1 Versuchen, früh und spät, hier und dort, wurden %n beantwortet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n were answered: %2.</source>
        <translation>
            <numerusform>Von %1 Versuchen, früh und spät, hier und dort, wurde %n beantwortet: %2.</numerusform>
            <numerusform>Von %1 Versuchen, früh und spät, hier und dort, wurden %n beantwortet: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Of %1 hits tried there, %2 came out right. Look at what your program asks there.</source>
        <translation>Von %1 dort versuchten Stößen gingen richtig aus: %2. Sieh dir an, was dein Programm dort fragt.</translation>
    </message>
    <message>
        <source>This one was answered: circle %1 at %2 s, at the %3 at %4 m with %5 m/s.</source>
        <translation>Dieser wurde beantwortet: Kreis %1 nach %2 s, an %3 bei %4 m mit %5 m/s.</translation>
    </message>
    <message>
        <source>Look at what your program asks besides whether the rim is past the wall and the circle moves into it.</source>
        <translation>Sieh dir an, was dein Programm außerdem fragt: Es zählt nur, ob der Rand jenseits der Wand ist und der Kreis sich in sie hinein bewegt.</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s and e = %3, circle %4 went on past it; with %5 m/s and e = %6 it did not.</source>
        <translation>Mit %2 m/s und e = %3 zu %1 geworfen, ging Kreis %4 darüber hinaus; mit %5 m/s und e = %6 nicht.</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s from %3 m, circle %4 went on past it; with %5 m/s from %6 m it is turned round.</source>
        <translation>Mit %2 m/s von %3 m aus zu %1 geworfen, ging Kreis %4 darüber hinaus; mit %5 m/s von %6 m aus kehrt er um.</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s from %3 m, circle %4 went on past it; with %5 m/s from %6 m it is held there.</source>
        <translation>Mit %2 m/s von %3 m aus zu %1 geworfen, ging Kreis %4 darüber hinaus; mit %5 m/s von %6 m aus wird er dort festgehalten.</translation>
    </message>
    <message>
        <source>Slow hits at the %walls turn %who round too early</source>
        <translation>Langsame Stöße an %walls lassen %who zu früh umkehren</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and turned when its centre was between %4 and %5 m from the wall; its radius is %6 m. With %7 m/s it turned at its rim, as far as a step of %8 m shows.</source>
        <translation>Kreis %1 kam mit %3 m/s an %2 an und kehrte um, als sein Mittelpunkt zwischen %4 und %5 m von der Wand entfernt war; sein Radius ist %6 m. Mit %7 m/s kehrte er am Rand um, soweit ein Schritt von %8 m das zeigt.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who one and the same speed</source>
        <translation>Stöße an %walls geben für %who immer dasselbe Tempo</translation>
    </message>
    <message>
        <source>From every speed tried it leaves with %1 m/s: work the new velocity out from the old one.</source>
        <translation>Nach jedem versuchten Tempo geht er mit %1 m/s weg: Rechne die neue Geschwindigkeit aus der alten aus.</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round a step too late</source>
        <translation>Stöße an %walls lassen %who einen Schritt zu spät umkehren</translation>
    </message>
    <message>
        <source>At the %1 the rim of circle %2 was %3 m past the wall before the step in which it was turned round, and %4 m after it. Turn it in the step in which its rim comes past the wall.</source>
        <translation>An %1 war der Rand von Kreis %2 vor dem Schritt, in dem er umkehrte, %3 m jenseits der Wand, und nach ihm %4 m. Lass ihn in dem Schritt umkehren, in dem sein Rand über die Wand hinauskommt.</translation>
    </message>
    <message>
        <source>In a corner the velocity of %who is lost</source>
        <translation>In einer Ecke geht die Geschwindigkeit verloren (%who)</translation>
    </message>
    <message>
        <source>Circle %3 came with %1 m/s and has %2 m/s after it. Both walls are hit in the same step, and each must turn its own part.</source>
        <translation>Kreis %3 kam mit %1 m/s an und hat danach %2 m/s. Beide Wände werden im selben Schritt getroffen, und jede muss ihren Anteil umkehren.</translation>
    </message>
    <message>
        <source>When circle %1 was %2 m from the %3 its velocity stayed as it was, and that of the other changed, far from it and from every wall. A wall turns the circle that touches it, and no other.</source>
        <translation>Als Kreis %1 noch %2 m von %3 entfernt war, blieb seine Geschwindigkeit, wie sie war, und die des anderen änderte sich, der weit von ihm und von jeder Wand war. Eine Wand lässt den Kreis umkehren, der sie berührt, und keinen anderen.</translation>
    </message>
    <message>
        <source>Beside a wall the velocity of another circle changes</source>
        <translation>Neben einer Wand ändert sich die Geschwindigkeit eines anderen Kreises</translation>
    </message>
    <message>
        <source>Until this is right, no more can be said of walls and hits.</source>
        <translation>Bevor das stimmt, lässt sich über Wände und Stöße nichts Weiteres sagen.</translation>
    </message>
    <message>
        <source>Until this is right, no more can be said of the walls.</source>
        <translation>Bevor das stimmt, lässt sich über die Wände nichts Weiteres sagen.</translation>
    </message>
    <message>
        <source>Gravity leaves out steps of %who at the floor</source>
        <translation>Am Boden lässt die Schwerkraft Schritte aus, für %who</translation>
    </message>
    <message>
        <source>Gravity acts twice in a step of %who at the floor</source>
        <translation>Am Boden wirkt die Schwerkraft in einem Schritt zweimal, für %who</translation>
    </message>
    <message>
        <source>Thrown down with %1 m/s, circle %2 was turned by the floor in step %3. In that step its velocity went from %4 to %5 m/s; %6 m/s is right: turned round, and with g Δt once. Gravity acts once in every step, also where a circle touches the floor.</source>
        <translation>Mit %1 m/s nach unten geworfen, kehrte Kreis %2 in Schritt %3 am Boden um. In diesem Schritt ging seine Geschwindigkeit von %4 auf %5 m/s; richtig ist %6 m/s: umgekehrt und einmal mit g Δt. Die Schwerkraft wirkt in jedem Schritt einmal, auch wo ein Kreis den Boden berührt.</translation>
    </message>
    <message>
        <source>Thrown down with %1 m/s, circle %2 was turned by the floor in step %3. In step %7 its velocity went from %4 to %5 m/s; %6 m/s is right. Gravity acts once in every step, also where a circle touches the floor.</source>
        <translation>Mit %1 m/s nach unten geworfen, kehrte Kreis %2 in Schritt %3 am Boden um. In Schritt %7 ging seine Geschwindigkeit von %4 auf %5 m/s; richtig ist %6 m/s. Die Schwerkraft wirkt in jedem Schritt einmal, auch wo ein Kreis den Boden berührt.</translation>
    </message>
    <message>
        <source>Until this is right, no more can be said of the hits of the two circles.</source>
        <translation>Bevor das stimmt, lässt sich über die Stöße der beiden Kreise nichts Weiteres sagen.</translation>
    </message>
    <message>
        <source>all at the very start of a run, none later</source>
        <translation>alle ganz am Anfang eines Laufs, keine später</translation>
    </message>
    <message>
        <source>all at the very start of a run, none from %1 s on</source>
        <translation>alle ganz am Anfang eines Laufs, keine ab %1 s</translation>
    </message>
    <message>
        <source>Seen of circles that move apart, which your program answers as if they met; right is what the answer should make of these velocities.</source>
        <translation>Gesehen an Kreisen, die sich voneinander entfernen: Ihnen antwortet dein Programm, als träfen sie sich; richtig ist, was die Antwort aus diesen Geschwindigkeiten machen soll.</translation>
    </message>
    <message>
        <source>The test of contact acts as if a number stood for %1</source>
        <translation>Der Test auf Berührung wirkt, als stünde eine Zahl für %1</translation>
    </message>
    <message>
        <source>With all radii tried they answer where the distance of the centres is between %1 + %2 m and %1 + %3 m.</source>
        <translation>Mit allen versuchten Radien antworten sie, wo der Abstand der Mittelpunkte zwischen %1 + %2 m und %1 + %3 m liegt.</translation>
    </message>
    <message>
        <source>The whole relative velocity is turned round</source>
        <translation>Die ganze relative Geschwindigkeit wird umgekehrt</translation>
    </message>
    <message>
        <source>What turns the parts along the line of centres round does the same to those across. A smooth circle pushes along the line of centres only; each keeps its own part across.</source>
        <translation>Was die Anteile längs der Verbindungslinie umkehrt, tut dasselbe mit denen quer dazu. Ein glatter Kreis stößt nur längs der Verbindungslinie der Mittelpunkte; jeder behält seinen eigenen Anteil quer dazu.</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m: </source>
        <translation>Mit r₁ = %1 und r₂ = %2 m: </translation>
    </message>
    <message>
        <source>Circles of different radii come out of a hit wrong</source>
        <translation>Kreise mit verschiedenen Radien gehen falsch aus einem Stoß hervor</translation>
    </message>
    <message>
        <source>Circles of the same radius come out right: look at where the radii enter what each of the two gets of the other.</source>
        <translation>Kreise mit gleichem Radius gehen richtig daraus hervor: Sieh nach, wo die Radien in das eingehen, was jeder der beiden vom anderen bekommt.</translation>
    </message>
    <message>
        <source>The size of the push hangs on the mass of circle %1 alone</source>
        <translation>Wie groß der Kraftstoß ist, hängt allein an der Masse von Kreis %1</translation>
    </message>
    <message>
        <source>In all hits tried both pushes are as large as if both circles had the mass of circle %1; what each makes of its own push is right. Look at which masses stand in the size of the push.</source>
        <translation>In allen versuchten Stößen sind beide Kraftstöße so groß, als hätten beide Kreise die Masse von Kreis %1; was jeder aus seinem eigenen macht, ist richtig. Sieh nach, welche Massen in der Größe des Kraftstoßes stehen.</translation>
    </message>
    <message>
        <source>Look at whether the normal has length 1 where they overlap.</source>
        <translation>Sieh nach, ob die Normale die Länge 1 hat, wenn sie sich überlappen.</translation>
    </message>
    <message>
        <source>Look at whether the normal has length 1 where it is made, before they touch.</source>
        <translation>Sieh nach, ob die Normale die Länge 1 hat, wo sie gebildet wird: bevor sie sich berühren.</translation>
    </message>
    <message>
        <source>How deep they overlap after a step is chance: it may move their places apart, but must not come into the velocities.</source>
        <translation>Wie tief sie sich nach einem Schritt überlappen, ist Zufall: es darf die Orte auseinanderschieben, aber nicht in die Geschwindigkeiten eingehen.</translation>
    </message>
    <message>
        <source>What a hit does depends on where in a step they touch</source>
        <translation>Was ein Stoß tut, hängt davon ab, wann im Schritt sie sich berühren</translation>
    </message>
    <message>
        <source>Where their rims touched after a quarter of a step of %1 s, they left with %2; where after two thirds, with %3; %4 are right.</source>
        <translation>Wo sich die Ränder nach einem Viertel eines Schrittes von %1 s berührten, gingen sie mit %2 weg; wo nach zwei Dritteln, mit %3; %4 sind richtig.</translation>
    </message>
    <message>
        <source>%1 and %2 m/s</source>
        <translation>%1 und %2 m/s</translation>
    </message>
    <message>
        <source>Two equal circles met head-on with %1 and %2 m/s; e was %3.</source>
        <translation>Zwei gleiche Kreise trafen sich frontal mit %1 und %2 m/s; e war %3.</translation>
    </message>
    <message>
        <source>Two equal circles met head-on with %1 and %2 m/s.</source>
        <translation>Zwei gleiche Kreise trafen sich frontal mit %1 und %2 m/s.</translation>
    </message>
    <message>
        <source>In the step of the hit their velocities became %2 with a timestep of %1 s, and %4 with %3 s; %5 are right.</source>
        <translation>Im Schritt des Stoßes wurden ihre Geschwindigkeiten %2 bei einem Zeitschritt von %1 s und %4 bei %3 s; %5 sind richtig.</translation>
    </message>
    <message>
        <source>A hit takes no time: look at where the timestep comes into what it does.</source>
        <translation>Ein Stoß dauert keine Zeit: sieh nach, wo der Zeitschritt in das eingeht, was er tut.</translation>
    </message>
    <message>
        <source>What a hit does depends on the timestep</source>
        <translation>Was ein Stoß tut, hängt vom Zeitschritt ab</translation>
    </message>
    <message>
        <source>A hit pushes circle %1 into the other one

In a step that would have brought their centres to %2 m from each other the hit put circle %1 %4 m nearer to the other one than its velocities before and after it take it; rims touch at %3 m. Each goes back to where it came from, or they are moved apart: look at the sign of the way that circle %1 is moved, and at whose velocity is in it.</source>
        <translation>Ein Stoß schiebt Kreis %1 in den anderen

In einem Schritt, der ihre Mittelpunkte auf %2 m Abstand gebracht hätte, setzte der Stoß Kreis %1 um %4 m näher an den anderen, als ihn seine Geschwindigkeiten davor und danach bringen; die Ränder berühren sich bei %3 m. Jeder geht dorthin zurück, woher er kam, oder sie werden auseinandergesetzt: Sieh dir das Vorzeichen des Weges an, um den Kreis %1 versetzt wird, und wessen Geschwindigkeit darin steht.</translation>
    </message>
    <message>
        <source>A hit puts circle %1 too far away

In a step that would have brought their centres to %2 m from each other, where rims touch at %3 m, the hit put circle %1 %4 m farther from the other one than its velocities and twice that overlap explain. It is enough that they touch: look at how far it is moved.</source>
        <translation>Ein Stoß setzt Kreis %1 zu weit weg

In einem Schritt, der ihre Mittelpunkte auf %2 m Abstand gebracht hätte, wo sich die Ränder bei %3 m berühren, setzte der Stoß Kreis %1 um %4 m weiter vom anderen weg, als seine Geschwindigkeiten und das Doppelte dieser Überlappung erklären. Es genügt, dass sie sich berühren: Sieh dir an, wie weit er versetzt wird.</translation>
    </message>
    <message>
        <source>A hit moves circle %1 to the side

In a step that would have brought their centres to %2 m from each other, where rims touch at %3 m, the hit put circle %1 %4 m to the side of the ways that its velocities before and after it take it. A hit may move circles apart along the line of centres only: look at the direction in which it is moved, and at whose velocity is in it.</source>
        <translation>Ein Stoß versetzt Kreis %1 zur Seite

In einem Schritt, der ihre Mittelpunkte auf %2 m Abstand gebracht hätte, wo sich die Ränder bei %3 m berühren, setzte der Stoß Kreis %1 um %4 m seitlich neben die Wege, die ihn seine Geschwindigkeiten davor und danach bringen. Ein Stoß darf die Kreise nur entlang der Mittelpunktslinie auseinandersetzen: Sieh dir die Richtung an, in die er versetzt wird, und wessen Geschwindigkeit darin steht.</translation>
    </message>
    <message>
        <source>At the %walls the density comes into the speed of %who</source>
        <translation>An %walls hängt die Geschwindigkeit von der Dichte ab, für %who</translation>
    </message>
    <message>
        <source>With ρ = %1 what comes back is %2 times the speed, with ρ = %3 it is %4 times; %5 is right.</source>
        <translation>Mit ρ = %1 kommt das %2-fache der Geschwindigkeit zurück, mit ρ = %3 das %4-fache; %5 ist richtig.</translation>
    </message>
    <message>
        <source>In your own scene circle %1 turns too late at the walls</source>
        <translation>In deiner eigenen Szene kehrt Kreis %1 an den Wänden zu spät um</translation>
    </message>
    <message>
        <source>In your own scene circle %1 turns too early at the walls</source>
        <translation>In deiner eigenen Szene kehrt Kreis %1 an den Wänden zu früh um</translation>
    </message>
    <message>
        <source>Its radius is %1 m, and at the %2 it turned in a step that would have brought its centre from %3 to %4 m from the wall. In scenes that have their radii before your program begins it turns in time. Look at when your program reads the radii: what is read before `on_load` sets them is an old value.</source>
        <translation>Sein Radius ist %1 m, und an %2 kehrte er in einem Schritt um, der seinen Mittelpunkt von %3 auf %4 m an die Wand gebracht hätte. In Szenen, deren Radien schon vor dem Beginn deines Programms feststehen, kehrt er rechtzeitig um. Sieh nach, wann dein Programm die Radien liest: Was gelesen wird, bevor `on_load` sie setzt, ist ein alter Wert.</translation>
    </message>
    <message>
        <source>The first step of the hit, of %1 s, left them with %2, step %3 of it with %4; %5 are right, from the first on.</source>
        <translation>Der erste Schritt des Stoßes, von %1 s, ließ ihnen %2, sein Schritt %3 %4; richtig sind %5, und zwar vom ersten an.</translation>
    </message>
    <message>
        <source>A hit takes no time: all that it changes is due in the step in which they touch.</source>
        <translation>Ein Stoß braucht keine Zeit: Alles, was er ändert, gehört in den Schritt, in dem sie sich berühren.</translation>
    </message>
    <message>
        <source>The push of a hit is spread over several steps</source>
        <translation>Der Kraftstoß eines Stoßes verteilt sich auf mehrere Schritte</translation>
    </message>
    <message>
        <source>The first step of a run is made in another way.</source>
        <translation>Der erste Schritt eines Laufs geschieht anders.</translation>
    </message>
    <message>
        <source>With its rim %1 m from the %2 and %3 m/s, circle %4 had %5 m/s one step of %6 s later; in free flight it has %7 m/s.</source>
        <translation>Mit dem Rand %1 m vor %2 und %3 m/s hatte Kreis %4 einen Schritt von %6 s später %5 m/s; im freien Flug hat er %7 m/s.</translation>
    </message>
    <message>
        <source>With its rim %1 m from the %2 and %3 m/s, circle %4 went %5 m in a step of %6 s; in free flight it goes %7 m.</source>
        <translation>Mit dem Rand %1 m vor %2 und %3 m/s ging Kreis %4 in einem Schritt von %6 s um %5 m weiter; im freien Flug sind es %7 m.</translation>
    </message>
    <message>
        <source>Near the %walls the steps of %who are made in another way</source>
        <translation>Vor %walls geschehen die Schritte von %who anders</translation>
    </message>
    <message>
        <source>Look at what your program asks there before its rim is at the wall.</source>
        <translation>Sieh dir an, was dein Programm dort fragt, bevor der Rand an der Wand ist.</translation>
    </message>
    <message>
        <source>After hits at the %walls the way of %who is not v Δt</source>
        <translation>Nach Stößen an %walls folgt die Bewegung von %who nicht der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Another circle that is near changes the velocity of %who</source>
        <translation>Ein anderer Kreis in der Nähe ändert die Geschwindigkeit von %who</translation>
    </message>
    <message>
        <source>In your own scene it starts with %1 m/s and has %2 m/s one step later; with every other circle set elsewhere it has %3 m/s then. In this step of the lab circles go through each other: look at what compares their places.</source>
        <translation>In deiner eigenen Szene startet er mit %1 m/s und hat einen Schritt später %2 m/s; sind alle anderen Kreise anderswo, hat er dann %3 m/s. In diesem Schritt des Labs gehen Kreise durcheinander hindurch: Sieh dir an, was ihre Orte vergleicht.</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits of unequal circles tried with e = %2, %n came out right: %3.</source>
        <translation>
            <numerusform>Von %1 versuchten Stößen ungleicher Kreise mit e = %2 ging %n richtig aus: %3.</numerusform>
            <numerusform>Von %1 versuchten Stößen ungleicher Kreise mit e = %2 gingen %n richtig aus: %3.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits of unequal circles tried, %n came out right: %2.</source>
        <translation>
            <numerusform>Von %1 versuchten Stößen ungleicher Kreise ging %n richtig aus: %2.</numerusform>
            <numerusform>Von %1 versuchten Stößen ungleicher Kreise gingen %n richtig aus: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Look at what the answer takes for e there, and at what is asked before it.</source>
        <translation>Sieh dir an, was die Antwort dort für e nimmt und was vorher gefragt wird.</translation>
    </message>
    <message>
        <source>In all hits of equal circles tried the velocities changed along that line by whole numbers of m/s: look for what rounds a number, such as `//` or `math.floor`.</source>
        <translation>In allen versuchten Stößen gleicher Kreise änderten sich die Geschwindigkeiten längs dieser Linie um ganze Zahlen von m/s: Suche, was eine Zahl rundet, etwa `//` oder `math.floor`.</translation>
    </message>
    <message>
        <source>With r₁ = %1 m and r₂ = %2 m, met at %3°, they answered when their centres were %4 m apart.</source>
        <translation>Mit r₁ = %1 m und r₂ = %2 m antworteten sie bei einem Treffen unter %3°, als ihre Mittelpunkte %4 m auseinander waren.</translation>
    </message>
    <message>
        <source>Where their rims touched after a quarter of a step of %1 s, they were answered; where after two thirds, they ran into each other.</source>
        <translation>Wo sich die Ränder nach einem Viertel eines Schrittes von %1 s berührten, antworteten sie; wo nach zwei Dritteln, liefen sie ineinander.</translation>
    </message>
    <message>
        <source>Where their rims touched after two thirds of a step of %1 s, they were answered; where after a quarter, they ran into each other.</source>
        <translation>Wo sich die Ränder nach zwei Dritteln eines Schrittes von %1 s berührten, antworteten sie; wo nach einem Viertel, liefen sie ineinander.</translation>
    </message>
    <message>
        <source>Whether a hit is answered depends on where in a step they touch</source>
        <translation>Ob ein Stoß beantwortet wird, hängt davon ab, wann im Schritt sie sich berühren</translation>
    </message>
    <message>
        <source>Look at how the moment of the hit is worked out, and at what is done with circles that overlap already.</source>
        <translation>Sieh dir an, wie der Moment des Stoßes berechnet wird und was mit Kreisen geschieht, die schon überlappen.</translation>
    </message>
    <message>
        <source>On the floor the speed of %who along it changes</source>
        <translation>Auf dem Boden ändert sich das Tempo längs des Bodens (%who)</translation>
    </message>
    <message>
        <source>Circle %1 was let go %2 m above the floor with %3 m/s along it, and had %4 m/s along it %5 s later; %3 m/s is right. Where nothing rubs, a push points along the normal only: look at what slow hits at the floor change.</source>
        <translation>Kreis %1 wurde %2 m über dem Boden mit %3 m/s längs des Bodens losgelassen und hatte %5 s später %4 m/s längs des Bodens; richtig sind %3 m/s. Wo nichts reibt, wirkt ein Stoß nur längs der Normalen: Sieh dir an, was langsame Stöße am Boden ändern.</translation>
    </message>
    <message>
        <source>Above the floor gravity stops moving %who</source>
        <translation>Über dem Boden wirkt die Schwerkraft nicht mehr (%who)</translation>
    </message>
    <message>
        <source>Circle %1 was let go at rest %2 m above the floor, and from %3 s on it stood still %4 m above it, where nothing holds it. Look at what keeps a circle still, and at whether it lies on the floor then.</source>
        <translation>Kreis %1 wurde %2 m über dem Boden in Ruhe losgelassen und stand ab %3 s %4 m darüber still, wo ihn nichts hält. Sieh dir an, was einen Kreis stillhält und ob er dann auf dem Boden liegt.</translation>
    </message>
    <message>
        <source>At the %walls the part along the wall comes into the rebound of %who</source>
        <translation>An %walls geht der Anteil längs der Wand in den Rückprall ein, für %who</translation>
    </message>
    <message>
        <source>With %1 m/s into the wall and %2 m/s along it, %3 times the part into it comes back; with %4 m/s along it %5 times. The part along a wall should not count there.</source>
        <translation>Mit %1 m/s in die Wand und %2 m/s längs der Wand kommt das %3-Fache des Anteils in die Wand zurück; mit %4 m/s längs der Wand das %5-Fache. Der Anteil längs einer Wand darf dabei nicht zählen.</translation>
    </message>
    <message>
        <source>A wall turns the speed round; no fixed amount is added to it or taken from it.</source>
        <translation>Eine Wand kehrt die Geschwindigkeit um; sie nimmt keinen festen Betrag weg und gibt keinen dazu.</translation>
    </message>
    <message>
        <source>Hits at the %walls take a fixed amount of speed from %who</source>
        <translation>Stöße an %walls nehmen einen festen Betrag an Tempo weg, für %who</translation>
    </message>
    <message>
        <source>Hits at the %walls add a fixed amount of speed to %who</source>
        <translation>Stöße an %walls geben einen festen Betrag an Tempo dazu, für %who</translation>
    </message>
    <message>
        <source>From every speed tried it leaves with about %1 m/s too little.</source>
        <translation>Nach jeder versuchten Geschwindigkeit geht er mit etwa %1 m/s zu wenig.</translation>
    </message>
    <message>
        <source>From every speed tried it leaves with about %1 m/s too much.</source>
        <translation>Nach jeder versuchten Geschwindigkeit geht er mit etwa %1 m/s zu viel.</translation>
    </message>
    <message>
        <source>Its velocity points away from the wall only %1 s later, in steps of %2 s.</source>
        <translation>Erst %1 s später, in Schritten von %2 s, zeigt seine Geschwindigkeit von der Wand weg.</translation>
    </message>
    <message>
        <source>In a step in which circle %1 hits a wall, circle %2 hits none</source>
        <translation>Im Schritt, in dem Kreis %1 eine Wand trifft, trifft Kreis %2 keine</translation>
    </message>
    <message>
        <source>Thrown with %1 m/s, circle %2 came to the %3, and circle %5 with %4 m/s to the %6 in the same step: circle %2 was turned in it, and circle %5 was not. Alone it is. Look at what your program leaves out when the other circle is hit.</source>
        <translation>Mit %1 m/s geworfen, kam Kreis %2 an %3 an, und Kreis %5 mit %4 m/s im selben Schritt an %6: Darin kehrte Kreis %2 um, Kreis %5 nicht. Allein kehrt er um. Sieh dir an, was dein Programm auslässt, wenn der andere Kreis getroffen wird.</translation>
    </message>
    <message>
        <source>From every speed and with every e tried it leaves with about %1 m/s less than it came with.</source>
        <translation>Nach jeder versuchten Geschwindigkeit und mit jedem versuchten e geht er mit etwa %1 m/s weniger, als er kam.</translation>
    </message>
    <message>
        <source>From every speed and with every e tried it leaves with about %1 m/s more than it came with.</source>
        <translation>Nach jeder versuchten Geschwindigkeit und mit jedem versuchten e geht er mit etwa %1 m/s mehr, als er kam.</translation>
    </message>
    <message>
        <source>The distance of circles that come nearer is less than in the step before: look at what your program compares with what it keeps from there.</source>
        <translation>Der Abstand von Kreisen, die sich nähern, ist kleiner als im Schritt davor: Sieh nach, was dein Programm mit dem vergleicht, was es von dort behält.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, in the first four steps of %2 s it goes %3, %4, %5 and %6 m more than is right of the velocity before each.</source>
        <translation>Mit %1 m/s gestartet, geht er in den ersten vier Schritten von %2 s um %3, %4, %5 und %6 m weiter, als nach der Geschwindigkeit vor jedem richtig ist.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, in the first four steps of %2 s its velocity changes by %3, %4, %5 and %6 m/s more than is right.</source>
        <translation>Mit %1 m/s gestartet, ändert sich seine Geschwindigkeit in den ersten vier Schritten von %2 s um %3, %4, %5 und %6 m/s mehr, als richtig ist.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, in the first four steps of %2 s it goes %3, %4, %5 and %6 m; %7 m is right in each.</source>
        <translation>Mit %1 m/s gestartet, geht er in den ersten vier Schritten von %2 s um %3, %4, %5 und %6 m weiter; richtig ist in jedem %7 m.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, in the first four steps of %2 s its velocity changes by %3, %4, %5 and %6 m/s; %7 m/s is right in each.</source>
        <translation>Mit %1 m/s gestartet, ändert sich seine Geschwindigkeit in den ersten vier Schritten von %2 s um %3, %4, %5 und %6 m/s; richtig ist in jedem %7 m/s.</translation>
    </message>
    <message>
        <source>From step to step that grows by the same: look at what your program adds up, or counts, since the start.</source>
        <translation>Von Schritt zu Schritt wächst das um gleich viel: Sieh nach, was dein Programm seit dem Start aufsummiert oder zählt.</translation>
    </message>
    <message>
        <source>Look at what your program counts, or keeps from one step to the next, and at what is asked before these lines.</source>
        <translation>Sieh nach, was dein Programm zählt oder von einem Schritt zum nächsten behält, und was vor diesen Zeilen gefragt wird.</translation>
    </message>
    <message>
        <source>Turned round at the %1, circle %2 has %3 m/s; in the next step of %4 s it went %5 m, and by that velocity it is %6 m.</source>
        <translation>An %1 umgekehrt hat Kreis %2 %3 m/s; im nächsten Schritt von %4 s ging er um %5 m weiter, und nach dieser Geschwindigkeit sind es %6 m.</translation>
    </message>
    <message>
        <source>So it goes in a run that begins there, too: look at what your program does with a circle that is at a wall and moves away from it.</source>
        <translation>So geht er auch in einem Lauf, der dort beginnt: Sieh nach, was dein Programm mit einem Kreis macht, der an einer Wand ist und sich von ihr entfernt.</translation>
    </message>
    <message>
        <source>A velocity or an old place that your program keeps in a variable of its own must change at a hit, too.</source>
        <translation>Auch eine Geschwindigkeit oder ein alter Ort, die dein Programm in einer eigenen Variablen behält, müssen sich bei einem Stoß ändern.</translation>
    </message>
    <message>
        <source>A step takes %who much farther than its velocity does</source>
        <translation>Ein Schritt bringt %who viel weiter als seine Geschwindigkeit</translation>
    </message>
    <message>
        <source>Started with %1 m/s, away from every wall and every other circle, it goes %2 m in the first step of %3 s; v Δt is %4 m. Look at which lines change the position, and at what is asked before them.</source>
        <translation>Mit %1 m/s gestartet, fern von jeder Wand und jedem anderen Kreis, kommt er im ersten Schritt von %3 s %2 m weit; v Δt ist %4 m. Sieh nach, welche Zeilen die Position ändern und was vor ihnen gefragt wird.</translation>
    </message>
    <message>
        <source>Your program sets it at %1 m, and one step later it is at %2 m: that step goes on from %3 m, where the scene has it.</source>
        <translation>Dein Programm setzt ihn auf %1 m, und einen Schritt später ist er bei %2 m: Dieser Schritt geht von %3 m aus, wo die Szene ihn hat.</translation>
    </message>
    <message>
        <source>Your program starts it with %1 m/s, and one step later it has %2 m/s: that step goes on from %3 m/s, which the scene gives it.</source>
        <translation>Dein Programm startet ihn mit %1 m/s, und einen Schritt später hat er %2 m/s: Dieser Schritt geht von %3 m/s aus, die ihm die Szene gibt.</translation>
    </message>
    <message>
        <source>Your program sets it at %1 m with %2 m/s, and one step later it is at %3 m with %4 m/s: that step goes on from %5 m and %6 m/s, which the scene gives it.</source>
        <translation>Dein Programm setzt ihn mit %2 m/s auf %1 m, und einen Schritt später ist er mit %4 m/s bei %3 m: Dieser Schritt geht von %5 m und %6 m/s aus, die ihm die Szene gibt.</translation>
    </message>
    <message>
        <source>The start of %who in your own scene is not taken over</source>
        <translation>Der Start von %who in deiner eigenen Szene wird nicht übernommen</translation>
    </message>
    <message>
        <source>A copy keeps the value of the moment when it was made: is it made before the start is set?</source>
        <translation>Eine Kopie behält den Wert des Augenblicks, in dem sie gemacht wurde: Wird sie gemacht, bevor der Start gesetzt ist?</translation>
    </message>
    <message>
        <source>In a corner one part of the velocity of %who turns round too late</source>
        <translation>In einer Ecke kehrt ein Anteil der Geschwindigkeit von %who zu spät um</translation>
    </message>
    <message>
        <source>Circle %1 came with %2 m/s and has %3 m/s after the step that brought it into the corner, with its rim %4 m beyond the %5. Both walls are hit in the same step, and each must turn its own part, whichever comes first.</source>
        <translation>Kreis %1 kam mit %2 m/s und hat %3 m/s nach dem Schritt, der ihn in die Ecke brachte, mit dem Rand %4 m hinter %5. Beide Wände werden im selben Schritt getroffen, und jede muss ihren eigenen Anteil umkehren, gleich welche zuerst kommt.</translation>
    </message>
    <message>
        <source>The hit changed the velocity of circle 1 by no more than %1 m/s and that of circle 2 by %2 m/s: look at what the push is multiplied by, and what it is divided by.</source>
        <translation>Der Stoß hat die Geschwindigkeit von Kreis 1 um nicht mehr als %1 m/s geändert und die von Kreis 2 um %2 m/s: Sieh nach, womit der Kraftstoß multipliziert wird und wodurch er geteilt wird.</translation>
    </message>
</context>
<context>
    <name>FormulaWords</name>
    <message>
        <source>times</source>
        <translation>mal</translation>
    </message>
    <message>
        <source>is at most</source>
        <translation>ist höchstens</translation>
    </message>
    <message>
        <source>is at least</source>
        <translation>ist mindestens</translation>
    </message>
    <message>
        <source>is not</source>
        <translation>ist nicht</translation>
    </message>
    <message>
        <source>is about</source>
        <translation>ist etwa</translation>
    </message>
    <message>
        <source>becomes</source>
        <translation>wird zu</translation>
    </message>
    <message>
        <source>plus or minus</source>
        <translation>plus oder minus</translation>
    </message>
    <message>
        <source>the sum of</source>
        <translation>die Summe von</translation>
    </message>
    <message>
        <source>infinity</source>
        <translation>unendlich</translation>
    </message>
    <message>
        <source>perpendicular</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>parallel</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>prime</source>
        <translation>Strich</translation>
    </message>
    <message>
        <source>equals</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>plus</source>
        <translation>plus</translation>
    </message>
    <message>
        <source>minus</source>
        <translation>minus</translation>
    </message>
    <message>
        <source>over</source>
        <translation>durch</translation>
    </message>
    <message>
        <source>is less than</source>
        <translation>ist kleiner als</translation>
    </message>
    <message>
        <source>is more than</source>
        <translation>ist größer als</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>Betragsstrich</translation>
    </message>
    <message>
        <source>sub %1</source>
        <translation>Index %1</translation>
    </message>
    <message>
        <source>squared</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>cubed</source>
        <translation>hoch drei</translation>
    </message>
    <message>
        <source>to the power of %1</source>
        <translation>hoch %1</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <comment>a fraction</comment>
        <translation>%1 durch %2</translation>
    </message>
    <message>
        <source>the square root of %1</source>
        <translation>Wurzel aus %1</translation>
    </message>
    <message>
        <source>vector %1</source>
        <translation>Vektor %1</translation>
    </message>
    <message>
        <source>unit vector %1</source>
        <translation>Einheitsvektor %1</translation>
    </message>
</context>
<context>
    <name>Ghost</name>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
</context>
<context>
    <name>GlPainter</name>
    <message>
        <source>No OpenGL context can be made here</source>
        <translation>Hier lässt sich kein OpenGL-Kontext anlegen</translation>
    </message>
    <message>
        <source>OpenGL 3.3 is needed, but %1 offers %2.%3</source>
        <translation>OpenGL 3.3 wird gebraucht, aber %1 bietet %2.%3</translation>
    </message>
    <message>
        <source>OpenGL 3.3 is needed</source>
        <translation>OpenGL 3.3 wird gebraucht</translation>
    </message>
    <message>
        <source>The shader %1 is missing</source>
        <translation>Der Shader %1 fehlt</translation>
    </message>
    <message>
        <source>The shader %1 does not compile: %2</source>
        <translation>Der Shader %1 lässt sich nicht übersetzen: %2</translation>
    </message>
    <message>
        <source>The shaders %1 do not link: %2</source>
        <translation>Die Shader %1 lassen sich nicht verbinden: %2</translation>
    </message>
    <message>
        <source>OpenGL has no memory for the scene</source>
        <translation>OpenGL hat keinen Speicher für die Szene</translation>
    </message>
</context>
<context>
    <name>Grading</name>
    <message>
        <source>%1 is a link, which is not followed</source>
        <translation>%1 ist ein Verweis, dem nicht gefolgt wird</translation>
    </message>
    <message>
        <source>%1 is neither a file nor a folder</source>
        <translation>%1 ist weder Datei noch Ordner</translation>
    </message>
    <message>
        <source>download of %1</source>
        <translation>Download von %1</translation>
    </message>
    <message>
        <source>Canvas says: late</source>
        <translation>Canvas sagt: verspätet</translation>
    </message>
    <message>
        <source>several attempts; the last one counts</source>
        <translation>mehrere Versuche; der letzte zählt</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>clone of GitHub Classroom</source>
        <translation>Klon von GitHub Classroom</translation>
    </message>
    <message>
        <source>%1 is no work of a student</source>
        <translation>%1 ist keine Arbeit von Studierenden</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>this is the work of one student; the folder that holds those of all is right</source>
        <translation>das ist die Arbeit einer einzelnen Person; richtig ist der Ordner, der die aller enthält</translation>
    </message>
    <message>
        <source>%1 handed in no file</source>
        <translation>%1 hat keine Datei abgegeben</translation>
    </message>
    <message>
        <source>the process that judges was killed %1 times without getting anything done</source>
        <translation>der Prozess, der urteilt, wurde %1-mal beendet, ohne etwas fertigzubringen</translation>
    </message>
    <message>
        <source>the process that judged it gave no verdict: %1</source>
        <translation>der Prozess, der darüber urteilte, kam zu keinem Urteil: %1</translation>
    </message>
    <message>
        <source>this is no manifest of results of format 1</source>
        <translation>das ist kein Verzeichnis von Ergebnissen im Format 1</translation>
    </message>
    <message>
        <source>another process is writing results there</source>
        <translation>ein anderer Prozess schreibt dort Ergebnisse</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1: there are no results; its shard never began</source>
        <translation>%1: Es gibt keine Ergebnisse; dieser Teil hat nie begonnen</translation>
    </message>
    <message>
        <source>%1: shard %2 of %3 did not come to its end</source>
        <translation>%1: Teil %2 von %3 kam nicht zu Ende</translation>
    </message>
    <message>
        <source>none of these folders has results</source>
        <translation>keiner dieser Ordner hat Ergebnisse</translation>
    </message>
    <message>
        <source>judged more than once, with the same result: %1</source>
        <translation>mehr als einmal beurteilt, mit gleichem Ergebnis: %1</translation>
    </message>
    <message>
        <source>missing of %1 shards: %2</source>
        <translation>von %1 Teilen fehlen: %2</translation>
    </message>
    <message>
        <source>without results: %1</source>
        <translation>ohne Ergebnisse: %1</translation>
    </message>
    <message>
        <source>these results are of another version of the lab, of Cradle or of the secret than those before; they cannot be put together</source>
        <translation>diese Ergebnisse gehören zu einer anderen Fassung des Labs, von Cradle oder des Geheimnisses als die davor; sie lassen sich nicht zusammenfügen</translation>
    </message>
    <message>
        <source>these results are of another class, or of another number of shards, than those before</source>
        <translation>diese Ergebnisse gehören zu einem anderen Kurs oder einer anderen Zahl von Teilen als die davor</translation>
    </message>
    <message>
        <source>%1: other isolation: %2</source>
        <translation>%1: andere Isolation: %2</translation>
    </message>
    <message>
        <source>%1 is not as its manifest says, and is left out</source>
        <translation>%1 ist nicht so, wie das Verzeichnis sagt, und bleibt weg</translation>
    </message>
    <message>
        <source>the results of %1 differ from those in %2</source>
        <translation>die Ergebnisse von %1 weichen von denen in %2 ab</translation>
    </message>
    <message>
        <source>handed in</source>
        <translation>abgegeben</translation>
    </message>
    <message>
        <source>handed in nothing</source>
        <translation>nichts abgegeben</translation>
    </message>
    <message>
        <source>pass every step</source>
        <translation>bestehen jeden Schritt</translation>
    </message>
    <message>
        <source>points on average</source>
        <translation>Punkte im Mittel</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>steps not graded</source>
        <translation>Schritte nicht bewertet</translation>
    </message>
    <message>
        <source>Not graded</source>
        <translation>Nicht bewertet</translation>
    </message>
    <message>
        <source>Here no verdict could be reached. These steps count neither as passed nor as failed, and the gradebooks leave the points of their students empty.</source>
        <translation>Hier kam kein Urteil zustande. Diese Schritte zählen weder als bestanden noch als nicht bestanden, und die Notenlisten lassen die Punkte dieser Studierenden leer.</translation>
    </message>
    <message>
        <source>Handed in nothing</source>
        <translation>Nichts abgegeben</translation>
    </message>
    <message>
        <source>How it was judged</source>
        <translation>Wie geurteilt wurde</translation>
    </message>
    <message>
        <source>By %1, with version %2 of the lab %3 (sha256 %4).</source>
        <translation>Von %1, mit Fassung %2 des Labs %3 (sha256 %4).</translation>
    </message>
    <message>
        <source>Programs were kept apart by: %1.</source>
        <translation>Die Programme waren abgeschottet durch: %1.</translation>
    </message>
    <message>
        <source>Each day late that has begun takes %1 % of the points, at most %2 %.</source>
        <translation>Jeder angefangene Tag Verspätung kostet %1 % der Punkte, höchstens %2 %.</translation>
    </message>
    <message>
        <source>Handing in late takes no points.</source>
        <translation>Verspätung kostet keine Punkte.</translation>
    </message>
    <message>
        <source>For the teacher alone: this page has names. What students read of themselves is in the folder students.</source>
        <translation>Nur für die Lehrenden: Auf dieser Seite stehen Namen. Was Studierende über sich selbst lesen, liegt im Ordner students.</translation>
    </message>
    <message>
        <source>How it starts</source>
        <translation>Der Anfang</translation>
    </message>
    <message>
        <source>Free motion</source>
        <translation>Freie Bewegung</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>When two touch</source>
        <translation>Wann zwei sich berühren</translation>
    </message>
    <message>
        <source>What a hit does</source>
        <translation>Was ein Stoß bewirkt</translation>
    </message>
    <message>
        <source>In the long run</source>
        <translation>Auf die Dauer</translation>
    </message>
    <message>
        <source>Students with a finding</source>
        <translation>Studierende mit Befund</translation>
    </message>
    <message>
        <source>The program stops</source>
        <translation>Das Programm bricht ab</translation>
    </message>
    <message>
        <source>an example</source>
        <translation>ein Beispiel</translation>
    </message>
    <message>
        <source>%1 of %2 do not pass</source>
        <translation>%1 von %2 bestehen nicht</translation>
    </message>
    <message>
        <source>Where the class stands</source>
        <translation>Wo der Kurs steht</translation>
    </message>
    <message>
        <source>How many pass each step</source>
        <translation>Wie viele jeden Schritt bestehen</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>bestehen</translation>
    </message>
    <message>
        <source>do not pass yet</source>
        <translation>bestehen noch nicht</translation>
    </message>
    <message>
        <source>not graded</source>
        <translation>nicht bewertet</translation>
    </message>
    <message>
        <source>not handed in</source>
        <translation>nicht abgegeben</translation>
    </message>
    <message>
        <source>What the class misunderstood</source>
        <translation>Was der Kurs missverstanden hat</translation>
    </message>
    <message>
        <source>Nothing was found.</source>
        <translation>Es wurde nichts gefunden.</translation>
    </message>
    <message>
        <source>How many students have a finding of that sort in that step; the stronger the colour, the larger their part of those who were judged. The examples are of one student each, without names and comments.</source>
        <translation>Wie viele Studierende in dem Schritt einen Befund dieser Art haben; je kräftiger die Farbe, desto größer ihr Anteil an allen Beurteilten. Die Beispiele stammen von je einer Person, ohne Namen und Kommentare.</translation>
    </message>
    <message>
        <source>Checks that tell nobody apart</source>
        <translation>Prüfungen, die niemanden unterscheiden</translation>
    </message>
    <message>
        <source>In brackets: how many were judged by it.</source>
        <translation>In Klammern: wie viele danach beurteilt wurden.</translation>
    </message>
    <message>
        <source>Nobody passes</source>
        <translation>Niemand besteht</translation>
    </message>
    <message>
        <source>Everybody passes</source>
        <translation>Alle bestehen</translation>
    </message>
    <message>
        <source>Checks and time on the way</source>
        <translation>Prüfungen und Zeit unterwegs</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Students</source>
        <translation>Studierende</translation>
    </message>
    <message>
        <source>Checks, median</source>
        <translation>Prüfungen, Median</translation>
    </message>
    <message>
        <source>Checks, most</source>
        <translation>Prüfungen, höchstens</translation>
    </message>
    <message>
        <source>Minutes, median</source>
        <translation>Minuten, Median</translation>
    </message>
    <message>
        <source>Programs that are alike</source>
        <translation>Programme, die sich gleichen</translation>
    </message>
    <message>
        <source>There are none.</source>
        <translation>Es gibt keine.</translation>
    </message>
    <message>
        <source>share %1 % of what the one with less has of their own</source>
        <translation>haben %1 % dessen gemeinsam, was auf der Seite mit weniger Eigenem steht</translation>
    </message>
    <message>
        <source>Who is where</source>
        <translation>Wer wo steht</translation>
    </message>
    <message>
        <source>✓ passes, ○ does not pass yet, · not handed in, ? not graded</source>
        <translation>✓ besteht, ○ besteht noch nicht, · nicht abgegeben, ? nicht bewertet</translation>
    </message>
    <message>
        <source>Student</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>this is the result of &quot;%1&quot;, whose file has another name</source>
        <translation>das ist das Ergebnis von „%1“, dessen Datei anders heißt</translation>
    </message>
    <message>
        <source>%1 is not in the roster</source>
        <translation>%1 steht nicht auf der Liste</translation>
    </message>
    <message>
        <source>there are more than %1 files in it</source>
        <translation>es sind mehr als %1 Dateien darin</translation>
    </message>
    <message>
        <source>a broken entry</source>
        <translation>ein kaputter Eintrag</translation>
    </message>
    <message>
        <source>it holds absurdly much</source>
        <translation>es enthält unsinnig viel</translation>
    </message>
    <message>
        <source>this is no zip: %1</source>
        <translation>das ist kein Zip: %1</translation>
    </message>
    <message>
        <source>%1 of %2 steps pass</source>
        <translation>%1 von %2 Schritten bestehen</translation>
    </message>
    <message>
        <source>Nothing was handed in</source>
        <translation>Es wurde nichts abgegeben</translation>
    </message>
    <message>
        <source>%1 was passed over for %2</source>
        <translation>%1 wurde zugunsten von %2 übergangen</translation>
    </message>
    <message>
        <source>nothing that was handed in is a program</source>
        <translation>nichts von dem, was abgegeben wurde, ist ein Programm</translation>
    </message>
    <message>
        <source>an object is right here</source>
        <translation>hier ist ein Objekt richtig</translation>
    </message>
    <message>
        <source>%1 is right here</source>
        <translation>hier ist %1 richtig</translation>
    </message>
    <message>
        <source>a text of at most %1 letters</source>
        <translation>ein Text von höchstens %1 Zeichen</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>eine ganze Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a list of at most %1</source>
        <translation>eine Liste von höchstens %1</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>judging took more than %1 s of processor time</source>
        <translation>das Urteilen brauchte mehr als %1 s Rechenzeit</translation>
    </message>
    <message>
        <source>not judged: the program cannot be read</source>
        <translation>nicht beurteilt: Das Programm kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the lab has no step %1</source>
        <translation>das Lab hat keinen Schritt %1</translation>
    </message>
    <message>
        <source>the file that was handed in cannot be read: %1</source>
        <translation>die abgegebene Datei kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>no %1</source>
        <translation>ohne %1</translation>
    </message>
    <message>
        <source>The program around line %1</source>
        <translation>Das Programm um Zeile %1</translation>
    </message>
    <message>
        <source>this is no folder</source>
        <translation>das ist kein Ordner</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>this is a link that leads elsewhere; it is not followed</source>
        <translation>das ist ein Verweis, der woandershin führt; ihm wird nicht gefolgt</translation>
    </message>
    <message>
        <source>this is no plain file</source>
        <translation>das ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>this is no roster: its first line has neither a column &quot;id&quot; nor a column &quot;folder&quot;</source>
        <translation>das ist keine Liste: Ihre erste Zeile hat weder eine Spalte „id“ noch eine Spalte „folder“</translation>
    </message>
    <message>
        <source>row %1 names nobody: it has neither an id nor a folder</source>
        <translation>Zeile %1 nennt niemanden: Sie hat weder Kennung noch Ordner</translation>
    </message>
    <message>
        <source>row %1: late days are a number from 0</source>
        <translation>Zeile %1: Tage der Verspätung sind eine Zahl ab 0</translation>
    </message>
    <message>
        <source>Judged by %1, version %2 of the lab, in scenes drawn for this student alone.</source>
        <translation>Beurteilt von %1, Fassung %2 des Labs, in Szenen, die nur für diese Person gezogen wurden.</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 von %2 Punkten</translation>
    </message>
    <message>
        <source>✓ passes</source>
        <translation>✓ besteht</translation>
    </message>
    <message>
        <source>– not handed in</source>
        <translation>– nicht abgegeben</translation>
    </message>
    <message>
        <source>? not graded</source>
        <translation>? nicht bewertet</translation>
    </message>
    <message>
        <source>! stops with an error</source>
        <translation>! bricht mit Fehler ab</translation>
    </message>
    <message>
        <source>○ does not pass yet</source>
        <translation>○ besteht noch nicht</translation>
    </message>
    <message>
        <source>! cannot be read</source>
        <translation>! nicht lesbar</translation>
    </message>
    <message>
        <source>– of %1</source>
        <translation>– von %1</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Nothing was handed in for this step.</source>
        <translation>Für diesen Schritt wurde nichts abgegeben.</translation>
    </message>
    <message>
        <source>There is no verdict: this step counts neither as passed nor as failed.</source>
        <translation>Es gibt kein Urteil: Dieser Schritt zählt weder als bestanden noch als nicht bestanden.</translation>
    </message>
    <message numerus="yes">
        <source>Checked %n time(s) while working on it.</source>
        <translation>
            <numerusform>Beim Arbeiten daran %n-mal geprüft.</numerusform>
            <numerusform>Beim Arbeiten daran %n-mal geprüft.</numerusform>
        </translation>
    </message>
    <message>
        <source>The program stopped in step %1 of a scene, at %2 s.</source>
        <translation>Das Programm brach in Zeitschritt %1 einer Szene ab, bei %2 s.</translation>
    </message>
    <message>
        <source>The program does not load.</source>
        <translation>Das Programm lässt sich nicht laden.</translation>
    </message>
    <message>
        <source>The program stopped before its first step.</source>
        <translation>Das Programm brach vor seinem ersten Zeitschritt ab.</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>There:</source>
        <translation>Dort:</translation>
    </message>
    <message>
        <source>Look at line %1 of your program.</source>
        <translation>Sieh dir Zeile %1 deines Programms an.</translation>
    </message>
    <message>
        <source>It is reached by the calls in line %1.</source>
        <translation>Dorthin führen die Aufrufe in Zeile %1.</translation>
    </message>
    <message>
        <source>“%1” first goes wrong here, at %2 s.</source>
        <translation>„%1“ geht zuerst hier schief, bei %2 s.</translation>
    </message>
    <message>
        <source>“%1” goes wrong from the start.</source>
        <translation>„%1“ geht von Anfang an schief.</translation>
    </message>
    <message>
        <source>Scene: %1.</source>
        <translation>Szene: %1.</translation>
    </message>
    <message>
        <source>The checks of this step</source>
        <translation>Die Prüfungen dieses Schritts</translation>
    </message>
    <message>
        <source>did not pass</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>there is no such aspect</source>
        <translation>diesen Aspekt gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such kind of error</source>
        <translation>diese Art Fehler gibt es nicht</translation>
    </message>
    <message>
        <source>a colour like #1e90ff is right</source>
        <translation>eine Farbe wie #1e90ff ist richtig</translation>
    </message>
    <message>
        <source>there is no such status</source>
        <translation>diesen Status gibt es nicht</translation>
    </message>
    <message>
        <source>the status and the report say different things</source>
        <translation>Status und Bericht sagen Verschiedenes</translation>
    </message>
    <message>
        <source>the result is too large</source>
        <translation>das Ergebnis ist zu groß</translation>
    </message>
    <message>
        <source>this is no result of a student: %1</source>
        <translation>das ist kein Ergebnis einer Person: %1</translation>
    </message>
    <message>
        <source>not a JSON object</source>
        <translation>kein JSON-Objekt</translation>
    </message>
    <message>
        <source>this is no secret: at least %1 letters are right</source>
        <translation>das ist kein Geheimnis: Richtig sind mindestens %1 Zeichen</translation>
    </message>
    <message>
        <source>no process to judge in can be started: %1</source>
        <translation>es lässt sich kein Prozess zum Urteilen starten: %1</translation>
    </message>
    <message>
        <source>it has sent too much</source>
        <translation>er hat zu viel gesendet</translation>
    </message>
    <message>
        <source>it has sent what it was not asked for</source>
        <translation>er hat gesendet, wonach nicht gefragt war</translation>
    </message>
    <message>
        <source>it tried what no judgement needs, and was stopped</source>
        <translation>er versuchte, was kein Urteil braucht, und wurde gestoppt</translation>
    </message>
    <message>
        <source>it was ended by signal %1</source>
        <translation>er wurde durch Signal %1 beendet</translation>
    </message>
    <message>
        <source>it broke down</source>
        <translation>er brach zusammen</translation>
    </message>
    <message>
        <source>And %1 more.</source>
        <translation>Und %1 weitere.</translation>
    </message>
    <message>
        <source>%1 not graded</source>
        <translation>%1 nicht bewertet</translation>
    </message>
    <message>
        <source>Steps that could not be graded: %1. There is no sum of points yet; that is not the fault of what was handed in.</source>
        <translation>Schritte, die nicht bewertet werden konnten: %1. Daher gibt es noch keine Punktsumme; an der Abgabe liegt das nicht.</translation>
    </message>
    <message>
        <source>Days late, a begun one counted whole: %1. That takes %2 % of the points; the sum above has them taken off already.</source>
        <translation>Tage Verspätung, angefangene ganz gezählt: %1. Das kostet %2 % der Punkte; in der Summe oben sind sie schon abgezogen.</translation>
    </message>
    <message>
        <source>Compared token by token, whatever their names, comments and order (winnowing). What the lab gives is left out, and so is what more than %1 students share. There are many good reasons for programs to be alike: working together where that is allowed, the same book, the same idea. A pair below proves nothing; read both, and ask.</source>
        <translation>Verglichen wird Token für Token, gleich welche Namen, Kommentare und Reihenfolge (Winnowing). Was das Lab vorgibt, zählt nicht, und auch nicht, was mehr als %1 Studierende gemeinsam haben. Es gibt viele gute Gründe dafür, dass Programme sich gleichen: erlaubte Zusammenarbeit, dasselbe Buch, dieselbe Idee. Ein Paar hier beweist nichts; lies beide, und frag nach.</translation>
    </message>
    <message>
        <source>A step is worth what the lab says, else the points of its checks; a check that passes brings its points also where others fail. Points are rounded to the hundredth, halves up, once, after all else.</source>
        <translation>Ein Schritt ist so viel wert, wie das Lab sagt, sonst so viel wie seine Prüfungen; eine bestandene Prüfung bringt ihre Punkte auch dann, wenn andere nicht bestanden sind. Punkte werden auf Hundertstel gerundet, Hälften nach oben, einmal, ganz am Schluss.</translation>
    </message>
    <message>
        <source>Of those who handed in a history, as it says itself. Minutes are those in which the program changed, without pauses of more than ten; who thinks on paper shows none. A history of commits alone tells no checks.</source>
        <translation>Von denen, die einen Verlauf abgegeben haben, wie er es selbst sagt. Minuten sind die, in denen sich das Programm änderte, ohne Pausen von mehr als zehn; wer auf Papier denkt, zeigt keine. Ein Verlauf nur aus Commits sagt nichts von Prüfungen.</translation>
    </message>
    <message>
        <source>the history is too large to be looked at</source>
        <translation>der Verlauf ist zu groß, um angesehen zu werden</translation>
    </message>
    <message>
        <source>what judging found cannot be kept: %1</source>
        <translation>was beim Urteilen gefunden wurde, lässt sich nicht aufbewahren: %1</translation>
    </message>
    <message>
        <source>%1: the roster has %2, what was handed in has %3; judged with the values of %2.</source>
        <translation>%1: auf der Liste steht %2, im Abgegebenen steht %3; geurteilt wurde mit den Werten zu %2.</translation>
    </message>
    <message>
        <source>%1 stands in what several handed in: %2.</source>
        <translation>%1 steht in dem, was mehrere abgegeben haben: %2.</translation>
    </message>
    <message>
        <source>Numbers that are not clear</source>
        <translation>Nummern, die nicht eindeutig sind</translation>
    </message>
    <message>
        <source>This lab draws values by a student&apos;s number: that of the roster, where it has one, else that of what was handed in. A mistyped number is likelier than anything else.</source>
        <translation>Dieses Lab lost Werte nach der Nummer aus: nach der auf der Liste, wo dort eine steht, sonst nach der im Abgegebenen. Wahrscheinlicher als alles andere ist eine vertippte Nummer.</translation>
    </message>
    <message>
        <source>and %1 more of that sort</source>
        <translation>und %1 weitere dieser Art</translation>
    </message>
    <message>
        <source>%1 is not looked into; unpack it in its place</source>
        <translation>in %1 wird nicht hineingesehen; entpacke die Datei an ihrem Ort</translation>
    </message>
    <message>
        <source>What was handed in has the number %2, which the roster does not have for this student: it was judged with the values that are drawn by the number %1.</source>
        <translation>Im Abgegebenen steht die Nummer %2, die laut Liste nicht zu dieser Person gehört: Geurteilt wurde mit den Werten, die zur Nummer %1 ausgelost sind.</translation>
    </message>
    <message>
        <source>The values of this lab were drawn by the number %1.</source>
        <translation>Die Werte dieses Labs wurden nach der Nummer %1 ausgelost.</translation>
    </message>
    <message>
        <source>the roster has %1 more than once</source>
        <translation>%1 steht mehr als einmal auf der Liste</translation>
    </message>
    <message>
        <source>of the names of Blackboard, what follows the last _ is taken for the account; a roster tells better</source>
        <translation>in den Namen von Blackboard gilt als Konto, was auf das letzte _ folgt; eine Liste des Kurses weiß es besser</translation>
    </message>
    <message>
        <source>of the names of Blackboard, what follows %1 is taken for the account; a roster tells better</source>
        <translation>in den Namen von Blackboard gilt als Konto, was auf %1 folgt; eine Liste des Kurses weiß es besser</translation>
    </message>
    <message>
        <source>%1: too large to be unpacked</source>
        <translation>%1: zu groß, um ausgepackt zu werden</translation>
    </message>
    <message>
        <source>%1: left out %2</source>
        <translation>%1: weggelassen: %2</translation>
    </message>
    <message>
        <source>names that are in it more than once</source>
        <translation>Namen, die mehr als einmal darin sind</translation>
    </message>
    <message>
        <source>this is the zip of a whole class; grade the zip itself</source>
        <translation>das ist das Zip eines ganzen Kurses; bewerte das Zip selbst</translation>
    </message>
    <message>
        <source>cannot be unpacked: %1</source>
        <translation>kann nicht ausgepackt werden: %1</translation>
    </message>
</context>
<context>
    <name>HandIn</name>
    <message>
        <source>the work cannot be put there</source>
        <translation>die Arbeit lässt sich dort nicht ablegen</translation>
    </message>
    <message>
        <source>this is no folder with a student&apos;s work</source>
        <translation>das ist kein Ordner mit der Arbeit einer Studentin oder eines Studenten</translation>
    </message>
    <message>
        <source>this is no work that was handed in: there is no manifest.json of format 1 in it</source>
        <translation>das ist keine abgegebene Arbeit: Es ist kein manifest.json vom Format 1 darin</translation>
    </message>
    <message>
        <source>this file is not in the manifest</source>
        <translation>diese Datei steht nicht im Manifest</translation>
    </message>
    <message>
        <source>this file was changed after it was handed in</source>
        <translation>diese Datei wurde nach der Abgabe geändert</translation>
    </message>
    <message>
        <source>this file is missing</source>
        <translation>diese Datei fehlt</translation>
    </message>
</context>
<context>
    <name>HandleDrag</name>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Change velocity of %1</source>
        <translation>Geschwindigkeit von %1 ändern</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message numerus="yes">
        <source>Move %n circles</source>
        <translation>
            <numerusform>%n Kreis verschieben</numerusform>
            <numerusform>%n Kreise verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 m/s, speed %2 m/s</source>
        <translation>%1 m/s, Tempo %2 m/s</translation>
    </message>
    <message>
        <source>moved by %1 m</source>
        <translation>um %1 m verschoben</translation>
    </message>
    <message numerus="yes">
        <source>Change velocities of %n circles</source>
        <translation>
            <numerusform>Geschwindigkeit von %n Kreis ändern</numerusform>
            <numerusform>Geschwindigkeiten von %n Kreisen ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>changed by %1 m/s</source>
        <translation>um %1 m/s geändert</translation>
    </message>
</context>
<context>
    <name>HitNote</name>
    <message>
        <source>%1: %2</source>
        <comment>title, rows</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
    <message>
        <source>change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>%1 before %2, after %3, change %4 %5</source>
        <comment>who, three numbers, unit</comment>
        <translation>%1 vorher %2, nachher %3, Änderung %4 %5</translation>
    </message>
    <message>
        <source>Hit %1 · %2 s</source>
        <translation>Stoß %1 · %2 s</translation>
    </message>
    <message>
        <source> · first of %1</source>
        <translation> · erster von %1</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
</context>
<context>
    <name>HitParts</name>
    <message>
        <source>before %1</source>
        <translation>davor %1</translation>
    </message>
    <message>
        <source>along %1</source>
        <translation>längs %1</translation>
    </message>
    <message>
        <source>across %1</source>
        <translation>quer %1</translation>
    </message>
    <message>
        <source>n</source>
        <comment>the normal vector</comment>
        <translation>n</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>danach %1</translation>
    </message>
</context>
<context>
    <name>LabArchive</name>
    <message>
        <source>the lab cannot be put there</source>
        <translation>das Lab lässt sich dort nicht ablegen</translation>
    </message>
    <message>
        <source>the lab cannot be packed: %1</source>
        <translation>das Lab lässt sich nicht packen: %1</translation>
    </message>
    <message>
        <source>there is no lab.json</source>
        <translation>es gibt keine lab.json</translation>
    </message>
    <message>
        <source>there are %1 files in it; at most %2 are right</source>
        <translation>darin sind %1 Dateien; richtig sind höchstens %2</translation>
    </message>
    <message>
        <source>the name is not in UTF-8, which would be right</source>
        <translation>der Name ist nicht in UTF-8, was richtig wäre</translation>
    </message>
    <message>
        <source>this is a link or a special file; a plain file is right</source>
        <translation>das ist eine Verknüpfung oder besondere Datei; richtig ist eine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>this is encrypted; a file without a password is right</source>
        <translation>das ist verschlüsselt; richtig ist eine Datei ohne Passwort</translation>
    </message>
    <message>
        <source>the file is too large; at most %1 are right</source>
        <translation>die Datei ist zu groß; richtig sind höchstens %1</translation>
    </message>
    <message>
        <source>the name is there twice (but for capital letters); a name of its own is right</source>
        <translation>den Namen gibt es (bis auf Großbuchstaben) zweimal; richtig ist ein eigener Name</translation>
    </message>
    <message>
        <source>this unpacks to another size than it says</source>
        <translation>das entpackt sich auf eine andere Größe, als es angibt</translation>
    </message>
    <message>
        <source>this is broken or packed in an unknown way</source>
        <translation>das ist beschädigt oder auf unbekannte Art gepackt</translation>
    </message>
    <message>
        <source>this unpacks to more than %1 times its size, as no honest file does</source>
        <translation>das wird beim Entpacken mehr als %1-mal so groß, wie es bei keiner ehrlichen Datei ist</translation>
    </message>
    <message>
        <source>all of it is too large; at most %1 are right</source>
        <translation>alles zusammen ist zu groß; richtig sind höchstens %1</translation>
    </message>
    <message>
        <source>there is no %1 in it</source>
        <translation>es ist kein %1 darin</translation>
    </message>
    <message>
        <source>this is no archive: %1</source>
        <translation>das ist kein Archiv: %1</translation>
    </message>
</context>
<context>
    <name>LabEdits</name>
    <message>
        <source>&quot;%1&quot; cannot be the name of a step; letters, digits, dashes and underscores are right</source>
        <translation>„%1“ kann nicht der Name eines Schritts sein; richtig sind Buchstaben, Ziffern, Binde- und Unterstriche</translation>
    </message>
    <message>
        <source>the lab has a folder %1 already</source>
        <translation>das Lab hat schon einen Ordner %1</translation>
    </message>
    <message>
        <source>the lab has no step in the folder %1</source>
        <translation>das Lab hat im Ordner %1 keinen Schritt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be the name of a program; letters, digits, dots, dashes and underscores are right</source>
        <translation>„%1“ kann nicht der Name eines Programms sein; richtig sind Buchstaben, Ziffern, Punkte, Binde- und Unterstriche</translation>
    </message>
    <message>
        <source>the step has a program of this name already</source>
        <translation>der Schritt hat schon ein Programm dieses Namens</translation>
    </message>
    <message>
        <source>there is no such program</source>
        <translation>dieses Programm gibt es nicht</translation>
    </message>
    <message>
        <source>cannot be read: there is no such file</source>
        <translation>nicht lesbar: Diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>the lab has translations into this language; its own texts are in another</source>
        <translation>das Lab hat Übersetzungen in diese Sprache; seine eigenen Texte sind in einer anderen</translation>
    </message>
</context>
<context>
    <name>LabFiles</name>
    <message>
        <source>this is a link that leads to no file of the lab; a file of its own is right</source>
        <translation>das ist eine Verknüpfung, die zu keiner Datei des Labs führt; richtig ist eine eigene Datei</translation>
    </message>
    <message>
        <source>this is a folder; a file is right</source>
        <translation>das ist ein Ordner; richtig ist eine Datei</translation>
    </message>
    <message>
        <source>folders are nested too deeply; at most %1 are right</source>
        <translation>die Ordner sind zu tief verschachtelt; richtig sind höchstens %1</translation>
    </message>
    <message>
        <source>this is neither a file nor a folder</source>
        <translation>das ist weder eine Datei noch ein Ordner</translation>
    </message>
    <message>
        <source>the file is too large; at most %1 are right</source>
        <translation>die Datei ist zu groß; richtig sind höchstens %1</translation>
    </message>
    <message>
        <source>the lab is too large from here on; at most %1 files and %2 are right</source>
        <translation>das Lab ist ab hier zu groß; richtig sind höchstens %1 Dateien und %2</translation>
    </message>
    <message>
        <source>a path that stays in the lab is right, of names that do not begin with a dot</source>
        <translation>richtig ist ein Pfad, der im Lab bleibt, aus Namen, die nicht mit einem Punkt beginnen</translation>
    </message>
    <message>
        <source>the name is too long; at most %1 characters are right</source>
        <translation>der Name ist zu lang; richtig sind höchstens %1 Zeichen</translation>
    </message>
    <message>
        <source>a name without \ : * ? &quot; &lt; &gt; | and without control characters is right</source>
        <translation>richtig ist ein Name ohne \ : * ? &quot; &lt; &gt; | und ohne Steuerzeichen</translation>
    </message>
    <message>
        <source>%1 names a device on some systems; another name is right</source>
        <translation>%1 bezeichnet auf manchen Systemen ein Gerät; richtig ist ein anderer Name</translation>
    </message>
    <message>
        <source>a name that ends with a letter or a digit is right</source>
        <translation>richtig ist ein Name, der mit einem Buchstaben oder einer Ziffer endet</translation>
    </message>
    <message>
        <source>cannot be read: there is no such folder</source>
        <translation>nicht lesbar: Diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>cannot be read: the folder may not be opened</source>
        <translation>nicht lesbar: Der Ordner darf nicht geöffnet werden</translation>
    </message>
    <message>
        <source>cannot be read: there is no such file</source>
        <translation>nicht lesbar: Diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>a link here leads out of the lab; a file or folder of its own is right</source>
        <translation>eine Verknüpfung führt hier aus dem Lab hinaus; richtig ist eine eigene Datei oder ein eigener Ordner</translation>
    </message>
    <message>
        <source>another file has this name but for capital letters; a name of its own is right</source>
        <translation>eine andere Datei heißt bis auf Großbuchstaben ebenso; richtig ist ein eigener Name</translation>
    </message>
    <message>
        <source>another program changed %1 since the lab was read</source>
        <translation>ein anderes Programm hat %1 geändert, seit das Lab gelesen wurde</translation>
    </message>
    <message>
        <source>the picture has %1 × %2 pixels; at most %3 million are right</source>
        <translation>das Bild hat %1 × %2 Pixel; richtig sind höchstens %3 Millionen</translation>
    </message>
</context>
<context>
    <name>LabMenu</name>
    <message>
        <source>&amp;Labs</source>
        <translation>&amp;Labs</translation>
    </message>
</context>
<context>
    <name>LabReader</name>
    <message>
        <source>another step has the id %1 already; an id of its own is right</source>
        <translation>ein anderer Schritt hat schon die Kennung %1; richtig ist eine eigene Kennung</translation>
    </message>
    <message>
        <source>the text is not in UTF-8, which would be right; some letters are lost</source>
        <translation>der Text ist nicht in UTF-8, was richtig wäre; einige Buchstaben gehen verloren</translation>
    </message>
    <message>
        <source>the program begins without a comment; what the student should read of it stands there</source>
        <translation>das Programm beginnt ohne Kommentar; dort steht, was die Lernenden dazu lesen sollen</translation>
    </message>
    <message>
        <source>the step %1 is listed already; each step once is right</source>
        <translation>der Schritt %1 steht schon in der Liste; richtig ist jeder Schritt einmal</translation>
    </message>
    <message>
        <source>the file is too large; at most %1 are right</source>
        <translation>die Datei ist zu groß; richtig sind höchstens %1</translation>
    </message>
    <message>
        <source>cannot be read: there is no such file</source>
        <translation>nicht lesbar: Diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>the text has characters that are none (NUL); a text in UTF-8 is right</source>
        <translation>der Text hat Zeichen, die keine sind (NUL); richtig ist ein Text in UTF-8</translation>
    </message>
    <message>
        <source>a number from 1 to %1, for there are so many answers, is right</source>
        <translation>eine Zahl von 1 bis %1 ist richtig, denn so viele Antworten gibt es</translation>
    </message>
    <message>
        <source>%1 answers, as many as the task.json has, are right, not %2; the question is shown untranslated</source>
        <translation>Richtig sind %1 Antworten, so viele, wie task.json hat, nicht %2; die Frage wird unübersetzt gezeigt</translation>
    </message>
    <message>
        <source>still the text of the template: %1</source>
        <translation>noch der Text der Vorlage: %1</translation>
    </message>
    <message>
        <source>not in this language yet: %1</source>
        <translation>noch nicht in dieser Sprache: %1</translation>
    </message>
    <message>
        <source>the program is there whole, too; one of the two files is right</source>
        <translation>das Programm ist auch ganz da; richtig ist eine der beiden Dateien</translation>
    </message>
    <message>
        <source>a name of letters, digits and underscores that means nothing else is right</source>
        <translation>richtig ist ein Name aus Buchstaben, Ziffern und Unterstrichen, der nichts anderes bedeutet</translation>
    </message>
    <message>
        <source>a range from the least to the most, with a step that is greater than 0, is right</source>
        <translation>richtig ist ein Bereich vom Kleinsten zum Größten mit einer Schrittweite größer als 0</translation>
    </message>
    <message>
        <source>of what the step has not: %1</source>
        <translation>von etwas, das der Schritt nicht hat: %1</translation>
    </message>
    <message>
        <source>not in this language yet: the starter&apos;s comments</source>
        <translation>noch nicht in dieser Sprache: die Kommentare des Startprogramms</translation>
    </message>
    <message>
        <source>its code is not that of starter.lua; a starter in another language differs in comments alone</source>
        <translation>sein Code ist nicht der von starter.lua; ein Startprogramm in einer anderen Sprache unterscheidet sich nur in den Kommentaren</translation>
    </message>
    <message>
        <source>there is no picture %1 in the step&apos;s folder</source>
        <translation>im Ordner des Schritts gibt es kein Bild %1</translation>
    </message>
    <message>
        <source>&lt;!-- %1 --&gt; begins no part; explore, code and all do</source>
        <translation>&lt;!-- %1 --&gt; beginnt keinen Teil; explore, code und all tun es</translation>
    </message>
</context>
<context>
    <name>LabReport</name>
    <message>
        <source>You have written a physics engine</source>
        <translation>Du hast eine Physik-Engine geschrieben</translation>
    </message>
    <message>
        <source>%1 of %2 steps pass, judged anew a moment ago.</source>
        <translation>%1 von %2 Schritten bestehen, eben neu geprüft.</translation>
    </message>
    <message>
        <source>What took the most checks</source>
        <translation>Was die meisten Prüfungen brauchte</translation>
    </message>
    <message>
        <source>The energy of all runs</source>
        <translation>Die Energie aller Läufe</translation>
    </message>
    <message>
        <source>At %1 s, when two circles first meet</source>
        <translation>Bei %1 s, wenn sich zwei Kreise zum ersten Mal treffen</translation>
    </message>
    <message>
        <source>At %1 s, when a circle first reaches a wall</source>
        <translation>Bei %1 s, wenn ein Kreis zum ersten Mal eine Wand erreicht</translation>
    </message>
    <message>
        <source>At %1 s</source>
        <translation>Bei %1 s</translation>
    </message>
    <message>
        <source>not sure</source>
        <translation>nicht sicher</translation>
    </message>
    <message>
        <source>%1 of %2 steps pass. Every step was judged anew for this report, by version %3 of the lab.</source>
        <translation>%1 von %2 Schritten bestehen. Jeder Schritt wurde für diesen Bericht neu geprüft, mit Fassung %3 des Labs.</translation>
    </message>
    <message>
        <source>To the teacher</source>
        <translation>An die Lehrkraft</translation>
    </message>
    <message>
        <source>✓ passes</source>
        <translation>✓ besteht</translation>
    </message>
    <message>
        <source>does not pass yet</source>
        <translation>besteht noch nicht</translation>
    </message>
    <message>
        <source>stops with an error</source>
        <translation>bricht mit einem Fehler ab</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>nicht gemacht</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Found on the way</source>
        <translation>Unterwegs gefunden</translation>
    </message>
    <message>
        <source>Expected and found</source>
        <translation>Erwartet und gefunden</translation>
    </message>
    <message>
        <source>Expected: %1</source>
        <translation>Erwartet: %1</translation>
    </message>
    <message>
        <source>What happens: %1</source>
        <translation>Was geschieht: %1</translation>
    </message>
    <message>
        <source>The run</source>
        <translation>Der Lauf</translation>
    </message>
    <message>
        <source>What changed in the program</source>
        <translation>Was sich am Programm geändert hat</translation>
    </message>
    <message>
        <source>Nothing: it is the program of the step before.</source>
        <translation>Nichts: Es ist das Programm des vorigen Schritts.</translation>
    </message>
    <message>
        <source>Looking back</source>
        <translation>Rückblick</translation>
    </message>
    <message>
        <source>The energy of the runs above in one chart, each as a part of what it started with. A law that keeps energy draws a straight line at 1; what lies above was made by the program, what lies below was lost.</source>
        <translation>Die Energie aller Läufe von oben in einem Diagramm, jeweils als Teil dessen, womit sie begann. Ein Gesetz, das die Energie erhält, zeichnet eine gerade Linie bei 1; was darüber liegt, hat das Programm erzeugt, was darunter liegt, ging verloren.</translation>
    </message>
    <message>
        <source>The scene at %1 s</source>
        <translation>Die Szene bei %1 s</translation>
    </message>
    <message>
        <source>Momentum of all circles, kg m/s</source>
        <translation>Impuls aller Kreise, kg m/s</translation>
    </message>
    <message>
        <source>Energy of all circles, J</source>
        <translation>Energie aller Kreise, J</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>kinetisch</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>potentiell</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>Energy as a part of that at the start</source>
        <translation>Energie als Teil derer am Anfang</translation>
    </message>
    <message>
        <source>Checks: %1</source>
        <translation>Prüfungen: %1</translation>
    </message>
    <message>
        <source>… and more, which no page holds.</source>
        <translation>… und mehr, was auf keine Seite passt.</translation>
    </message>
</context>
<context>
    <name>LabSearch</name>
    <message>
        <source>this file is broken, so nothing can be replaced in it, and nothing was replaced elsewhere; mend it first</source>
        <translation>diese Datei ist beschädigt, darum kann in ihr nichts ersetzt werden, und auch sonst wurde nichts ersetzt; bring sie erst in Ordnung</translation>
    </message>
</context>
<context>
    <name>LabVerifier</name>
    <message>
        <source>stops with an error at line %1: %2</source>
        <translation>bricht mit einem Fehler in Zeile %1 ab: %2</translation>
    </message>
    <message>
        <source>passes; a starter should fail by a check</source>
        <translation>besteht; ein Startprogramm soll an einer Prüfung scheitern</translation>
    </message>
    <message>
        <source>fails with seed %1 by %2</source>
        <translation>scheitert mit dem Startwert %1 an %2</translation>
    </message>
    <message>
        <source>passes; a mistake should fail by a check</source>
        <translation>besteht; ein Fehler soll an einer Prüfung scheitern</translation>
    </message>
    <message>
        <source>is not recognised</source>
        <translation>wird nicht erkannt</translation>
    </message>
    <message>
        <source>is taken for %1</source>
        <translation>wird für %1 gehalten</translation>
    </message>
    <message>
        <source>fails by %1; work that gets a remark passes</source>
        <translation>scheitert an %1; was eine Anmerkung bekommt, besteht</translation>
    </message>
    <message>
        <source>there is no solution.lua</source>
        <translation>es gibt kein solution.lua</translation>
    </message>
    <message>
        <source>no mistake fails the check %1</source>
        <translation>kein Fehler scheitert an der Prüfung %1</translation>
    </message>
    <message>
        <source>the check %1 allows %2, and the solution itself is off by %3 (%4): other right programs may fail; at least %5 is right</source>
        <translation>die Prüfung %1 erlaubt %2, und die Lösung selbst weicht um %3 ab (%4): Andere richtige Programme können scheitern; richtig ist mindestens %5</translation>
    </message>
    <message>
        <source>the check %1 asks for the same as %2</source>
        <translation>die Prüfung %1 verlangt dasselbe wie %2</translation>
    </message>
    <message>
        <source>fails what is turned, too fast, adrift by</source>
        <translation>fällt durch bei: gedreht, zu schnell, weggetrieben um</translation>
    </message>
    <message>
        <source>no mistake fails by the check %1 alone: it repeats %2</source>
        <translation>kein Fehler scheitert allein an der Prüfung %1: Sie wiederholt %2</translation>
    </message>
    <message>
        <source>%1 differs in more than its mistake: it has “%2” where the solution has “%3”</source>
        <translation>%1 unterscheidet sich in mehr als seinem Fehler: Dort steht „%2“, in der Lösung „%3“</translation>
    </message>
    <message>
        <source>with the values of the student %1: %2</source>
        <translation>mit den Werten der Nummer %1: %2</translation>
    </message>
    <message>
        <source>with %1 seeds</source>
        <translation>mit %1 Startwerten</translation>
    </message>
    <message>
        <source>is not judged by the check %1: %2</source>
        <translation>wird von der Prüfung %1 nicht beurteilt: %2</translation>
    </message>
    <message>
        <source>%1: %2 of %3 values, %4 to %5</source>
        <comment>of a range</comment>
        <translation>%1: %2 von %3 Werten, %4 bis %5</translation>
    </message>
    <message>
        <source>the question %1 asks for %2, and its tolerance is 0: nobody answers it rightly</source>
        <translation>die Frage %1 verlangt %2, und ihre Toleranz ist 0: Niemand beantwortet sie richtig</translation>
    </message>
    <message>
        <source>in the language %1: %2</source>
        <translation>in der Sprache %1: %2</translation>
    </message>
</context>
<context>
    <name>LawNames</name>
    <message>
        <source>None</source>
        <comment>law for walls</comment>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Reflect</source>
        <translation>Reflektieren</translation>
    </message>
    <message>
        <source>None</source>
        <comment>law for circles</comment>
        <translation>Keines</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Swap velocities</source>
        <translation>Geschwindigkeiten tauschen</translation>
    </message>
    <message>
        <source>Swap normal parts</source>
        <translation>Normalanteile tauschen</translation>
    </message>
    <message>
        <source>Impulse</source>
        <translation>Kraftstoß</translation>
    </message>
    <message>
        <source>Discrete</source>
        <translation>Diskret</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Kontinuierlich</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>Euler</source>
        <translation>Euler</translation>
    </message>
    <message>
        <source>Symplectic Euler</source>
        <translation>Symplektischer Euler</translation>
    </message>
    <message>
        <source>Velocity Verlet</source>
        <translation>Velocity-Verlet</translation>
    </message>
    <message>
        <source>Runge-Kutta 4</source>
        <translation>Runge-Kutta 4</translation>
    </message>
    <message>
        <source>S. Euler</source>
        <comment>short for Symplectic Euler</comment>
        <translation>S. Euler</translation>
    </message>
    <message>
        <source>Verlet</source>
        <comment>short for Velocity Verlet</comment>
        <translation>Verlet</translation>
    </message>
</context>
<context>
    <name>Lists</name>
    <message>
        <source>, </source>
        <extracomment>between the things of a list</extracomment>
        <translation>, </translation>
    </message>
</context>
<context>
    <name>Locks</name>
    <message>
        <source>gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>restitution</source>
        <translation>Stoßzahl</translation>
    </message>
    <message>
        <source>timestep</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>half width of the square</source>
        <translation>halbe Breite des Quadrats</translation>
    </message>
    <message>
        <source>law for walls</source>
        <translation>Gesetz für Wände</translation>
    </message>
    <message>
        <source>law for circles</source>
        <translation>Gesetz für Kreise</translation>
    </message>
    <message>
        <source>timing</source>
        <translation>Zeitführung</translation>
    </message>
    <message>
        <source>number of circles</source>
        <translation>Anzahl der Kreise</translation>
    </message>
    <message>
        <source>position of %1</source>
        <translation>Ort von %1</translation>
    </message>
    <message>
        <source>velocity of %1</source>
        <translation>Geschwindigkeit von %1</translation>
    </message>
    <message>
        <source>radius of %1</source>
        <translation>Radius von %1</translation>
    </message>
    <message>
        <source>density of %1</source>
        <translation>Dichte von %1</translation>
    </message>
    <message>
        <source>integrator of %1</source>
        <translation>Integrator von %1</translation>
    </message>
    <message>
        <source>mass of %1</source>
        <translation>Masse von %1</translation>
    </message>
    <message>
        <source>circle %1</source>
        <translation>Kreis %1</translation>
    </message>
    <message>
        <source>Fixed in this step: %1</source>
        <translation>In diesem Schritt fest: %1</translation>
    </message>
</context>
<context>
    <name>Loupe</name>
    <message>
        <source>%1×</source>
        <comment>magnification</comment>
        <translation>%1×</translation>
    </message>
</context>
<context>
    <name>LuaApi</name>
    <message>
        <source>You write it: runs once, before the first step</source>
        <translation>Schreibst du: läuft einmal, vor dem ersten Schritt</translation>
    </message>
    <message>
        <source>You write it: moves the circles by one step of timestep seconds</source>
        <translation>Schreibst du: bewegt die Kreise um einen Schritt von timestep Sekunden</translation>
    </message>
    <message>
        <source>A new vector; its unit is that of its numbers</source>
        <translation>Ein neuer Vektor; seine Einheit ist die seiner Zahlen</translation>
    </message>
    <message>
        <source>The dot product of two vectors: a.x * b.x + a.y * b.y</source>
        <translation>Das Skalarprodukt zweier Vektoren: a.x * b.x + a.y * b.y</translation>
    </message>
    <message>
        <source>The first circle</source>
        <translation>Der erste Kreis</translation>
    </message>
    <message>
        <source>The second circle</source>
        <translation>Der zweite Kreis</translation>
    </message>
    <message>
        <source>All circles: circles[1] to circles[#circles]</source>
        <translation>Alle Kreise: circles[1] bis circles[#circles]</translation>
    </message>
    <message>
        <source>The acceleration of every circle, a vector in m/s²; may be set in on_load</source>
        <translation>Die Beschleunigung jedes Kreises, ein Vektor in m/s²; lässt sich in on_load setzen</translation>
    </message>
    <message>
        <source>From 0 (no rebound) to 1 (elastic); may be set in on_load</source>
        <translation>Von 0 (kein Rückprall) bis 1 (elastisch); lässt sich in on_load setzen</translation>
    </message>
    <message>
        <source>The box that the circles are in</source>
        <translation>Das Quadrat, in dem die Kreise sind</translation>
    </message>
    <message>
        <source>Seconds since the start of the run, at the start of this step</source>
        <translation>Sekunden seit dem Anfang des Laufs, am Anfang dieses Schritts</translation>
    </message>
    <message>
        <source>The number of steps made so far</source>
        <translation>Die Zahl der bisherigen Schritte</translation>
    </message>
    <message>
        <source>Adds a point of this step to the curve called name in the charts</source>
        <translation>Fügt der Kurve name in den Diagrammen einen Punkt für diesen Schritt hinzu</translation>
    </message>
    <message>
        <source>Draws over the scene, for this step</source>
        <translation>Zeichnet über die Szene, für diesen Schritt</translation>
    </message>
    <message>
        <source>Writes a line to the console</source>
        <translation>Schreibt eine Zeile in die Konsole</translation>
    </message>
    <message>
        <source>Functions of numbers</source>
        <translation>Funktionen für Zahlen</translation>
    </message>
    <message>
        <source>Functions of texts</source>
        <translation>Funktionen für Texte</translation>
    </message>
    <message>
        <source>Functions of lists</source>
        <translation>Funktionen für Listen</translation>
    </message>
    <message>
        <source>For a loop over a list in order: for i, v in ipairs(list) do</source>
        <translation>Für eine Schleife über eine Liste, der Reihe nach: for i, v in ipairs(list) do</translation>
    </message>
    <message>
        <source>For a loop over all fields of a table: for k, v in pairs(t) do</source>
        <translation>Für eine Schleife über alle Felder einer Tabelle: for k, v in pairs(t) do</translation>
    </message>
    <message>
        <source>The arguments from number n on; with &apos;#&apos; how many there are</source>
        <translation>Die Argumente ab Nummer n; mit &apos;#&apos;, wie viele es sind</translation>
    </message>
    <message>
        <source>What a value is, as a text: &quot;number&quot;, &quot;vector&quot;, &quot;circle&quot; …</source>
        <translation>Was ein Wert ist, als Text: &quot;number&quot;, &quot;vector&quot;, &quot;circle&quot; …</translation>
    </message>
    <message>
        <source>A value as a text</source>
        <translation>Ein Wert als Text</translation>
    </message>
    <message>
        <source>The number that a text says, or nil; base is 10 unless given</source>
        <translation>Die Zahl, die ein Text nennt, oder nil; base ist ohne Angabe 10</translation>
    </message>
    <message>
        <source>Stops the run with the message if value is false or nil</source>
        <translation>Hält den Lauf mit der Meldung an, wenn value false oder nil ist</translation>
    </message>
    <message>
        <source>Stops the run at this line with the message</source>
        <translation>Hält den Lauf in dieser Zeile mit der Meldung an</translation>
    </message>
    <message>
        <source>Calls f: true and its results, or false and the error</source>
        <translation>Ruft f auf: true und die Ergebnisse oder false und der Fehler</translation>
    </message>
    <message>
        <source>The length of the vector</source>
        <translation>Die Länge des Vektors</translation>
    </message>
    <message>
        <source>The square of the length: v:dot(v)</source>
        <translation>Das Quadrat der Länge: v:dot(v)</translation>
    </message>
    <message>
        <source>The vector of length 1 with the same direction; an error for (0, 0)</source>
        <translation>Der Vektor der Länge 1 mit derselben Richtung; ein Fehler bei (0, 0)</translation>
    </message>
    <message>
        <source>The dot product with another vector</source>
        <translation>Das Skalarprodukt mit einem anderen Vektor</translation>
    </message>
    <message>
        <source>The vector turned left by 90°: (-y, x)</source>
        <translation>Der Vektor, um 90° nach links gedreht: (-y, x)</translation>
    </message>
    <message>
        <source>The part to the right; to change it, build a new vector</source>
        <translation>Der Anteil nach rechts; um ihn zu ändern, bilde einen neuen Vektor</translation>
    </message>
    <message>
        <source>The part upwards; to change it, build a new vector</source>
        <translation>Der Anteil nach oben; um ihn zu ändern, bilde einen neuen Vektor</translation>
    </message>
    <message>
        <source>The centre, a vector in m</source>
        <translation>Der Mittelpunkt, ein Vektor in m</translation>
    </message>
    <message>
        <source>A vector in m/s</source>
        <translation>Ein Vektor in m/s</translation>
    </message>
    <message>
        <source>In m, above 0</source>
        <translation>In m, über 0</translation>
    </message>
    <message>
        <source>In 1000 kg/m³, above 0: steel has 7.8</source>
        <translation>In 1000 kg/m³, über 0: Stahl hat 7.8</translation>
    </message>
    <message>
        <source>The number of the circle, from 1; cannot be set</source>
        <translation>Die Nummer des Kreises, ab 1; lässt sich nicht setzen</translation>
    </message>
    <message>
        <source>Half the side of the box, in m</source>
        <translation>Die halbe Seite des Quadrats, in m</translation>
    </message>
    <message>
        <source>The x of the left wall, in m</source>
        <translation>Das x der linken Wand, in m</translation>
    </message>
    <message>
        <source>The x of the right wall, in m</source>
        <translation>Das x der rechten Wand, in m</translation>
    </message>
    <message>
        <source>The y of the floor, in m</source>
        <translation>Das y des Bodens, in m</translation>
    </message>
    <message>
        <source>The y of the ceiling, in m</source>
        <translation>Das y der Decke, in m</translation>
    </message>
    <message>
        <source>An arrow that begins at from; colour and label may be left out</source>
        <translation>Ein Pfeil, der bei from beginnt; colour und label können fehlen</translation>
    </message>
    <message>
        <source>A line between two points; the colour may be left out</source>
        <translation>Eine Strecke zwischen zwei Punkten; colour kann fehlen</translation>
    </message>
    <message>
        <source>A dot; the colour may be left out</source>
        <translation>Ein Punkt; colour kann fehlen</translation>
    </message>
    <message>
        <source>A text at a point</source>
        <translation>Ein Text an einem Punkt</translation>
    </message>
    <message>
        <source>x without its sign</source>
        <translation>x ohne Vorzeichen</translation>
    </message>
    <message>
        <source>The angle whose cosine is x, in radians</source>
        <translation>Der Winkel, dessen Kosinus x ist, im Bogenmaß</translation>
    </message>
    <message>
        <source>The angle whose sine is x, in radians</source>
        <translation>Der Winkel, dessen Sinus x ist, im Bogenmaß</translation>
    </message>
    <message>
        <source>The angle of the direction (x, y), in radians; x is 1 unless given</source>
        <translation>Der Winkel der Richtung (x, y), im Bogenmaß; x ist ohne Angabe 1</translation>
    </message>
    <message>
        <source>The next whole number that is not below x</source>
        <translation>Die nächste ganze Zahl, die nicht unter x liegt</translation>
    </message>
    <message>
        <source>The cosine of an angle in radians</source>
        <translation>Der Kosinus eines Winkels im Bogenmaß</translation>
    </message>
    <message>
        <source>Radians in degrees</source>
        <translation>Bogenmaß in Grad</translation>
    </message>
    <message>
        <source>e to the power of x</source>
        <translation>e hoch x</translation>
    </message>
    <message>
        <source>The next whole number that is not above x</source>
        <translation>Die nächste ganze Zahl, die nicht über x liegt</translation>
    </message>
    <message>
        <source>What is left of x divided by y, with the sign of x</source>
        <translation>Der Rest von x geteilt durch y, mit dem Vorzeichen von x</translation>
    </message>
    <message>
        <source>Infinity: more than any number</source>
        <translation>Unendlich: mehr als jede Zahl</translation>
    </message>
    <message>
        <source>The logarithm of x; base is e unless given</source>
        <translation>Der Logarithmus von x; base ist ohne Angabe e</translation>
    </message>
    <message>
        <source>The largest of the numbers</source>
        <translation>Die größte der Zahlen</translation>
    </message>
    <message>
        <source>The largest whole number of Lua</source>
        <translation>Die größte ganze Zahl von Lua</translation>
    </message>
    <message>
        <source>The smallest of the numbers</source>
        <translation>Die kleinste der Zahlen</translation>
    </message>
    <message>
        <source>The smallest whole number of Lua</source>
        <translation>Die kleinste ganze Zahl von Lua</translation>
    </message>
    <message>
        <source>The whole part of x, and the rest</source>
        <translation>Der ganze Teil von x und der Rest</translation>
    </message>
    <message>
        <source>3.14159…</source>
        <translation>3.14159…</translation>
    </message>
    <message>
        <source>Degrees in radians</source>
        <translation>Grad im Bogenmaß</translation>
    </message>
    <message>
        <source>From 0 up to 1, or a whole number from m to n; the same in every run</source>
        <translation>Von 0 bis unter 1 oder eine ganze Zahl von m bis n; in jedem Lauf dasselbe</translation>
    </message>
    <message>
        <source>Begins another row of random numbers</source>
        <translation>Beginnt eine andere Folge von Zufallszahlen</translation>
    </message>
    <message>
        <source>The sine of an angle in radians</source>
        <translation>Der Sinus eines Winkels im Bogenmaß</translation>
    </message>
    <message>
        <source>The square root of x</source>
        <translation>Die Quadratwurzel von x</translation>
    </message>
    <message>
        <source>The tangent of an angle in radians</source>
        <translation>Der Tangens eines Winkels im Bogenmaß</translation>
    </message>
    <message>
        <source>x as a whole number, or nil if it is none</source>
        <translation>x als ganze Zahl, oder nil, wenn es keine ist</translation>
    </message>
    <message>
        <source>&quot;integer&quot;, &quot;float&quot;, or nil if x is no number</source>
        <translation>&quot;integer&quot;, &quot;float&quot;, oder nil, wenn x keine Zahl ist</translation>
    </message>
    <message>
        <source>Whether m is below n, both read without sign</source>
        <translation>Ob m kleiner als n ist, beide ohne Vorzeichen gelesen</translation>
    </message>
    <message>
        <source>Values in a text: string.format(&quot;%.3f&quot;, x)</source>
        <translation>Werte in einem Text: string.format(&quot;%.3f&quot;, x)</translation>
    </message>
    <message>
        <source>The number of bytes of a text</source>
        <translation>Die Zahl der Bytes eines Textes</translation>
    </message>
    <message>
        <source>A text in small letters</source>
        <translation>Ein Text in Kleinbuchstaben</translation>
    </message>
    <message>
        <source>Part of a text; -1 is its last byte</source>
        <translation>Ein Teil eines Textes; -1 ist sein letztes Byte</translation>
    </message>
    <message>
        <source>A text in capital letters</source>
        <translation>Ein Text in Großbuchstaben</translation>
    </message>
    <message>
        <source>The elements of a list as one text</source>
        <translation>Die Elemente einer Liste als ein Text</translation>
    </message>
    <message>
        <source>Puts a value into a list, at its end if no position is given</source>
        <translation>Fügt einen Wert in eine Liste ein, ohne position am Ende</translation>
    </message>
    <message>
        <source>Takes an element out of a list, the last one unless told</source>
        <translation>Nimmt ein Element aus einer Liste, ohne position das letzte</translation>
    </message>
    <message>
        <source>Sorts a list; before(a, b) says whether a comes first</source>
        <translation>Sortiert eine Liste; before(a, b) sagt, ob a zuerst kommt</translation>
    </message>
    <message>
        <source>The elements of a list as so many values</source>
        <translation>Die Elemente einer Liste als einzelne Werte</translation>
    </message>
</context>
<context>
    <name>Main</name>
    <message>
        <source>open this step</source>
        <translation>diesen Schritt öffnen</translation>
    </message>
    <message>
        <source>draw the window into this file and quit</source>
        <translation>das Fenster in diese Datei zeichnen und beenden</translation>
    </message>
    <message>
        <source>of the scene&apos;s time, s, in the picture</source>
        <translation>Zeit der Szene im Bild, s</translation>
    </message>
    <message>
        <source>of the window, pixels</source>
        <translation>Größe des Fensters, Pixel</translation>
    </message>
    <message>
        <source>there is no step %1; there are %2</source>
        <translation>es gibt keinen Schritt %1; es gibt %2</translation>
    </message>
    <message>
        <source>Learn how a physics engine works by writing one.</source>
        <translation>Lerne, wie eine Physik-Engine arbeitet, indem du eine schreibst.</translation>
    </message>
    <message>
        <source>the lab or the scene to open; without it Lab 4.2</source>
        <translation>das Lab oder die Szene, die geöffnet wird; ohne Angabe Lab 4.2</translation>
    </message>
    <message>
        <source>--at %1: a number of seconds from 0 to %2 is right</source>
        <translation>--at %1: Richtig ist eine Zahl von Sekunden von 0 bis %2</translation>
    </message>
    <message>
        <source>--size %1: a size like 1280x800 is right</source>
        <translation>--size %1: Richtig ist eine Größe wie 1280x800</translation>
    </message>
    <message>
        <source>cradle: unexpected argument %1; one lab or scene is right</source>
        <translation>cradle: unerwartetes Argument %1; richtig ist ein Lab oder eine Szene</translation>
    </message>
    <message>
        <source>work on steps by this: explore or code</source>
        <translation>Schritte so bearbeiten: explore oder code</translation>
    </message>
    <message>
        <source>take this program as your own of the step</source>
        <translation>dieses Programm als deines für den Schritt nehmen</translation>
    </message>
    <message>
        <source>cradle: --mode %1: explore or code is right</source>
        <translation>cradle: --mode %1: Richtig ist explore oder code</translation>
    </message>
    <message>
        <source>open this scene of Lab → Example scenes</source>
        <translation>diese Szene aus Lab → Beispielszenen öffnen</translation>
    </message>
    <message>
        <source>there is no example %1; there are %2</source>
        <translation>es gibt kein Beispiel %1; es gibt %2</translation>
    </message>
    <message>
        <source>open this lab in the window in which labs are written</source>
        <translation>dieses Lab in dem Fenster öffnen, in dem Labs geschrieben werden</translation>
    </message>
    <message>
        <source>of that window: scene, text, checks, programs or proof</source>
        <translation>dieses Fensters: scene, text, checks, programs oder proof</translation>
    </message>
    <message>
        <source>--tab %1: scene, text, checks, programs or proof is right</source>
        <translation>--tab %1: Richtig ist scene, text, checks, programs oder proof</translation>
    </message>
    <message>
        <source>there is no step %1 in this lab</source>
        <translation>in diesem Lab gibt es keinen Schritt %1</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>speak this language, such as en or de</source>
        <translation>diese Sprache sprechen, etwa en oder de</translation>
    </message>
    <message>
        <source>system, light, dark or high-contrast</source>
        <translation>system, light, dark oder high-contrast</translation>
    </message>
    <message>
        <source>of texts, %: 100 to 200</source>
        <translation>der Texte, %: 100 bis 200</translation>
    </message>
    <message>
        <source>cradle: --language %1: one of %2 is right</source>
        <translation>cradle: --language %1: Richtig ist eine von %2</translation>
    </message>
    <message>
        <source>cradle: --theme %1: system, light, dark or high-contrast is right</source>
        <translation>cradle: --theme %1: Richtig ist system, light, dark oder high-contrast</translation>
    </message>
    <message>
        <source>cradle: --text-size %1: a number from 100 to 200 is right</source>
        <translation>cradle: --text-size %1: Richtig ist eine Zahl von 100 bis 200</translation>
    </message>
</context>
<context>
    <name>MainMenu</name>
    <message>
        <source>&amp;Lab</source>
        <translation>&amp;Lab</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>&amp;Nächster Schritt</translation>
    </message>
    <message>
        <source>&amp;Previous step</source>
        <translation>&amp;Voriger Schritt</translation>
    </message>
    <message>
        <source>&amp;Open lab…</source>
        <translation>Lab ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open &amp;scene…</source>
        <translation>&amp;Szene öffnen…</translation>
    </message>
    <message>
        <source>Sa&amp;ve scene as…</source>
        <translation>Szene speichern &amp;unter…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>B&amp;eenden</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Add circle</source>
        <translation>Kreis &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Reset to the &amp;step&apos;s scene</source>
        <translation>Auf die &amp;Szene des Schritts zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Simulation</source>
        <translation>&amp;Simulation</translation>
    </message>
    <message>
        <source>Steps as long as the &amp;frames took</source>
        <translation>Schritte so lang, wie die &amp;Bilder brauchten</translation>
    </message>
    <message>
        <source>As the original lab did: see why stable timesteps matter</source>
        <translation>Wie im ursprünglichen Lab: Sieh, warum gleichbleibende Zeitschritte wichtig sind</translation>
    </message>
    <message>
        <source>&amp;Scene shows</source>
        <translation>&amp;Szene zeigt</translation>
    </message>
    <message>
        <source>&amp;Velocities</source>
        <translation>&amp;Geschwindigkeiten</translation>
    </message>
    <message>
        <source>&amp;Trails</source>
        <translation>&amp;Spuren</translation>
    </message>
    <message>
        <source>&amp;Parts of a hit</source>
        <translation>&amp;Anteile beim Stoß</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>&amp;Namen</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Raster</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Vergrößern</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Show the whole s&amp;quare</source>
        <translation>Ganzes &amp;Quadrat zeigen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Panes</source>
        <translation>&amp;Bereiche</translation>
    </message>
    <message>
        <source>&amp;Move panes</source>
        <translation>Bereiche &amp;verschieben</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>Spra&amp;che</translation>
    </message>
    <message>
        <source>Scene drawn &amp;by</source>
        <translation>Szene &amp;zeichnen</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatisch</translation>
    </message>
    <message>
        <source>&amp;OpenGL</source>
        <translation>Mit &amp;OpenGL</translation>
    </message>
    <message>
        <source>&amp;Processor</source>
        <translation>Mit dem &amp;Prozessor</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;About Cradle</source>
        <translation>Über &amp;Cradle</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Über &amp;Qt</translation>
    </message>
    <message>
        <source>&amp;Drawings of the program</source>
        <translation>&amp;Zeichnungen des Programms</translation>
    </message>
    <message>
        <source>&amp;Reference of the lab&apos;s Lua</source>
        <translation>&amp;Referenz: das Lua des Labs</translation>
    </message>
    <message>
        <source>&amp;Exact motion beside the run</source>
        <translation>&amp;Exakte Bewegung neben dem Lauf</translation>
    </message>
    <message>
        <source>Outlines where every circle would be without any error of the integrator, the program or the timestep</source>
        <translation>Umrisse dort, wo jeder Kreis ohne jeden Fehler des Integrators, des Programms oder des Zeitschritts wäre</translation>
    </message>
    <message>
        <source>&amp;Example scenes</source>
        <translation>Be&amp;ispielszenen</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xportieren</translation>
    </message>
    <message>
        <source>&amp;States of the run as CSV…</source>
        <translation>&amp;Zustände des Laufs als CSV…</translation>
    </message>
    <message>
        <source>&amp;Totals of the run as CSV…</source>
        <translation>&amp;Summen des Laufs als CSV…</translation>
    </message>
    <message>
        <source>&amp;Hits of the run as CSV…</source>
        <translation>S&amp;töße des Laufs als CSV…</translation>
    </message>
    <message>
        <source>&amp;Pin this run</source>
        <translation>Diesen Lauf an&amp;heften</translation>
    </message>
    <message>
        <source>Keeps its curves, pale, beneath those of later runs</source>
        <translation>Behält seine Kurven, blass, unter denen späterer Läufe</translation>
    </message>
    <message>
        <source>Remo&amp;ve pinned runs</source>
        <translation>Angeheftete Läufe &amp;entfernen</translation>
    </message>
    <message>
        <source>Start a &amp;new run from here</source>
        <translation>&amp;Neuer Lauf ab hier</translation>
    </message>
    <message>
        <source>The moment shown becomes the start of the scene; the run so far stays in the charts</source>
        <translation>Der gezeigte Augenblick wird zum Anfang der Szene; der bisherige Lauf bleibt in den Diagrammen</translation>
    </message>
    <message>
        <source>Pause at &amp;hits</source>
        <translation>Bei &amp;Stößen anhalten</translation>
    </message>
    <message>
        <source>A run stops at the step of every collision; Run goes on</source>
        <translation>Ein Lauf hält beim Schritt jedes Stoßes an; „Starten“ setzt ihn fort</translation>
    </message>
    <message>
        <source>&amp;Momenta tip to tail</source>
        <translation>&amp;Impulse aneinandergesetzt</translation>
    </message>
    <message>
        <source>&amp;Centre of mass and its way</source>
        <translation>S&amp;chwerpunkt und sein Weg</translation>
    </message>
    <message>
        <source>&amp;Follow the centre of mass</source>
        <translation>Dem Sch&amp;werpunkt folgen</translation>
    </message>
    <message>
        <source>The view moves along with it: in its frame the momenta of all circles add up to nothing</source>
        <translation>Die Ansicht bewegt sich mit ihm: In seinem Bezugssystem heben sich die Impulse aller Kreise auf</translation>
    </message>
    <message>
        <source>C&amp;harts</source>
        <translation>&amp;Diagramme</translation>
    </message>
    <message>
        <source>&amp;Reset zoom</source>
        <translation>Zoom &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Open lab in one &amp;file…</source>
        <translation>Lab aus einer &amp;Datei öffnen…</translation>
    </message>
    <message>
        <source>&amp;Author a lab…</source>
        <translation>Ein Lab s&amp;chreiben…</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Bericht…</translation>
    </message>
    <message>
        <source>&amp;Hand in…</source>
        <translation>&amp;Abgeben…</translation>
    </message>
    <message>
        <source>Share with &amp;git…</source>
        <translation>Mit &amp;git teilen…</translation>
    </message>
    <message>
        <source>Grade a &amp;class…</source>
        <translation>Einen &amp;Kurs bewerten…</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Vo&amp;llbild</translation>
    </message>
    <message>
        <source>Ne&amp;xt pane</source>
        <translation>&amp;Nächster Bereich</translation>
    </message>
    <message>
        <source>Pre&amp;vious pane</source>
        <translation>V&amp;origer Bereich</translation>
    </message>
    <message>
        <source>Into the progra&amp;m</source>
        <translation>Ins &amp;Programm</translation>
    </message>
    <message>
        <source>Scene &amp;alone</source>
        <translation>Szene &amp;allein</translation>
    </message>
    <message>
        <source>P&amp;resentation</source>
        <translation>Vorfü&amp;hrung</translation>
    </message>
    <message>
        <source>Large texts and high contrast; Page Up and Page Down go from hit to hit, B makes it black, Esc ends it</source>
        <translation>Große Texte und hoher Kontrast; Bild auf und Bild ab gehen von Stoß zu Stoß, B macht schwarz, Esc beendet</translation>
    </message>
    <message>
        <source>Scene in a &amp;window of its own</source>
        <translation>Szene &amp;in einem eigenen Fenster</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Hoher &amp;Kontrast</translation>
    </message>
    <message>
        <source>Si&amp;ze of texts</source>
        <translation>&amp;Größe der Texte</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>&amp;Lua for C# people</source>
        <translation>&amp;Lua für Leute, die C# können</translation>
    </message>
    <message>
        <source>&amp;Tour of the window</source>
        <translation>Rund&amp;gang durch das Fenster</translation>
    </message>
    <message>
        <source>Slow &amp;motion around hits</source>
        <translation>Zeit&amp;lupe um Stöße</translation>
    </message>
    <message>
        <source>A run goes at 1/8× after every hit, and before those that are recorded already; its steps stay as they are</source>
        <translation>Ein Lauf geht nach jedem Stoß mit 1/8×, und vor denen, die schon aufgezeichnet sind; seine Schritte bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>&amp;Loupe at a hit</source>
        <translation>&amp;Lupe bei einem Stoß</translation>
    </message>
    <message>
        <source>Zoom to the hi&amp;t</source>
        <translation>Zum S&amp;toß zoomen</translation>
    </message>
    <message>
        <source>Hits to scree&amp;n readers</source>
        <translation>Stöße an Sc&amp;reenreader</translation>
    </message>
    <message>
        <source>They tell every hit that is shown; of a run that goes on, one in a while</source>
        <translation>Sie sagen jeden Stoß an, der gezeigt wird; in einem laufenden Lauf ab und zu einen</translation>
    </message>
    <message>
        <source>S&amp;ounds of hits</source>
        <translation>Stöße hö&amp;ren</translation>
    </message>
    <message>
        <source>The heavier a circle, the lower its tone; the greater the impulse, the louder</source>
        <translation>Je schwerer ein Kreis, desto tiefer sein Ton; je größer der Kraftstoß, desto lauter</translation>
    </message>
</context>
<context>
    <name>MomentumInset</name>
    <message>
        <source>Momentum</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>%1 kg m/s</source>
        <translation>%1 kg m/s</translation>
    </message>
</context>
<context>
    <name>Mutations</name>
    <message>
        <source>A term has the wrong sign</source>
        <translation>Ein Term hat das falsche Vorzeichen</translation>
    </message>
    <message>
        <source>Which way should this term act? Try it with a circle that moves to the right.</source>
        <translation>In welche Richtung soll dieser Term wirken? Probiere es mit einem Kreis, der sich nach rechts bewegt.</translation>
    </message>
    <message>
        <source>The factor `%1` is missing</source>
        <translation>Der Faktor `%1` fehlt</translation>
    </message>
    <message>
        <source>Do both sides have the same unit? What changes if this factor is twice as large?</source>
        <translation>Haben beide Seiten dieselbe Einheit? Was ändert sich, wenn dieser Faktor doppelt so groß ist?</translation>
    </message>
    <message>
        <source>Something stands in the wrong place</source>
        <translation>Etwas steht am falschen Platz</translation>
    </message>
    <message>
        <source>A product comes before a sum: what belongs together here?</source>
        <translation>Punkt vor Strich: Was gehört hier zusammen?</translation>
    </message>
    <message>
        <source>The normal does not have the length 1</source>
        <translation>Die Normale hat nicht die Länge 1</translation>
    </message>
    <message>
        <source>How long is this vector? A part along it is right only if its length is 1.</source>
        <translation>Wie lang ist dieser Vektor? Ein Anteil längs von ihm stimmt nur, wenn seine Länge 1 ist.</translation>
    </message>
    <message>
        <source>A comparison is the wrong way round</source>
        <translation>Ein Vergleich ist verkehrt herum</translation>
    </message>
    <message>
        <source>When should this happen: above or below?</source>
        <translation>Wann soll das geschehen: darüber oder darunter?</translation>
    </message>
    <message>
        <source>A part of a condition is missing</source>
        <translation>Ein Teil einer Bedingung fehlt</translation>
    </message>
    <message>
        <source>When should this happen, and when not? Think of circles that already move apart, and of every wall.</source>
        <translation>Wann soll das geschehen und wann nicht? Denke an Kreise, die sich schon entfernen, und an jede Wand.</translation>
    </message>
    <message>
        <source>One case is missing</source>
        <translation>Ein Fall fehlt</translation>
    </message>
    <message>
        <source>Go through the cases one by one: which of them does nothing?</source>
        <translation>Geh die Fälle einzeln durch: Welcher tut nichts?</translation>
    </message>
    <message>
        <source>It happens always</source>
        <translation>Es geschieht immer</translation>
    </message>
    <message>
        <source>When should this happen, and when not?</source>
        <translation>Wann soll das geschehen und wann nicht?</translation>
    </message>
    <message>
        <source>`%1` stands where `%2` belongs</source>
        <translation>`%1` steht, wo `%2` hingehört</translation>
    </message>
    <message>
        <source>Which circle, and which coordinate, is meant here?</source>
        <translation>Welcher Kreis und welche Koordinate ist hier gemeint?</translation>
    </message>
    <message>
        <source>The hit takes nothing</source>
        <translation>Der Stoß nimmt nichts</translation>
    </message>
    <message>
        <source>Which part of the velocity should become e times what it was?</source>
        <translation>Welcher Anteil der Geschwindigkeit soll das e-Fache werden?</translation>
    </message>
    <message>
        <source>e counts twice</source>
        <translation>e zählt doppelt</translation>
    </message>
    <message>
        <source>How fast does it leave, compared with how fast it came?</source>
        <translation>Wie schnell geht er, verglichen damit, wie schnell er kam?</translation>
    </message>
    <message>
        <source>Something is left out</source>
        <translation>Etwas ist ausgelassen</translation>
    </message>
    <message>
        <source>Compare with the instructions what has to be done for every circle in every step.</source>
        <translation>Vergleiche mit der Anleitung, was in jedem Schritt für jeden Kreis zu tun ist.</translation>
    </message>
    <message>
        <source>Something happens twice</source>
        <translation>Etwas geschieht zweimal</translation>
    </message>
    <message>
        <source>How often does this run in one step?</source>
        <translation>Wie oft läuft das in einem Schritt?</translation>
    </message>
    <message>
        <source>Two lines stand in the other order</source>
        <translation>Zwei Zeilen stehen in anderer Reihenfolge</translation>
    </message>
    <message>
        <source>Which value does the second line need: the one from before or the one from after the first?</source>
        <translation>Welchen Wert braucht die zweite Zeile: den von vor oder den von nach der ersten?</translation>
    </message>
</context>
<context>
    <name>Panes</name>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>lab.lua</source>
        <translation>lab.lua</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Fassungen</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
</context>
<context>
    <name>ParameterText</name>
    <message>
        <source>from %1 to %2%3</source>
        <translation>von %1 bis %2%3</translation>
    </message>
    <message>
        <source>%1%2 or more</source>
        <translation>%1%2 oder mehr</translation>
    </message>
    <message>
        <source>any%1</source>
        <translation>beliebig%1</translation>
    </message>
    <message>
        <source>%1: a whole number, %2, is right</source>
        <translation>%1: Richtig ist eine ganze Zahl, %2</translation>
    </message>
    <message>
        <source>%1: two numbers as “2, 0”, %2, are right</source>
        <translation>%1: Richtig sind zwei Zahlen wie „2, 0“, %2</translation>
    </message>
    <message>
        <source>%1: the least and the most as “0.5, 2”, %2, are right</source>
        <translation>%1: Richtig sind kleinster und größter Wert wie „0.5, 2“, %2</translation>
    </message>
    <message>
        <source>%1: pairs of numbers as “2, 0; 0, 0”, %2, are right</source>
        <translation>%1: Richtig sind Zahlenpaare wie „2, 0; 0, 0“, %2</translation>
    </message>
    <message>
        <source>%1: numbers as “0.5, 1”, %2, are right</source>
        <translation>%1: Richtig sind Zahlen wie „0.5, 1“, %2</translation>
    </message>
    <message>
        <source>%1: a number, %2, is right</source>
        <translation>%1: Richtig ist eine Zahl, %2</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>, in %1</source>
        <translation>, in %1</translation>
    </message>
</context>
<context>
    <name>Phase</name>
    <message>
        <source>kinetic</source>
        <translation>kinetisch</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>potentiell</translation>
    </message>
    <message>
        <source>total</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>distance 1–2</source>
        <translation>Abstand 1–2</translation>
    </message>
    <message>
        <source>off exact</source>
        <translation>neben exakt</translation>
    </message>
    <message>
        <source>more than exact</source>
        <translation>mehr als exakt</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Position x</source>
        <translation>Ort x</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>Ort y</translation>
    </message>
    <message>
        <source>Velocity to the right</source>
        <translation>Geschwindigkeit nach rechts</translation>
    </message>
    <message>
        <source>Velocity upwards</source>
        <translation>Geschwindigkeit nach oben</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Betrag der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Momentum to the right</source>
        <translation>Impuls nach rechts</translation>
    </message>
    <message>
        <source>Momentum upwards</source>
        <translation>Impuls nach oben</translation>
    </message>
    <message>
        <source>Size of the momentum</source>
        <translation>Betrag des Impulses</translation>
    </message>
    <message>
        <source>Kinetic energy</source>
        <translation>Kinetische Energie</translation>
    </message>
    <message>
        <source>Potential energy</source>
        <translation>Potentielle Energie</translation>
    </message>
    <message>
        <source>Total energy</source>
        <translation>Gesamtenergie</translation>
    </message>
    <message>
        <source>Distance of circles 1 and 2</source>
        <translation>Abstand der Kreise 1 und 2</translation>
    </message>
    <message>
        <source>Distance from the exact motion</source>
        <translation>Abstand von der exakten Bewegung</translation>
    </message>
    <message>
        <source>Energy more than the exact motion</source>
        <translation>Mehr Energie als die exakte Bewegung</translation>
    </message>
    <message>
        <source>s</source>
        <comment>seconds</comment>
        <translation>s</translation>
    </message>
    <message>
        <source>m</source>
        <comment>metres</comment>
        <translation>m</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>kg m/s</source>
        <translation>kg m/s</translation>
    </message>
    <message>
        <source>J</source>
        <comment>joules</comment>
        <translation>J</translation>
    </message>
    <message>
        <source>%1 all</source>
        <comment>quantity, of all circles</comment>
        <translation>%1 alle</translation>
    </message>
</context>
<context>
    <name>Preset</name>
    <message>
        <source>%1 circles of radius %2 m do not fit into the square; at most %3 are right</source>
        <translation>%1 Kreise mit Radius %2 m passen nicht in das Quadrat; richtig sind höchstens %3</translation>
    </message>
    <message>
        <source>the name is too long; at most %1 characters are right</source>
        <translation>der Name ist zu lang; richtig sind höchstens %1 Zeichen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; one like #1e90ff is right</source>
        <translation>„%1“ ist keine Farbe; richtig ist eine wie #1e90ff</translation>
    </message>
    <message>
        <source>it is wider than the square</source>
        <translation>er ist breiter als das Quadrat</translation>
    </message>
    <message>
        <source>x and y from %1 to %2 m are right</source>
        <translation>richtig sind x und y von %1 bis %2 m</translation>
    </message>
    <message>
        <source>circle %1 at (%2, %3) m is not inside the square, whose walls reflect; %4</source>
        <translation>Kreis %1 bei (%2, %3) m liegt nicht im Quadrat, dessen Wände reflektieren; %4</translation>
    </message>
    <message>
        <source>circles %1 and %2 overlap: their centres are %3 m apart; at least r₁ + r₂ = %4 m is right</source>
        <translation>Kreise %1 und %2 überlappen: Ihre Mittelpunkte sind %3 m auseinander; richtig ist mindestens r₁ + r₂ = %4 m</translation>
    </message>
    <message>
        <source>at most %1 circles are right</source>
        <translation>richtig sind höchstens %1 Kreise</translation>
    </message>
    <message>
        <source>%1 is out of range; a number from %2 to %3 is right</source>
        <translation>%1 liegt außerhalb des Bereichs; richtig ist eine Zahl von %2 bis %3</translation>
    </message>
</context>
<context>
    <name>Progress</name>
    <message>
        <source>your progress could not be saved: %1</source>
        <translation>dein Fortschritt konnte nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>your progress could not be read (%2) and was moved to %1; Cradle begins anew</source>
        <translation>dein Fortschritt konnte nicht gelesen werden (%2) und liegt jetzt in %1; Cradle beginnt von vorn</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Return</source>
        <translation>Eingabe</translation>
    </message>
</context>
<context>
    <name>Questions</name>
    <message>
        <source>“%1” is no number; one like 0.75 is asked for</source>
        <translation>„%1“ ist keine Zahl; gefragt ist eine wie 0.75</translation>
    </message>
    <message>
        <source>“%1” is no number with a unit; one like 3.2 kg is asked for</source>
        <translation>„%1“ ist keine Zahl mit Einheit; gefragt ist eine wie 3.2 kg</translation>
    </message>
    <message>
        <source>“%1” is no unit that is known</source>
        <translation>„%1“ ist keine bekannte Einheit</translation>
    </message>
    <message>
        <source>the number is right; its unit is missing</source>
        <translation>die Zahl stimmt; ihre Einheit fehlt</translation>
    </message>
    <message>
        <source>%1 is not right, and its unit is missing</source>
        <translation>%1 stimmt nicht, und die Einheit fehlt</translation>
    </message>
    <message>
        <source>the number is right, but not its unit: what is asked for is not measured in %1</source>
        <translation>die Zahl stimmt, aber nicht ihre Einheit: Wonach gefragt ist, wird nicht in %1 gemessen</translation>
    </message>
    <message>
        <source>%1 is not right: what is asked for is not measured in %2</source>
        <translation>%1 stimmt nicht: Wonach gefragt ist, wird nicht in %2 gemessen</translation>
    </message>
    <message>
        <source>the number is right, but not in %1</source>
        <translation>die Zahl stimmt, aber nicht in %1</translation>
    </message>
    <message>
        <source>%1 is not right</source>
        <translation>%1 stimmt nicht</translation>
    </message>
    <message>
        <source>one that is chosen is not right, and a right one is missing</source>
        <translation>eine gewählte Antwort stimmt nicht, und eine richtige fehlt</translation>
    </message>
    <message>
        <source>one that is chosen is not right</source>
        <translation>eine gewählte Antwort stimmt nicht</translation>
    </message>
    <message>
        <source>all that is chosen is right, but not all that is right is chosen</source>
        <translation>alles Gewählte stimmt, aber nicht alles Richtige ist gewählt</translation>
    </message>
    <message>
        <source>not all of them are in the order</source>
        <translation>es sind nicht alle in der Reihenfolge</translation>
    </message>
    <message>
        <source>it does not begin with what is first</source>
        <translation>sie beginnt nicht mit dem Ersten</translation>
    </message>
    <message>
        <source>the order is right up to number %1, and not behind it</source>
        <translation>die Reihenfolge stimmt bis Nummer %1 und dahinter nicht</translation>
    </message>
    <message>
        <source>the answer that is chosen is not right</source>
        <translation>die gewählte Antwort stimmt nicht</translation>
    </message>
    <message>
        <source>not answered yet</source>
        <translation>noch nicht beantwortet</translation>
    </message>
    <message>
        <source>for the teacher to read, who may give up to %1 points: %2</source>
        <translation>liest die Lehrkraft, die bis zu %1 Punkte geben kann: %2</translation>
    </message>
    <message>
        <source>a list of two to eight answers is right</source>
        <translation>richtig ist eine Liste von zwei bis acht Antworten</translation>
    </message>
    <message>
        <source>the right answers by their numbers from 1 are missing</source>
        <translation>es fehlen die richtigen Antworten mit ihren Nummern ab 1</translation>
    </message>
    <message>
        <source>a number from 1 to %1, for there are so many answers, is right</source>
        <translation>eine Zahl von 1 bis %1 ist richtig, denn so viele Antworten gibt es</translation>
    </message>
    <message>
        <source>one right answer; for more of them the kind is several</source>
        <translation>eine richtige Antwort; für mehrere ist die Art several</translation>
    </message>
    <message>
        <source>%1 is no unit; one like m/s, kg m/s, N s, J, ° or % is right</source>
        <translation>%1 ist keine Einheit; richtig ist eine wie m/s, kg m/s, N s, J, ° oder %</translation>
    </message>
    <message>
        <source>another check or question has the id %1 already; an id of its own is right</source>
        <translation>eine andere Prüfung oder Frage hat schon die Kennung %1; richtig ist eine eigene</translation>
    </message>
    <message>
        <source>the right number is missing</source>
        <translation>die richtige Zahl fehlt</translation>
    </message>
    <message>
        <source>Tolerance: a number from 0 is right</source>
        <translation>Toleranz: Richtig ist eine Zahl ab 0</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>in the scene: %1</source>
        <translation>in der Szene: %1</translation>
    </message>
    <message>
        <source>%1 passed</source>
        <translation>%1 bestanden</translation>
    </message>
    <message>
        <source>in step %1, at %2 s</source>
        <translation>in Schritt %1, bei %2 s</translation>
    </message>
    <message>
        <source>with %1</source>
        <translation>mit %1</translation>
    </message>
    <message>
        <source>Commit message: %1</source>
        <translation>Commit-Nachricht: %1</translation>
    </message>
    <message>
        <source>last assigned in that step by %1:%2</source>
        <translation>in diesem Schritt zuletzt zugewiesen von %1:%2</translation>
    </message>
    <message>
        <source>%1 did not pass: the program stopped</source>
        <translation>%1 nicht bestanden: Das Programm brach ab</translation>
    </message>
    <message>
        <source>%1 did not pass: the program stopped before its first step</source>
        <translation>%1 nicht bestanden: Das Programm brach vor seinem ersten Zeitschritt ab</translation>
    </message>
    <message>
        <source>%1 did not pass: the program does not load</source>
        <translation>%1 nicht bestanden: Das Programm lässt sich nicht laden</translation>
    </message>
    <message>
        <source>%1 did not pass: %2 of %3 checks failed</source>
        <translation>%1 nicht bestanden: %2 von %3 Prüfungen nicht bestanden</translation>
    </message>
    <message>
        <source>%1 (%2 of %3 points)</source>
        <translation>%1 (%2 von %3 Punkten)</translation>
    </message>
    <message>
        <source>The program moved the circles.</source>
        <translation>Das Programm hat die Kreise bewegt.</translation>
    </message>
    <message>
        <source>The laws of the scene moved the circles.</source>
        <translation>Die Gesetze der Szene haben die Kreise bewegt.</translation>
    </message>
    <message>
        <source>Look at %1:%2</source>
        <translation>Sieh dir %1:%2 an</translation>
    </message>
    <message>
        <source>%1 did not pass: %2 of %3 checks and answers failed</source>
        <translation>%1 nicht bestanden: %2 von %3 Prüfungen und Antworten schlugen fehl</translation>
    </message>
</context>
<context>
    <name>ReportPrinter</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>ResultPane</name>
    <message>
        <source>%1: %2</source>
        <comment>place, message</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The program cannot be read</source>
        <translation>Das Programm lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>The program takes too long</source>
        <translation>Das Programm braucht zu lange</translation>
    </message>
    <message>
        <source>The program needs too much memory</source>
        <translation>Das Programm braucht zu viel Speicher</translation>
    </message>
    <message>
        <source>The program stopped</source>
        <translation>Das Programm brach ab</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>in step %1, at %2 s</source>
        <translation>in Schritt %1, bei %2 s</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Nicht beurteilt</translation>
    </message>
</context>
<context>
    <name>RunDifference</name>
    <message>
        <source>circle %1</source>
        <translation>Kreis %1</translation>
    </message>
    <message>
        <source>laws → program</source>
        <translation>Gesetze → Programm</translation>
    </message>
    <message>
        <source>program → laws</source>
        <translation>Programm → Gesetze</translation>
    </message>
    <message>
        <source>program changed</source>
        <translation>Programm geändert</translation>
    </message>
    <message>
        <source>half width</source>
        <translation>halbe Breite</translation>
    </message>
    <message>
        <source>timing</source>
        <translation>Zeitführung</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>circles</source>
        <translation>Kreise</translation>
    </message>
    <message>
        <source>%1 → %2 circles</source>
        <translation>%1 → %2 Kreise</translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
</context>
<context>
    <name>SceneTemplates</name>
    <message>
        <source>Head-on collision</source>
        <translation>Gerader Stoß</translation>
    </message>
    <message>
        <source>Glancing collision</source>
        <translation>Schräger Stoß</translation>
    </message>
    <message>
        <source>Newton&apos;s cradle</source>
        <translation>Kugelstoßpendel</translation>
    </message>
    <message>
        <source>Gas</source>
        <translation>Gas</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Freier Fall</translation>
    </message>
</context>
<context>
    <name>Schema</name>
    <message numerus="yes">
        <source>a list of %n value(s)</source>
        <translation>
            <numerusform>eine Liste mit %n Wert</numerusform>
            <numerusform>eine Liste mit %n Werten</numerusform>
        </translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;; the keys here are %2</source>
        <translation>unbekannter Schlüssel „%1“; die Schlüssel hier sind %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing</source>
        <translation>„%1“ fehlt</translation>
    </message>
    <message>
        <source>%1 is not right here; right would be %2</source>
        <translation>%1 ist hier nicht richtig; richtig wäre %2</translation>
    </message>
    <message>
        <source>this is not JSON: %1</source>
        <translation>das ist kein JSON: %1</translation>
    </message>
    <message>
        <source>this is a folder; a file is right</source>
        <translation>das ist ein Ordner; richtig ist eine Datei</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>the file is too large; at most %1 are right</source>
        <translation>die Datei ist zu groß; richtig sind höchstens %1</translation>
    </message>
    <message>
        <source>1, the format that this version reads</source>
        <translation>1, das Format, das diese Version liest</translation>
    </message>
    <message>
        <source>a circle number from 1</source>
        <translation>eine Kreisnummer ab 1</translation>
    </message>
    <message>
        <source>a colour like #1e90ff</source>
        <translation>eine Farbe wie #1e90ff</translation>
    </message>
    <message>
        <source>a language code like en or de</source>
        <translation>ein Sprachkürzel wie en oder de</translation>
    </message>
    <message>
        <source>a list of checks</source>
        <translation>eine Liste von Prüfungen</translation>
    </message>
    <message>
        <source>a list of circle numbers from 1</source>
        <translation>eine Liste von Kreisnummern ab 1</translation>
    </message>
    <message>
        <source>a list of circles, or an object with fill</source>
        <translation>eine Liste von Kreisen oder ein Objekt mit fill</translation>
    </message>
    <message>
        <source>a list of folder names, in order</source>
        <translation>eine Liste von Ordnernamen, der Reihe nach</translation>
    </message>
    <message>
        <source>a list of texts</source>
        <translation>eine Liste von Texten</translation>
    </message>
    <message>
        <source>a number in m from -10000 to 10000</source>
        <translation>eine Zahl in m von -10000 bis 10000</translation>
    </message>
    <message>
        <source>a number in m/s from -1e7 to 1e7</source>
        <translation>eine Zahl in m/s von -1e7 bis 1e7</translation>
    </message>
    <message>
        <source>a number in m/s² from -10000 to 10000</source>
        <translation>eine Zahl in m/s² von -10000 bis 10000</translation>
    </message>
    <message>
        <source>a text of at most 200 characters</source>
        <translation>ein Text mit höchstens 200 Zeichen</translation>
    </message>
    <message>
        <source>a text of at most 2000 characters</source>
        <translation>ein Text mit höchstens 2000 Zeichen</translation>
    </message>
    <message>
        <source>a whole number from 0 to 2147483647</source>
        <translation>eine ganze Zahl von 0 bis 2147483647</translation>
    </message>
    <message>
        <source>an object that says which scenes the check runs: kind, count, duration, timesteps and what they vary</source>
        <translation>ein Objekt, das sagt, welche Szenen die Prüfung laufen lässt: kind, count, duration, timesteps und was sie verändern</translation>
    </message>
    <message>
        <source>an object with count and radius, and if wanted rms_speed, density, seed</source>
        <translation>ein Objekt mit count und radius und nach Wunsch rms_speed, density, seed</translation>
    </message>
    <message>
        <source>an object with format, name, square, gravity, restitution, timestep, laws and circles</source>
        <translation>ein Objekt mit format, name, square, gravity, restitution, timestep, laws und circles</translation>
    </message>
    <message>
        <source>an object with half_width</source>
        <translation>ein Objekt mit half_width</translation>
    </message>
    <message>
        <source>an object with position, and if wanted name, velocity, radius, density, colour, integrator</source>
        <translation>ein Objekt mit position und nach Wunsch name, velocity, radius, density, colour, integrator</translation>
    </message>
    <message>
        <source>an object with the parameters of the kind</source>
        <translation>ein Objekt mit den Parametern der Art</translation>
    </message>
    <message>
        <source>an object with the titles of the checks by their id</source>
        <translation>ein Objekt mit den Titeln der Prüfungen nach ihrer id</translation>
    </message>
    <message>
        <source>an object with walls, circles and timing</source>
        <translation>ein Objekt mit walls, circles und timing</translation>
    </message>
    <message>
        <source>half the side of the square in m, a number from 1e-6 to 10000</source>
        <translation>die halbe Seite des Quadrats in m, eine Zahl von 1e-6 bis 10000</translation>
    </message>
    <message>
        <source>how many circles, a whole number from 1 to 100000</source>
        <translation>wie viele Kreise, eine ganze Zahl von 1 bis 100000</translation>
    </message>
    <message>
        <source>one of discrete, continuous, exact</source>
        <translation>eines von discrete, continuous, exact</translation>
    </message>
    <message>
        <source>one of euler, symplectic_euler, verlet, rk4</source>
        <translation>eines von euler, symplectic_euler, verlet, rk4</translation>
    </message>
    <message>
        <source>one of none, reflect</source>
        <translation>eines von none, reflect</translation>
    </message>
    <message>
        <source>one of none, stop, swap_velocities, swap_normal, impulse</source>
        <translation>eines von none, stop, swap_velocities, swap_normal, impulse</translation>
    </message>
    <message>
        <source>the coefficient of restitution e, a number from 0 to 1</source>
        <translation>die Stoßzahl e, eine Zahl von 0 bis 1</translation>
    </message>
    <message>
        <source>the density in 1000 kg/m³, a number from 1e-9 to 1e9</source>
        <translation>die Dichte in 1000 kg/m³, eine Zahl von 1e-9 bis 1e9</translation>
    </message>
    <message>
        <source>the name of a file beside task.json</source>
        <translation>der Name einer Datei neben task.json</translation>
    </message>
    <message>
        <source>the name of a folder beside lab.json: letters, digits, dashes and underscores</source>
        <translation>der Name eines Ordners neben lab.json: Buchstaben, Ziffern, Binde- und Unterstriche</translation>
    </message>
    <message>
        <source>the name of a kind of check</source>
        <translation>der Name einer Art von Prüfung</translation>
    </message>
    <message>
        <source>the radius in m, a number from 1e-6 to 10000</source>
        <translation>der Radius in m, eine Zahl von 1e-6 bis 10000</translation>
    </message>
    <message>
        <source>the root mean square speed in m/s, a number from 0 to 1e6</source>
        <translation>das quadratisch gemittelte Tempo in m/s, eine Zahl von 0 bis 1e6</translation>
    </message>
    <message>
        <source>the timestep in s, a number from 1e-6 to 0.1</source>
        <translation>der Zeitschritt in s, eine Zahl von 1e-6 bis 0.1</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>two numbers [x, y] in m, each from -10000 to 10000</source>
        <translation>zwei Zahlen [x, y] in m, jede von -10000 bis 10000</translation>
    </message>
    <message>
        <source>two numbers [x, y] in m/s, each from -1e7 to 1e7</source>
        <translation>zwei Zahlen [x, y] in m/s, jede von -1e7 bis 1e7</translation>
    </message>
    <message>
        <source>two numbers [x, y] in m/s², each from -10000 to 10000</source>
        <translation>zwei Zahlen [x, y] in m/s², jede von -10000 bis 10000</translation>
    </message>
    <message>
        <source>a list of remarks</source>
        <translation>eine Liste von Anmerkungen</translation>
    </message>
    <message>
        <source>an object with id, compare and scene</source>
        <translation>ein Objekt mit id, compare und scene</translation>
    </message>
    <message>
        <source>an object with the texts of the mistakes by their name</source>
        <translation>ein Objekt mit den Texten der Fehler nach ihrem Namen</translation>
    </message>
    <message>
        <source>an object with the texts of the remarks by their name</source>
        <translation>ein Objekt mit den Texten der Anmerkungen nach ihrem Namen</translation>
    </message>
    <message>
        <source>one of velocities, positions, fields</source>
        <translation>eines von velocities, positions, fields</translation>
    </message>
    <message>
        <source>needs a newer Cradle: format %1, this one reads %2</source>
        <translation>braucht ein neueres Cradle: Format %1, dieses liest %2</translation>
    </message>
    <message>
        <source>a list of two to four answers</source>
        <translation>eine Liste von zwei bis vier Antworten</translation>
    </message>
    <message>
        <source>a text of 1 to 100 characters</source>
        <translation>ein Text von 1 bis 100 Zeichen</translation>
    </message>
    <message>
        <source>a text of 1 to 400 characters</source>
        <translation>ein Text von 1 bis 400 Zeichen</translation>
    </message>
    <message>
        <source>a text of 1 to 1000 characters</source>
        <translation>ein Text von 1 bis 1000 Zeichen</translation>
    </message>
    <message>
        <source>an object with id, kind, title, points, parameters and scene</source>
        <translation>ein Objekt mit id, kind, title, points, parameters und scene</translation>
    </message>
    <message>
        <source>an object with question, answers, right and outcome</source>
        <translation>ein Objekt mit question, answers, right und outcome</translation>
    </message>
    <message>
        <source>an object with question, answers and outcome</source>
        <translation>ein Objekt mit question, answers und outcome</translation>
    </message>
    <message>
        <source>the number of the answer that comes true, from 1</source>
        <translation>die Nummer der Antwort, die zutrifft, ab 1</translation>
    </message>
    <message>
        <source>what passing the check is worth, a number from 0 to 1000</source>
        <translation>was das Bestehen der Prüfung wert ist, eine Zahl von 0 bis 1000</translation>
    </message>
    <message>
        <source>a list of fields of the scene that the student may not change</source>
        <translation>eine Liste von Feldern der Szene, die nicht geändert werden dürfen</translation>
    </message>
    <message>
        <source>a field as gravity, restitution, timestep, half_width, circles, laws/walls, laws/circles, laws/timing or circles/1/velocity</source>
        <translation>ein Feld wie gravity, restitution, timestep, half_width, circles, laws/walls, laws/circles, laws/timing oder circles/1/velocity</translation>
    </message>
    <message>
        <source>one of program, laws, either</source>
        <translation>eines von program, laws, either</translation>
    </message>
    <message>
        <source>what the step is worth, a number from 0 to 1000</source>
        <translation>was der Schritt wert ist, eine Zahl von 0 bis 1000</translation>
    </message>
    <message>
        <source>a list of questions</source>
        <translation>eine Liste von Fragen</translation>
    </message>
    <message>
        <source>a list of two to eight answers</source>
        <translation>eine Liste von zwei bis acht Antworten</translation>
    </message>
    <message>
        <source>a number or an expression, the number of an answer from 1, or a list of such numbers</source>
        <translation>eine Zahl oder ein Ausdruck, die Nummer einer Antwort ab 1 oder eine Liste solcher Nummern</translation>
    </message>
    <message>
        <source>a number, an expression like 2*k, or an object with from, to and step</source>
        <translation>eine Zahl, ein Ausdruck wie 2*k oder ein Objekt mit from, to und step</translation>
    </message>
    <message>
        <source>a text of 1 to 200 characters</source>
        <translation>ein Text von 1 bis 200 Zeichen</translation>
    </message>
    <message>
        <source>a text of at most 200 characters; another draws other values</source>
        <translation>ein Text von höchstens 200 Zeichen; ein anderer zieht andere Werte</translation>
    </message>
    <message>
        <source>of an edition for students: the SHA-256 of the lab that it is of</source>
        <translation>einer Ausgabe für Studierende: die SHA-256 des Labs, von dem sie ist</translation>
    </message>
    <message>
        <source>a unit like m/s of at most 40 characters</source>
        <translation>eine Einheit wie m/s von höchstens 40 Zeichen</translation>
    </message>
    <message>
        <source>an object with format, id, title, commit, preset, hints, code_hints, prediction, remarks, checks, questions, values, moves, extra and locked</source>
        <translation>ein Objekt mit format, id, title, commit, preset, hints, code_hints, prediction, remarks, checks, questions, values, moves, extra und locked</translation>
    </message>
    <message>
        <source>an object with format, id, title, version, language, values, draw and steps</source>
        <translation>ein Objekt mit format, id, title, version, language, values, draw und steps</translation>
    </message>
    <message>
        <source>an object with id, kind, title, text, answers, right, unit, tolerance and points</source>
        <translation>ein Objekt mit id, kind, title, text, answers, right, unit, tolerance und points</translation>
    </message>
    <message>
        <source>an object with numbers, expressions, or ranges with from, to and step, by their names</source>
        <translation>ein Objekt mit Zahlen, Ausdrücken oder Bereichen mit from, to und step, nach ihren Namen</translation>
    </message>
    <message>
        <source>an object with the texts of the questions by their id</source>
        <translation>ein Objekt mit den Texten der Fragen nach ihrer Kennung</translation>
    </message>
    <message>
        <source>an object with title, hints, code_hints, prediction, checks, questions, mistakes and remarks</source>
        <translation>ein Objekt mit title, hints, code_hints, prediction, checks, questions, mistakes und remarks</translation>
    </message>
    <message>
        <source>an object with title, text and answers</source>
        <translation>ein Objekt mit title, text und answers</translation>
    </message>
    <message>
        <source>from one to the next, a number greater than 0</source>
        <translation>von einem zum nächsten, eine Zahl größer als 0</translation>
    </message>
    <message>
        <source>one of number, one, several, order, text</source>
        <translation>eines von number, one, several, order, text</translation>
    </message>
    <message>
        <source>the least, a number</source>
        <translation>das Kleinste, eine Zahl</translation>
    </message>
    <message>
        <source>the most, a number</source>
        <translation>das Größte, eine Zahl</translation>
    </message>
    <message>
        <source>the number of an answer, from 1</source>
        <translation>die Nummer einer Antwort, ab 1</translation>
    </message>
    <message>
        <source>what a right answer is worth, a number from 0 to 1000</source>
        <translation>was eine richtige Antwort wert ist, eine Zahl von 0 bis 1000</translation>
    </message>
    <message>
        <source>how far off is still right, a number from 0 or an expression</source>
        <translation>welche Abweichung noch richtig ist, eine Zahl ab 0 oder ein Ausdruck</translation>
    </message>
    <message>
        <source>a short name of letters, digits, dots, dashes and underscores</source>
        <translation>ein kurzer Name aus Buchstaben, Ziffern, Punkten, Binde- und Unterstrichen</translation>
    </message>
    <message>
        <source>an object with format and labs</source>
        <translation>ein Objekt mit format und labs</translation>
    </message>
    <message>
        <source>an object with the progress in each lab by its id</source>
        <translation>ein Objekt mit dem Fortschritt in jedem Lab nach dessen Kennung</translation>
    </message>
</context>
<context>
    <name>Script</name>
    <message>
        <source>%1 has no field %2; a field has a name</source>
        <translation>%1 hat kein Feld %2; ein Feld hat einen Namen</translation>
    </message>
    <message>
        <source>%1 has no field `%2`: did you mean `%3`?</source>
        <translation>%1 hat kein Feld `%2`: Meintest du `%3`?</translation>
    </message>
    <message>
        <source>%1 has no field `%2`; it has %3. A field of your own must be set before it is read: %1.%2 = …</source>
        <translation>%1 hat kein Feld `%2`, nur %3. Ein eigenes Feld muss gesetzt werden, bevor es gelesen wird: %1.%2 = …</translation>
    </message>
    <message>
        <source>%1 must be a vector, not %2; write vec(x, y)</source>
        <translation>%1 muss ein Vektor sein, nicht %2; schreib vec(x, y)</translation>
    </message>
    <message>
        <source>%1 would be %2; every number of a circle must be finite. Look for a division by zero, or for a value that grows in every step</source>
        <translation>%1 wäre %2; jede Zahl eines Kreises muss endlich sein. Such nach einer Division durch null oder nach einem Wert, der in jedem Schritt wächst</translation>
    </message>
    <message>
        <source>%1 must be a number, not %2</source>
        <translation>%1 muss eine Zahl sein, nicht %2</translation>
    </message>
    <message>
        <source>%1 would be %2; it must be finite and above 0</source>
        <translation>%1 wäre %2; es muss endlich und über 0 sein</translation>
    </message>
    <message>
        <source>%1.index is given and cannot be changed</source>
        <translation>%1.index ist gegeben und lässt sich nicht ändern</translation>
    </message>
    <message>
        <source>circles[i] takes a number from 1 to %1, not %2</source>
        <translation>circles[i] nimmt eine Zahl von 1 bis %1, nicht %2</translation>
    </message>
    <message>
        <source>circles cannot be added or removed by a program; set the position and velocity of those that are there</source>
        <translation>ein Programm kann keine Kreise hinzufügen oder entfernen; setze Ort und Geschwindigkeit derer, die da sind</translation>
    </message>
    <message>
        <source>this value</source>
        <translation>dieser Wert</translation>
    </message>
    <message>
        <source>%1 is %2, so it has no fields</source>
        <translation>%1 ist %2, hat also keine Felder</translation>
    </message>
    <message>
        <source>%1 is %2, not a function that can be called</source>
        <translation>%1 ist %2, keine Funktion, die sich aufrufen lässt</translation>
    </message>
    <message>
        <source>%1 is %2, not a number to calculate with</source>
        <translation>%1 ist %2, keine Zahl zum Rechnen</translation>
    </message>
    <message>
        <source>%1; only numbers compare with numbers (the length of a vector is v:length())</source>
        <translation>%1; nur Zahlen lassen sich mit Zahlen vergleichen (die Länge eines Vektors ist v:length())</translation>
    </message>
    <message>
        <source>a function calls itself without end (stack overflow)</source>
        <translation>eine Funktion ruft sich endlos selbst auf (stack overflow)</translation>
    </message>
    <message>
        <source>the program needs more than %1 MiB of memory; is there a table or a text that grows without end?</source>
        <translation>das Programm braucht mehr als %1 MiB Speicher; gibt es eine Tabelle oder einen Text, der endlos wächst?</translation>
    </message>
    <message>
        <source>the program called error with %1</source>
        <translation>das Programm rief error auf; übergeben wurde %1</translation>
    </message>
    <message>
        <source>`%1.%2` is not part of the lab&apos;s Lua; %1 has %3</source>
        <translation>`%1.%2` gehört nicht zum Lua des Labs; %1 hat %3</translation>
    </message>
    <message>
        <source>%1 has no `%2`; it has %3</source>
        <translation>%1 hat kein `%2`, nur %3</translation>
    </message>
    <message>
        <source>%1 has no `%2`: did you mean `%1.%3`?</source>
        <translation>%1 hat kein `%2`: Meintest du `%1.%3`?</translation>
    </message>
    <message>
        <source>pairs goes through a table or circles, not %1</source>
        <translation>pairs geht durch eine Tabelle oder circles; hier steht %1</translation>
    </message>
    <message>
        <source>this step has run for more than %1 s; is there a loop that does not end?</source>
        <translation>dieser Schritt läuft schon mehr als %1 s; gibt es eine Schleife, die nicht endet?</translation>
    </message>
    <message>
        <source>this step takes more than %1 million instructions; is there a loop that does not end?</source>
        <translation>dieser Schritt braucht mehr als %1 Millionen Befehle; gibt es eine Schleife, die nicht endet?</translation>
    </message>
    <message>
        <source>the run was stopped</source>
        <translation>der Lauf wurde abgebrochen</translation>
    </message>
    <message>
        <source>functions call each other %1 deep; does one call itself without end?</source>
        <translation>Funktionen rufen einander %1 Ebenen tief auf; ruft sich eine endlos selbst auf?</translation>
    </message>
    <message>
        <source>the program has %1 letters; at most %2 are right</source>
        <translation>das Programm hat %1 Zeichen; richtig sind höchstens %2</translation>
    </message>
    <message>
        <source>there is no memory to run a program</source>
        <translation>für ein Programm ist kein Speicher da</translation>
    </message>
    <message>
        <source>the program shows more than %1 KiB in one step</source>
        <translation>das Programm zeigt in einem Schritt mehr als %1 KiB</translation>
    </message>
    <message>
        <source>%1 must be a text, not %2</source>
        <translation>%1 muss ein Text sein; hier steht %2</translation>
    </message>
    <message>
        <source>the name in plot(name, number)</source>
        <translation>der Name in plot(name, number)</translation>
    </message>
    <message>
        <source>the name in plot(name, number) must have 1 to %1 letters</source>
        <translation>der Name in plot(name, number) muss 1 bis %1 Zeichen haben</translation>
    </message>
    <message>
        <source>plot(name, number) takes a number, not %1</source>
        <translation>plot(name, number) nimmt eine Zahl; hier steht %1</translation>
    </message>
    <message>
        <source>plot(&quot;%1&quot;, …) would be %2; a finite number is right</source>
        <translation>plot(&quot;%1&quot;, …) wäre %2; richtig ist eine endliche Zahl</translation>
    </message>
    <message>
        <source>%1 would draw at %2; finite numbers are right</source>
        <translation>%1 würde bei %2 zeichnen; richtig sind endliche Zahlen</translation>
    </message>
    <message>
        <source>%1 would end beyond all numbers</source>
        <translation>%1 würde jenseits aller Zahlen enden</translation>
    </message>
    <message>
        <source>a colour</source>
        <translation>eine Farbe</translation>
    </message>
    <message>
        <source>a label</source>
        <translation>eine Beschriftung</translation>
    </message>
    <message>
        <source>the text in draw.text(p, text)</source>
        <translation>der Text in draw.text(p, text)</translation>
    </message>
    <message>
        <source>draw has no `%1`; it has %2</source>
        <translation>draw hat kein `%1`, nur %2</translation>
    </message>
    <message>
        <source>draw has no `%1`: did you mean `%2`?</source>
        <translation>draw hat kein `%1`: Meintest du `%2`?</translation>
    </message>
    <message>
        <source>after on_load the scene cannot be run: %1</source>
        <translation>nach on_load kann die Szene nicht laufen: %1</translation>
    </message>
    <message>
        <source>`on_update` is no function any more; it is given once: function on_update(timestep) … end</source>
        <translation>`on_update` ist keine Funktion mehr; sie steht nur einmal da: function on_update(timestep) … end</translation>
    </message>
    <message>
        <source>the vector %1</source>
        <translation>der Vektor %1</translation>
    </message>
    <message>
        <source>the number %1</source>
        <translation>die Zahl %1</translation>
    </message>
    <message>
        <source>the text %1</source>
        <translation>der Text %1</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>eine Tabelle</translation>
    </message>
    <message>
        <source>a function</source>
        <translation>eine Funktion</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>%1 %2 %3 has no meaning: %4</source>
        <translation>%1 %2 %3 ergibt keinen Sinn: %4</translation>
    </message>
    <message>
        <source>a vector is added to a vector</source>
        <translation>zu einem Vektor wird ein Vektor addiert</translation>
    </message>
    <message>
        <source>a vector is taken from a vector</source>
        <translation>von einem Vektor wird ein Vektor abgezogen</translation>
    </message>
    <message>
        <source>a vector is multiplied by a number; for the dot product write a:dot(b)</source>
        <translation>ein Vektor wird mit einer Zahl multipliziert; für das Skalarprodukt schreib a:dot(b)</translation>
    </message>
    <message>
        <source>a vector is divided by a number</source>
        <translation>ein Vektor wird durch eine Zahl geteilt</translation>
    </message>
    <message>
        <source>a vector has no `%1`; it has %2</source>
        <translation>ein Vektor hat kein `%1`, nur %2</translation>
    </message>
    <message>
        <source>a vector has no `%1`: did you mean `%2`?</source>
        <translation>ein Vektor hat kein `%1`: Meintest du `%2`?</translation>
    </message>
    <message>
        <source>a vector cannot be changed; build a new one: %1 = %2</source>
        <translation>ein Vektor lässt sich nicht ändern; bilde einen neuen: %1 = %2</translation>
    </message>
    <message>
        <source>`%1` belongs to a vector; write v:%1(), with a colon</source>
        <translation>`%1` gehört zu einem Vektor; schreib v:%1(), mit Doppelpunkt</translation>
    </message>
    <message>
        <source>the vector (0, 0) has no direction, so it cannot be normalized</source>
        <translation>der Vektor (0, 0) hat keine Richtung, also lässt er sich nicht normieren</translation>
    </message>
    <message>
        <source>vec(x, y) takes two numbers; %1 is %2</source>
        <translation>vec(x, y) nimmt zwei Zahlen; %1 ist %2</translation>
    </message>
    <message>
        <source>vec(x, y) takes two numbers, not %1</source>
        <translation>vec(x, y) nimmt zwei Zahlen, nicht %1</translation>
    </message>
    <message>
        <source>%1 needs a vector, not %2</source>
        <translation>%1 braucht einen Vektor; hier steht %2</translation>
    </message>
    <message>
        <source>dot got one vector and takes two: write a:dot(b) with a colon, or dot(a, b)</source>
        <translation>dot bekam einen Vektor und braucht zwei: Schreib a:dot(b) mit einem Doppelpunkt oder dot(a, b)</translation>
    </message>
    <message>
        <source>there is no %1: the scene has %2 circles</source>
        <translation>%1 gibt es nicht: Die Szene hat %2 Kreise</translation>
    </message>
    <message>
        <source>`%1` is not known: did you mean `%2`?</source>
        <translation>`%1` ist nicht bekannt: Meintest du `%2`?</translation>
    </message>
    <message>
        <source>`%1` is not known: nothing of that name was given a value before</source>
        <translation>`%1` ist nicht bekannt: Nichts mit diesem Namen hat bisher einen Wert bekommen</translation>
    </message>
    <message>
        <source>`%1` is set once, in on_load; in on_update it can only be read</source>
        <translation>`%1` wird einmal gesetzt, in on_load; in on_update lässt es sich nur lesen</translation>
    </message>
    <message>
        <source>gravity would be %1 m/s²; at most %2 is right</source>
        <translation>gravity wäre %1 m/s²; richtig ist höchstens %2</translation>
    </message>
    <message>
        <source>restitution must be a number from 0 to 1, not %1</source>
        <translation>restitution muss eine Zahl von 0 bis 1 sein, nicht %1</translation>
    </message>
    <message>
        <source>`%1` can only be read; choose another name for a variable of your own</source>
        <translation>`%1` lässt sich nur lesen; wähle für eine eigene Variable einen anderen Namen</translation>
    </message>
    <message>
        <source>`%1` must be a function, not %2</source>
        <translation>`%1` muss eine Funktion sein, nicht %2</translation>
    </message>
    <message>
        <source>square has no `%1`; it has %2</source>
        <translation>square hat kein `%1`, nur %2</translation>
    </message>
    <message>
        <source>square has no `%1`: did you mean `%2`?</source>
        <translation>square hat kein `%1`: Meintest du `%2`?</translation>
    </message>
    <message>
        <source>the square can only be read</source>
        <translation>square lässt sich nur lesen</translation>
    </message>
    <message>
        <source>this is no text, so it is no program</source>
        <translation>das ist kein Text, also kein Programm</translation>
    </message>
    <message>
        <source>`%1` is local here, so nobody can call it; write function %1(…) without local</source>
        <translation>`%1` ist hier local, also kann niemand es aufrufen; schreib function %1(…) ohne local</translation>
    </message>
    <message>
        <source>Lua has no %2=; write %1 = %1 %2 %3</source>
        <translation>Lua hat kein %2=; schreib %1 = %1 %2 %3</translation>
    </message>
    <message>
        <source>&quot;not equal&quot; is ~= in Lua, not !=</source>
        <translation>„ungleich“ ist in Lua ~=, nicht !=</translation>
    </message>
    <message>
        <source>Lua has no ++; write %1 = %1 + 1</source>
        <translation>Lua hat kein ++; schreib %1 = %1 + 1</translation>
    </message>
    <message>
        <source>a comment begins with -- in Lua</source>
        <translation>ein Kommentar beginnt in Lua mit --</translation>
    </message>
    <message>
        <source>Lua writes `and`, `or`, `not` in words</source>
        <translation>Lua schreibt `and`, `or`, `not` als Wörter</translation>
    </message>
    <message>
        <source>= assigns; to compare write ==</source>
        <translation>= weist zu; zum Vergleichen schreib ==</translation>
    </message>
    <message>
        <source>== compares; to assign write =</source>
        <translation>== vergleicht; zum Zuweisen schreib =</translation>
    </message>
    <message>
        <source>names have the letters a to z, digits and _ only</source>
        <translation>Namen haben nur die Buchstaben a bis z, Ziffern und _</translation>
    </message>
    <message>
        <source>`%1` is given by the lab and cannot be replaced; choose another name for a variable of your own</source>
        <translation>`%1` ist vom Lab gegeben und lässt sich nicht ersetzen; wähle für eine eigene Variable einen anderen Namen</translation>
    </message>
    <message>
        <source>there is no function check(run) … end</source>
        <translation>es gibt keine function check(run) … end</translation>
    </message>
    <message>
        <source>check(run) returned %1; true, or false and a message, is right</source>
        <translation>check(run) gab %1 zurück; richtig ist true, oder false und eine Meldung</translation>
    </message>
    <message>
        <source>check(run) returned false without a message for the student; return false, &quot;what is wrong&quot; is right</source>
        <translation>check(run) gab false ohne eine Meldung zurück; richtig ist return false, &quot;was falsch ist&quot;</translation>
    </message>
    <message>
        <source>there is no field `%1` here; there are %2</source>
        <translation>hier gibt es kein Feld `%1`; vorhanden sind %2</translation>
    </message>
    <message>
        <source>there is no field `%1` here: did you mean `%2`?</source>
        <translation>hier gibt es kein Feld `%1`: Meintest du `%2`?</translation>
    </message>
    <message>
        <source>write %1, with a colon</source>
        <translation>schreib %1, mit Doppelpunkt</translation>
    </message>
    <message>
        <source>the moment must be a number of seconds from 0 to %1, not %2</source>
        <translation>der Zeitpunkt muss eine Zahl von Sekunden von 0 bis %1 sein, nicht %2</translation>
    </message>
    <message>
        <source>this must be a whole number from %1 to %2, not %3</source>
        <translation>dies muss eine ganze Zahl von %1 bis %2 sein, nicht %3</translation>
    </message>
    <message>
        <source>the author of this step has fixed this: %1. It stays as the scene has it; take this line out</source>
        <translation>dieser Schritt legt das fest: %1. Es bleibt, wie die Szene es hat; nimm diese Zeile heraus</translation>
    </message>
    <message>
        <source>&apos;%1&apos; expected (to close &apos;%2&apos; at line %3) near %4</source>
        <translation>&apos;%1&apos; fehlt (es schließt &apos;%2&apos; aus Zeile %3) vor %4</translation>
    </message>
    <message>
        <source>%1 expected near %2</source>
        <translation>%1 fehlt bei %2</translation>
    </message>
    <message>
        <source>unexpected symbol near %1</source>
        <translation>unerwartetes Zeichen bei %1</translation>
    </message>
    <message>
        <source>syntax error near %1</source>
        <translation>Syntaxfehler bei %1</translation>
    </message>
    <message>
        <source>unfinished string near %1</source>
        <translation>ein Text endet nicht: %1</translation>
    </message>
    <message>
        <source>unfinished long string (starting at line %1)</source>
        <translation>ein langer Text, der in Zeile %1 beginnt, endet nicht</translation>
    </message>
    <message>
        <source>unfinished long comment (starting at line %1)</source>
        <translation>ein langer Kommentar, der in Zeile %1 beginnt, endet nicht</translation>
    </message>
    <message>
        <source>malformed number near %1</source>
        <translation>keine Zahl: %1</translation>
    </message>
    <message>
        <source>invalid escape sequence near %1</source>
        <translation>unbekanntes Zeichen nach \: %1</translation>
    </message>
    <message>
        <source>break outside loop at line %1</source>
        <translation>break außerhalb einer Schleife in Zeile %1</translation>
    </message>
    <message>
        <source>no visible label &apos;%1&apos; for goto at line %2</source>
        <translation>goto in Zeile %2 findet die Marke &apos;%1&apos; nicht</translation>
    </message>
    <message>
        <source>label &apos;%1&apos; already defined on line %2</source>
        <translation>die Marke &apos;%1&apos; gibt es schon in Zeile %2</translation>
    </message>
    <message>
        <source>attempt to assign to const variable &apos;%1&apos;</source>
        <translation>die Konstante &apos;%1&apos; lässt sich nicht ändern</translation>
    </message>
    <message>
        <source>attempt to compare two %1 values</source>
        <translation>zwei Werte der Art %1 lassen sich nicht vergleichen</translation>
    </message>
    <message>
        <source>attempt to compare %1 with %2</source>
        <translation>%1 lässt sich nicht mit %2 vergleichen</translation>
    </message>
    <message>
        <source>attempt to divide a whole number by zero</source>
        <translation>eine ganze Zahl wurde durch null geteilt</translation>
    </message>
    <message>
        <source>attempt to take the rest of a division by zero</source>
        <translation>der Rest einer Division durch null wurde verlangt</translation>
    </message>
    <message>
        <source>bad argument #%1 to &apos;%2&apos; (%3 expected, got %4)</source>
        <translation>falsches Argument Nr. %1 von &apos;%2&apos; (%3 erwartet, %4 bekommen)</translation>
    </message>
    <message>
        <source>bad argument #%1 to &apos;%2&apos; (number has no integer representation)</source>
        <translation>falsches Argument Nr. %1 von &apos;%2&apos; (die Zahl ist nicht ganz)</translation>
    </message>
    <message>
        <source>bad argument #%1 to &apos;%2&apos; (out of range)</source>
        <translation>falsches Argument Nr. %1 von &apos;%2&apos; (außerhalb des Bereichs)</translation>
    </message>
    <message>
        <source>number has no integer representation</source>
        <translation>die Zahl ist nicht ganz</translation>
    </message>
    <message>
        <source>the first value of &apos;for&apos; must be a number</source>
        <translation>der erste Wert von &apos;for&apos; muss eine Zahl sein</translation>
    </message>
    <message>
        <source>the last value of &apos;for&apos; must be a number</source>
        <translation>der letzte Wert von &apos;for&apos; muss eine Zahl sein</translation>
    </message>
    <message>
        <source>the step of &apos;for&apos; must be a number</source>
        <translation>die Schrittweite von &apos;for&apos; muss eine Zahl sein</translation>
    </message>
    <message>
        <source>the step of &apos;for&apos; is zero</source>
        <translation>die Schrittweite von &apos;for&apos; ist null</translation>
    </message>
    <message>
        <source>assertion failed!</source>
        <translation>assert ist fehlgeschlagen</translation>
    </message>
    <message>
        <source>&lt;eof&gt;</source>
        <extracomment>the end of the program</extracomment>
        <translation>dem Ende des Programms</translation>
    </message>
    <message>
        <source>&lt;name&gt;</source>
        <translation>ein Name</translation>
    </message>
    <message>
        <source>%1 is %2, so .. cannot join it to a text</source>
        <translation>%1 ist %2, also kann .. es nicht mit einem Text verbinden</translation>
    </message>
    <message>
        <source>%1 is %2, so it has no length</source>
        <translation>%1 ist %2, hat also keine Länge</translation>
    </message>
    <message>
        <source>there is no %1: the scene has 1 circle</source>
        <translation>%1 gibt es nicht: Die Szene hat 1 Kreis</translation>
    </message>
    <message>
        <source>pairs needs keys that have an order: numbers, texts, circles. Of tables, functions and equal vectors there may be one; keep them in a list and go through it with ipairs</source>
        <translation>pairs braucht Schlüssel, die eine Reihenfolge haben: Zahlen, Texte, Kreise. Von Tabellen, Funktionen und gleichen Vektoren darf es einen geben; halte sie in einer Liste und geh mit ipairs durch sie</translation>
    </message>
    <message>
        <source>this step does as much work as %1 million instructions (what is done to long texts and lists counts by their length); is there a loop that does not end?</source>
        <translation>dieser Schritt tut so viel wie %1 Millionen Befehle (was mit langen Texten und Listen geschieht, zählt nach deren Länge); gibt es eine Schleife, die nicht endet?</translation>
    </message>
    <message>
        <source>%p of string.format is not part of the lab&apos;s Lua: an address is another in every run</source>
        <translation>%p von string.format gehört nicht zum Lua des Labs: Eine Adresse ist in jedem Lauf eine andere</translation>
    </message>
    <message>
        <source>how many circles there are is #circles</source>
        <translation>wie viele Kreise es gibt, sagt #circles</translation>
    </message>
    <message>
        <source>%1 and %2 are no two numbers to calculate with</source>
        <translation>%1 und %2 sind keine zwei Zahlen, mit denen man rechnen kann</translation>
    </message>
    <message>
        <source>. There is no circles[%1]: circles are counted from 1 to %2</source>
        <translation>. Es gibt kein circles[%1]: Kreise werden von 1 bis %2 gezählt</translation>
    </message>
    <message>
        <source>. The length of a list is #%1</source>
        <translation>. Die Länge einer Liste ist #%1</translation>
    </message>
    <message>
        <source>. Texts are joined by .., not by +</source>
        <translation>. Texte verbindet .., nicht +</translation>
    </message>
    <message>
        <source>. A function is called with its parentheses, and that of a vector with a colon: v:length()</source>
        <translation>. Eine Funktion wird mit ihren Klammern aufgerufen, die eines Vektors mit Doppelpunkt: v:length()</translation>
    </message>
    <message>
        <source>`%1.%2` is %3 in Lua</source>
        <translation>`%1.%2` ist in Lua %3</translation>
    </message>
    <message>
        <source>Lua has no null; nothing is written nil</source>
        <translation>Lua hat kein null; nichts heißt nil</translation>
    </message>
    <message>
        <source>there is no `%1` here; the circles are circle1, circle2 …, and what is your own has its plain name</source>
        <translation>hier gibt es kein `%1`; die Kreise sind circle1, circle2 …, und was dir gehört, hat seinen bloßen Namen</translation>
    </message>
    <message>
        <source>Lua has no `new`; a vector is made by vec(x, y), a table by {}</source>
        <translation>Lua hat kein `new`; einen Vektor macht vec(x, y), eine Tabelle {}</translation>
    </message>
    <message>
        <source>`%1` is not known; a vector is made by vec(x, y)</source>
        <translation>`%1` ist nicht bekannt; einen Vektor macht vec(x, y)</translation>
    </message>
    <message>
        <source>`%1` is not known; print(…) writes to the console</source>
        <translation>`%1` ist nicht bekannt; print(…) schreibt in die Konsole</translation>
    </message>
    <message>
        <source>`%1` is not known; // divides, a comment begins with -- in Lua</source>
        <translation>`%1` ist nicht bekannt; // teilt, ein Kommentar beginnt in Lua mit --</translation>
    </message>
    <message>
        <source>`%1` is not known yet: it is local and stands below, in line %2; move it up, or leave out `local`</source>
        <translation>`%1` ist noch nicht bekannt: Es ist local und steht weiter unten, in Zeile %2; setz es nach oben oder lass `local` weg</translation>
    </message>
    <message>
        <source>`%1` is not known here: it is local to the block of line %2; declare it before that block</source>
        <translation>`%1` ist hier nicht bekannt: Es gilt nur im Block von Zeile %2; vereinbare es vor diesem Block</translation>
    </message>
    <message>
        <source>Lua has no foreach; write: for _, %1 in ipairs(%2) do … end</source>
        <translation>Lua hat kein foreach; schreib: for _, %1 in ipairs(%2) do … end</translation>
    </message>
    <message>
        <source>a loop that counts is written: for %1 = first, last do … end, both included</source>
        <translation>eine Schleife, die zählt, schreibt man: for %1 = erster, letzter do … end, beide eingeschlossen</translation>
    </message>
    <message>
        <source>Lua has no =&gt;; a function is function(x) return … end, and &quot;greater or equal&quot; is &gt;=</source>
        <translation>Lua hat kein =&gt;; eine Funktion ist function(x) return … end, und „größer oder gleich“ ist &gt;=</translation>
    </message>
    <message>
        <source>Lua has no ? : to choose; write: if … then … else … end, or: condition and a or b</source>
        <translation>Lua hat kein ? : zum Auswählen; schreib: if … then … else … end, oder: Bedingung and a or b</translation>
    </message>
    <message>
        <source>Lua writes `not` in words, not !</source>
        <translation>Lua schreibt `not` in Worten, nicht !</translation>
    </message>
    <message>
        <source>Lua names no types; a function is written: function %1(…) … end</source>
        <translation>Lua nennt keine Typen; eine Funktion schreibt man: function %1(…) … end</translation>
    </message>
    <message>
        <source>Lua names no types; write: local %1 = …</source>
        <translation>Lua nennt keine Typen; schreib: local %1 = …</translation>
    </message>
    <message>
        <source>Lua names no types; of a parameter write only the name: %1</source>
        <translation>Lua nennt keine Typen; schreib vom Parameter nur den Namen: %1</translation>
    </message>
    <message>
        <source>Lua has no `%1`</source>
        <translation>Lua hat kein `%1`</translation>
    </message>
    <message>
        <source>Lua has no `continue`; put what it leaves out into an if</source>
        <translation>Lua hat kein `continue`; setz in ein if, was es auslässt</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; write: if … then … else … end</source>
        <translation>Lua hat keine Klammern um Blöcke; schreib: if … then … else … end</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; write: while … do … end</source>
        <translation>Lua hat keine Klammern um Blöcke; schreib: while … do … end</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; write: for … do … end</source>
        <translation>Lua hat keine Klammern um Blöcke; schreib: for … do … end</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; write: function name(…) … end</source>
        <translation>Lua hat keine Klammern um Blöcke; schreib: function name(…) … end</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; a block ends with `end`</source>
        <translation>Lua hat keine Klammern um Blöcke; ein Block endet mit `end`</translation>
    </message>
    <message>
        <source>Lua has no --, which begins a comment; write %1 = %1 - 1</source>
        <translation>Lua hat kein --, das beginnt einen Kommentar; schreib %1 = %1 - 1</translation>
    </message>
    <message>
        <source>return ends its block: nothing may follow it there but end, else or elseif</source>
        <translation>return beendet seinen Block: darin darf nichts mehr folgen als end, else oder elseif</translation>
    </message>
    <message>
        <source>here `%1` is missing</source>
        <translation>hier fehlt `%1`</translation>
    </message>
    <message>
        <source>an `end` is missing: `else if` begins a second if, which needs an `end` of its own; the one word elseif does not</source>
        <translation>ein `end` fehlt: `else if` beginnt ein zweites if, das sein eigenes `end` braucht; das eine Wort elseif braucht keines</translation>
    </message>
    <message>
        <source>`%1` is not known yet: a local can be used only after the statement that makes it</source>
        <translation>`%1` ist noch nicht bekannt: Eine lokale Variable kann erst nach der Anweisung benutzt werden, die sie anlegt</translation>
    </message>
    <message>
        <source>`%1` is not known here; how long a step lasts is the parameter of on_update, which other functions get as an argument</source>
        <translation>`%1` ist hier nicht bekannt; wie lange ein Zeitschritt dauert, ist der Parameter von on_update, den andere Funktionen als Argument bekommen</translation>
    </message>
    <message>
        <source>`%1` is not part of the lab&apos;s Lua; see the API page (F1) for what is</source>
        <translation>`%1` gehört nicht zum Lua des Labs; was dazugehört, steht in der API-Referenz (F1)</translation>
    </message>
    <message>
        <source>. Look at what the call in line %1 gives for it</source>
        <translation>. Sieh nach, was der Aufruf in Zeile %1 dafür übergibt</translation>
    </message>
    <message>
        <source>`%1` is not known here: it is local to another block, in line %2; a function gets what it needs as an argument, or makes it itself</source>
        <translation>`%1` ist hier nicht bekannt: Es gilt nur in einem anderen Block, in Zeile %2; was eine Funktion braucht, bekommt sie als Argument oder macht sie selbst</translation>
    </message>
    <message>
        <source>%1 has no field `%2`: it belongs to the whole world; write `%2` alone</source>
        <translation>%1 hat kein Feld `%2`: Es gehört zur ganzen Welt; schreib nur `%2`</translation>
    </message>
    <message>
        <source>%1 must be a vector, not nil: what it is to become has no value here</source>
        <translation>%1 muss ein Vektor sein, nicht nil: Was es werden soll, hat hier keinen Wert</translation>
    </message>
    <message>
        <source>%1 would be %2 here: the comma ends a value; a number has a point, %2.%3</source>
        <translation>%1 wäre hier %2: Das Komma beendet einen Wert; eine Zahl hat einen Punkt, %2.%3</translation>
    </message>
    <message>
        <source>a vector is multiplied by a number</source>
        <translation>ein Vektor wird mit einer Zahl multipliziert</translation>
    </message>
    <message>
        <source>gravity must be a vector in m/s², not %1; write gravity = vec(0, %2)</source>
        <translation>gravity muss ein Vektor in m/s² sein, nicht %1; schreib gravity = vec(0, %2)</translation>
    </message>
    <message>
        <source>parentheses, blocks or terms are nested too deeply</source>
        <translation>Klammern, Blöcke oder Terme sind zu tief ineinander geschachtelt</translation>
    </message>
    <message>
        <source>%1 is not the minus of Lua; write -</source>
        <translation>%1 ist nicht das Minus von Lua; schreibe -</translation>
    </message>
    <message>
        <source>Lua does not know the sign %1</source>
        <translation>Lua kennt das Zeichen %1 nicht</translation>
    </message>
</context>
<context>
    <name>Trails</name>
    <message>
        <source>centre of mass</source>
        <translation>Schwerpunkt</translation>
    </message>
</context>
<context>
    <name>UnifiedDiff</name>
    <message>
        <source>this is no line of a difference; “@@ -4,3 +4,2 @@” or a line after blank, minus or plus is right</source>
        <translation>das ist keine Zeile eines Unterschieds; richtig ist „@@ -4,3 +4,2 @@“ oder eine Zeile nach Leerzeichen, Minus oder Plus</translation>
    </message>
    <message>
        <source>the lines that this changes are not there any more</source>
        <translation>die Zeilen, die das ändert, sind nicht mehr da</translation>
    </message>
</context>
<context>
    <name>Variant</name>
    <message>
        <source>timestep 1/%1 s</source>
        <translation>Zeitschritt 1/%1 s</translation>
    </message>
    <message>
        <source>throw %1</source>
        <translation>Wurf %1</translation>
    </message>
    <message>
        <source>drop %1</source>
        <translation>Fallversuch %1</translation>
    </message>
    <message>
        <source>contact at %1°</source>
        <translation>Berührung unter %1°</translation>
    </message>
    <message>
        <source>circle %1 towards %2°</source>
        <translation>Kreis %1 in Richtung %2°</translation>
    </message>
    <message>
        <source>parting at %1°</source>
        <translation>Trennung bei %1°</translation>
    </message>
    <message>
        <source>slow hit %1</source>
        <translation>langsamer Stoß %1</translation>
    </message>
    <message>
        <source>contact %1, in front of a wall</source>
        <translation>Berührung %1, vor einer Wand</translation>
    </message>
    <message>
        <source>slowly to one side</source>
        <translation>langsam zur einen Seite</translation>
    </message>
    <message>
        <source>slowly to the other side</source>
        <translation>langsam zur anderen Seite</translation>
    </message>
    <message>
        <source>let go low %1</source>
        <translation>tief losgelassen %1</translation>
    </message>
    <message>
        <source>two hits on one line %1</source>
        <translation>zwei Stöße auf einer Linie %1</translation>
    </message>
</context>
<context>
    <name>Workspace</name>
    <message>
        <source>your program cannot be saved here: %1</source>
        <translation>dein Programm lässt sich hier nicht speichern: %1</translation>
    </message>
    <message>
        <source>the history of your work cannot be kept: %1</source>
        <translation>der Verlauf deiner Arbeit lässt sich nicht aufbewahren: %1</translation>
    </message>
    <message>
        <source>there is no address to share with yet</source>
        <translation>es gibt noch keine Adresse, mit der geteilt wird</translation>
    </message>
    <message>
        <source>your work could not be sent: %1</source>
        <translation>deine Arbeit ließ sich nicht senden: %1</translation>
    </message>
    <message>
        <source>the other side did not take your work: %1</source>
        <translation>die andere Seite hat deine Arbeit nicht angenommen: %1</translation>
    </message>
    <message>
        <source>another window works on this lab now; this one saves nothing more, and what was typed last here is among the versions of the step</source>
        <translation>ein anderes Fenster arbeitet jetzt an diesem Lab; dieses speichert nichts mehr, und was hier zuletzt getippt wurde, ist unter den Fassungen des Schritts</translation>
    </message>
    <message>
        <source>the file cannot be moved aside</source>
        <translation>die Datei lässt sich nicht beiseitelegen</translation>
    </message>
    <message>
        <source>your work cannot be saved here: %1</source>
        <translation>deine Arbeit lässt sich hier nicht speichern: %1</translation>
    </message>
    <message>
        <source>this does not say whose work it is, as cradle.json of format 1 does</source>
        <translation>das sagt nicht, wessen Arbeit es ist, wie cradle.json vom Format 1 es sagt</translation>
    </message>
    <message>
        <source>there is no git repository at this address</source>
        <translation>unter dieser Adresse gibt es kein Git-Repository</translation>
    </message>
    <message>
        <source>there is other work at this address, which yours does not go on from; give another address</source>
        <translation>unter dieser Adresse liegt andere Arbeit, an die deine nicht anschließt; gib eine andere Adresse an</translation>
    </message>
    <message>
        <source>this is no address of a git repository</source>
        <translation>das ist keine Adresse eines Git-Repositorys</translation>
    </message>
    <message>
        <source>another window works on this lab now; this one saves nothing more</source>
        <translation>ein anderes Fenster arbeitet jetzt an diesem Lab; dieses speichert nichts mehr</translation>
    </message>
    <message>
        <source>another program has changed this note; yours stays, and the other is kept in git as refs/cradle/notes/%1</source>
        <translation>ein anderes Programm hat diese Notiz geändert; deine bleibt, und die andere ist in git als refs/cradle/notes/%1 aufbewahrt</translation>
    </message>
    <message>
        <source>this file is no note; it is kept as %1</source>
        <translation>diese Datei ist keine Notiz; sie ist als %1 aufbewahrt</translation>
    </message>
</context>
<context>
    <name>cradle::Announcer</name>
    <message>
        <source>Hit at %1 s: %2 and %3, impulse %4 N s</source>
        <translation>Stoß bei %1 s: %2 und %3, Kraftstoß %4 N s</translation>
    </message>
</context>
<context>
    <name>cradle::ApiPage</name>
    <message>
        <source>API reference</source>
        <translation>API-Referenz</translation>
    </message>
    <message>
        <source>Search (Return: next place in the text)</source>
        <translation>Suchen (Eingabe: nächste Stelle im Text)</translation>
    </message>
    <message>
        <source>Search the API reference</source>
        <translation>In der API-Referenz suchen</translation>
    </message>
    <message>
        <source>Entries of the API reference</source>
        <translation>Einträge der API-Referenz</translation>
    </message>
    <message>
        <source>Not found in the reference: %1</source>
        <translation>Nicht in der Referenz gefunden: %1</translation>
    </message>
    <message>
        <source>:/help/lua-api.md</source>
        <extracomment>The file of the page in your language: docs/lua-api.LANGUAGE.md, if there is one</extracomment>
        <translation>:/help/lua-api.de.md</translation>
    </message>
</context>
<context>
    <name>cradle::ArrangementDialog</name>
    <message>
        <source>Rows</source>
        <translation>Reihen</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Kreise</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Gap between rims</source>
        <translation>Lücke zwischen den Rändern</translation>
    </message>
    <message>
        <source>One more comes from the left</source>
        <translation>Einer mehr kommt von links</translation>
    </message>
    <message numerus="yes">
        <source>%n circle(s)</source>
        <translation>
            <numerusform>%n Kreis</numerusform>
            <numerusform>%n Kreise</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::AuthorDocument</name>
    <message>
        <source>This lab ships with Cradle and stays as it is; make a copy of it to change that</source>
        <translation>Dieses Lab gehört zu Cradle und bleibt, wie es ist; lege eine Kopie an und ändere diese</translation>
    </message>
    <message>
        <source>the folder is not empty; a new or an empty one is right</source>
        <translation>der Ordner ist nicht leer; richtig ist ein neuer oder ein leerer</translation>
    </message>
    <message>
        <source>Reload from the folder</source>
        <translation>Aus dem Ordner neu laden</translation>
    </message>
    <message>
        <source>New lab</source>
        <translation>Neues Lab</translation>
    </message>
    <message>
        <source>Changes that were not saved</source>
        <translation>Änderungen, die nicht gespeichert waren</translation>
    </message>
    <message>
        <source>Take what another program changed</source>
        <translation>Übernehmen, was ein anderes Programm geändert hat</translation>
    </message>
</context>
<context>
    <name>cradle::AuthorExports</name>
    <message>
        <source>Labs (*.cradle);;All files (*)</source>
        <translation>Labs (*.cradle);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Not all of it can be read</source>
        <translation>Nicht alles lässt sich lesen</translation>
    </message>
    <message>
        <source>Students will not find what cannot be read:</source>
        <translation>Was sich nicht lesen lässt, finden Studierende nicht vor:</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Trotzdem exportieren</translation>
    </message>
    <message>
        <source>Export the lab for students</source>
        <translation>Lab für Studierende exportieren</translation>
    </message>
    <message numerus="yes">
        <source>Exported without %n file(s) that are yours: %1</source>
        <translation>
            <numerusform>Ohne %n Datei exportiert, die nur für dich ist: %1</numerusform>
            <numerusform>Ohne %n Dateien exportiert, die nur für dich sind: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>In %1 students are told what checks saw, and not which law is wrong.</source>
        <translation>In %1 erfahren Studierende, was Prüfungen sahen, und nicht, welches Gesetz falsch ist.</translation>
    </message>
    <message>
        <source>Export the lab as one file</source>
        <translation>Lab als eine Datei exportieren</translation>
    </message>
    <message>
        <source>Exported: %1</source>
        <translation>Exportiert: %1</translation>
    </message>
</context>
<context>
    <name>cradle::AuthorFiles</name>
    <message>
        <source>New lab</source>
        <translation>Neues Lab</translation>
    </message>
    <message>
        <source>Title of the lab:</source>
        <translation>Titel des Labs:</translation>
    </message>
    <message>
        <source>My lab</source>
        <translation>Mein Lab</translation>
    </message>
    <message>
        <source>Open a lab&apos;s folder</source>
        <translation>Ordner eines Labs öffnen</translation>
    </message>
    <message>
        <source>Open a lab in one file</source>
        <translation>Ein Lab aus einer Datei öffnen</translation>
    </message>
    <message>
        <source>Labs (*.cradle);;All files (*)</source>
        <translation>Labs (*.cradle);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Replace with mine</source>
        <translation>Durch meine ersetzen</translation>
    </message>
    <message>
        <source>Take theirs</source>
        <translation>Die anderen übernehmen</translation>
    </message>
    <message>
        <source>You have changes that are not saved. If you take the files of the folder instead, Undo brings yours back.</source>
        <translation>Es gibt Änderungen, die nicht gespeichert sind. Nimmst du stattdessen die Dateien des Ordners, holt Rückgängig deine zurück.</translation>
    </message>
    <message>
        <source>Saved, but for fields that hold no value yet: %1</source>
        <translation>Gespeichert, bis auf Felder, in denen noch kein Wert steht: %1</translation>
    </message>
    <message>
        <source>A new or empty folder for the lab</source>
        <translation>Ein neuer oder leerer Ordner für das Lab</translation>
    </message>
    <message>
        <source>Folder:</source>
        <translation>Ordner:</translation>
    </message>
    <message>
        <source>Drop what was typed?</source>
        <translation>Verwerfen, was eingegeben wurde?</translation>
    </message>
    <message>
        <source>What is typed here is no value yet, and is not in the lab: %1</source>
        <translation>Was hier eingegeben ist, ist noch kein Wert und nicht im Lab: %1</translation>
    </message>
    <message>
        <source>Save the lab?</source>
        <translation>Lab speichern?</translation>
    </message>
    <message>
        <source>The lab has changes that are not saved.</source>
        <translation>Das Lab hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
</context>
<context>
    <name>cradle::AuthorNotices</name>
    <message>
        <source>A scene of the proof, at the moment where it went wrong: %1</source>
        <translation>Eine Szene des Nachweises, im Augenblick, in dem es schiefging: %1</translation>
    </message>
    <message>
        <source>This lab ships with Cradle and stays as it is. Look around, or make a copy of it and change that.</source>
        <translation>Dieses Lab gehört zu Cradle und bleibt, wie es ist. Sieh dich um, oder lege eine Kopie an und ändere diese.</translation>
    </message>
    <message>
        <source>Copy to a folder…</source>
        <translation>In einen Ordner kopieren…</translation>
    </message>
    <message>
        <source>Changed by another program: %1</source>
        <translation>Von einem anderen Programm geändert: %1</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Discard them</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Cradle ended without saving this lab. Your changes of %1 are back; they are not saved yet.</source>
        <translation>Cradle endete, ohne dieses Lab zu speichern. Deine Änderungen vom %1 sind wieder da; gespeichert sind sie noch nicht.</translation>
    </message>
    <message>
        <source>Cradle ended before a new lab was saved for the first time.</source>
        <translation>Cradle endete, bevor ein neues Lab zum ersten Mal gespeichert wurde.</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Öffnen</translation>
    </message>
</context>
<context>
    <name>cradle::AuthorWindow</name>
    <message>
        <source>Insert a figure</source>
        <translation>Abbildung einfügen</translation>
    </message>
    <message>
        <source>The scene at %1 s</source>
        <translation>Die Szene bei %1 s</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>noch nicht gespeichert</translation>
    </message>
    <message>
        <source>read only</source>
        <translation>schreibgeschützt</translation>
    </message>
</context>
<context>
    <name>cradle::BrokenFile</name>
    <message>
        <source>Mend %1</source>
        <translation>%1 in Ordnung bringen</translation>
    </message>
    <message>
        <source>Until it can be read, nothing else of this step can be edited. Mend it here; the tabs come back by themselves.</source>
        <translation>Bis sie sich lesen lässt, kann sonst nichts an diesem Schritt geändert werden. Bring sie hier in Ordnung; die Reiter kommen dann von selbst wieder.</translation>
    </message>
    <message>
        <source>Text of the file that cannot be read</source>
        <translation>Text der Datei, die sich nicht lesen lässt</translation>
    </message>
    <message>
        <source>Until it can be read, nothing of the lab can be edited. Mend it here; the steps come back by themselves.</source>
        <translation>Bis sie lesbar ist, kann nichts vom Lab bearbeitet werden. Hier lässt sie sich in Ordnung bringen; die Schritte kommen von selbst zurück.</translation>
    </message>
</context>
<context>
    <name>cradle::ChartPane</name>
    <message>
        <source>%1 · %2</source>
        <comment>heading · unit</comment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 over time, %2</source>
        <translation>%1 über der Zeit, %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Show the last %1 seconds</source>
        <translation>Die letzten %1 Sekunden zeigen</translation>
    </message>
    <message>
        <source>all</source>
        <comment>the whole run</comment>
        <translation>alles</translation>
    </message>
    <message>
        <source>Show the whole run</source>
        <translation>Den ganzen Lauf zeigen</translation>
    </message>
    <message>
        <source>%1 over time</source>
        <translation>%1 über der Zeit</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>kept run: curve</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>s</source>
        <comment>seconds</comment>
        <translation>s</translation>
    </message>
</context>
<context>
    <name>cradle::ChartPlot</name>
    <message>
        <source>%1: %2</source>
        <comment>curve, value</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>s</source>
        <comment>seconds</comment>
        <translation>s</translation>
    </message>
</context>
<context>
    <name>cradle::CheckEditor</name>
    <message>
        <source>What is checked</source>
        <translation>Was geprüft wird</translation>
    </message>
    <message>
        <source>In which scenes</source>
        <translation>In welchen Szenen</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Title of the check</source>
        <translation>Titel der Prüfung</translation>
    </message>
    <message>
        <source>Id of the check</source>
        <translation>Kennung der Prüfung</translation>
    </message>
    <message>
        <source>Letters, digits, dots and dashes; reports name the check by it</source>
        <translation>Buchstaben, Ziffern, Punkte und Striche; so heißt die Prüfung in Berichten</translation>
    </message>
    <message>
        <source>What passing this check is worth in reports</source>
        <translation>Was diese Prüfung in Berichten wert ist</translation>
    </message>
    <message>
        <source>Kind of the check</source>
        <translation>Art der Prüfung</translation>
    </message>
</context>
<context>
    <name>cradle::CheckProgram</name>
    <message>
        <source>-- Returns true, or false and what is wrong.
</source>
        <translation>-- Gibt true zurück, oder false und was falsch ist.
</translation>
    </message>
    <message>
        <source>Edit the program of a check</source>
        <translation>Programm einer Prüfung ändern</translation>
    </message>
    <message>
        <source>Program of the check</source>
        <translation>Programm der Prüfung</translation>
    </message>
</context>
<context>
    <name>cradle::CheckRow</name>
    <message>
        <source>Passed: %1</source>
        <translation>Bestanden: %1</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Nicht bestanden: %1</translation>
    </message>
    <message>
        <source>Show what was observed</source>
        <translation>Zeigen, was beobachtet wurde</translation>
    </message>
    <message>
        <source>Show what was observed: %1</source>
        <translation>Zeigen, was beobachtet wurde: %1</translation>
    </message>
    <message>
        <source>Show the moment ▸</source>
        <translation>Moment zeigen ▸</translation>
    </message>
    <message>
        <source>Show the moment</source>
        <translation>Moment zeigen</translation>
    </message>
</context>
<context>
    <name>cradle::CheckTrial</name>
    <message>
        <source>It cannot be tried before what is wrong in this step is mended.</source>
        <translation>Sie lässt sich erst versuchen, wenn behoben ist, was in diesem Schritt nicht stimmt.</translation>
    </message>
    <message>
        <source>Running…</source>
        <translation>Läuft…</translation>
    </message>
    <message>
        <source>%1 stops in line %2: %3</source>
        <translation>%1 bricht in Zeile %2 ab: %3</translation>
    </message>
    <message>
        <source>%1 stops: %2</source>
        <translation>%1 bricht ab: %2</translation>
    </message>
    <message>
        <source>%1 passes.</source>
        <translation>%1 besteht.</translation>
    </message>
    <message>
        <source>%1 fails: %2</source>
        <translation>%1 besteht nicht: %2</translation>
    </message>
    <message>
        <source>Try this check</source>
        <translation>Diese Prüfung versuchen</translation>
    </message>
    <message>
        <source>On that program, with the first seed</source>
        <translation>An diesem Programm, mit dem ersten Startwert</translation>
    </message>
    <message>
        <source>Program to try the check on</source>
        <translation>Programm, an dem die Prüfung versucht wird</translation>
    </message>
    <message>
        <source>How the check went</source>
        <translation>Wie die Prüfung ausging</translation>
    </message>
    <message>
        <source>This is the check as it was before: a field of it holds what is no value.</source>
        <translation>Das ist die Prüfung, wie sie vorher war: Eines ihrer Felder enthält etwas, das kein Wert ist.</translation>
    </message>
</context>
<context>
    <name>cradle::ChecksTab</name>
    <message>
        <source>Checks · %1</source>
        <translation>Prüfungen · %1</translation>
    </message>
    <message>
        <source>Edit a check</source>
        <translation>Prüfung ändern</translation>
    </message>
    <message>
        <source>New check</source>
        <translation>Neue Prüfung</translation>
    </message>
    <message>
        <source>Add a check</source>
        <translation>Prüfung hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate a check</source>
        <translation>Prüfung duplizieren</translation>
    </message>
    <message>
        <source>Remove a check</source>
        <translation>Prüfung entfernen</translation>
    </message>
    <message>
        <source>Move a check</source>
        <translation>Prüfung verschieben</translation>
    </message>
    <message>
        <source>Checks of the step</source>
        <translation>Prüfungen des Schritts</translation>
    </message>
    <message>
        <source>No check yet. Add one with the plus, then say what is right.</source>
        <translation>Noch keine Prüfung. Füge mit dem Plus eine hinzu und sage dann, was richtig ist.</translation>
    </message>
    <message>
        <source>Duplicate the check</source>
        <translation>Prüfung duplizieren</translation>
    </message>
    <message>
        <source>Remove the check</source>
        <translation>Prüfung entfernen</translation>
    </message>
    <message>
        <source>Move the check up</source>
        <translation>Prüfung nach oben</translation>
    </message>
    <message>
        <source>Move the check down</source>
        <translation>Prüfung nach unten</translation>
    </message>
</context>
<context>
    <name>cradle::CircleTableModel</name>
    <message>
        <source>Change colour of %1</source>
        <translation>Farbe von %1 ändern</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Change position of %1</source>
        <translation>Ort von %1 ändern</translation>
    </message>
    <message>
        <source>Change velocity of %1</source>
        <translation>Geschwindigkeit von %1 ändern</translation>
    </message>
    <message>
        <source>Change radius of %1</source>
        <translation>Radius von %1 ändern</translation>
    </message>
    <message>
        <source>Change density of %1</source>
        <translation>Dichte von %1 ändern</translation>
    </message>
    <message>
        <source>Change integrator of %1</source>
        <translation>Integrator von %1 ändern</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Centre, to the right</source>
        <translation>Mittelpunkt, nach rechts</translation>
    </message>
    <message>
        <source>Centre, upward</source>
        <translation>Mittelpunkt, nach oben</translation>
    </message>
    <message>
        <source>Velocity to the right</source>
        <translation>Geschwindigkeit nach rechts</translation>
    </message>
    <message>
        <source>Velocity upward</source>
        <translation>Geschwindigkeit nach oben</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Density in 1000 kg/m³; steel has 7.8</source>
        <translation>Dichte in 1000 kg/m³; Stahl hat 7.8</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>How position and velocity are carried over a timestep</source>
        <translation>Wie Ort und Geschwindigkeit über einen Zeitschritt weitergerechnet werden</translation>
    </message>
    <message>
        <source>Integrator</source>
        <translation>Integrator</translation>
    </message>
    <message>
        <source>Mass of a ball of this radius and density</source>
        <translation>Masse einer Kugel mit diesem Radius und dieser Dichte</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Integr.</source>
        <comment>short for Integrator</comment>
        <translation>Integr.</translation>
    </message>
</context>
<context>
    <name>cradle::CirclesGroup</name>
    <message>
        <source>Circles</source>
        <translation>Kreise</translation>
    </message>
    <message>
        <source>Add circle</source>
        <translation>Kreis hinzufügen</translation>
    </message>
    <message>
        <source>Add a circle at a free place</source>
        <translation>Einen Kreis an einer freien Stelle hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Add a copy of the selected circle</source>
        <translation>Eine Kopie des gewählten Kreises hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected circle (Delete)</source>
        <translation>Den gewählten Kreis entfernen (Entf)</translation>
    </message>
    <message>
        <source>Reset to the step&apos;s scene</source>
        <translation>Auf die Szene des Schritts zurücksetzen</translation>
    </message>
    <message>
        <source>Bring back the scene that the step came with; Undo takes it back</source>
        <translation>Die Szene zurückholen, mit der der Schritt begann; Rückgängig macht es rückgängig</translation>
    </message>
    <message>
        <source>Duplicate circle</source>
        <translation>Kreis duplizieren</translation>
    </message>
    <message>
        <source>Remove circle</source>
        <translation>Kreis entfernen</translation>
    </message>
</context>
<context>
    <name>cradle::CirclesLine</name>
    <message>
        <source>Circles: numbers from 1 to 100 as “1, 2” are right</source>
        <translation>Kreise: Richtig sind Nummern von 1 bis 100 wie „1, 2“</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Kreise</translation>
    </message>
    <message>
        <source>Circles that it looks at</source>
        <translation>Kreise, die sie betrachtet</translation>
    </message>
    <message>
        <source>Numbers of the circles, as “1, 2”</source>
        <translation>Nummern der Kreise, wie „1, 2“</translation>
    </message>
</context>
<context>
    <name>cradle::ClipboardActions</name>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Select a&amp;ll</source>
        <translation>A&amp;lles auswählen</translation>
    </message>
</context>
<context>
    <name>cradle::CodeActions</name>
    <message>
        <source>Run code</source>
        <translation>Code starten</translation>
    </message>
    <message>
        <source>Run the program as it stands now, from the start</source>
        <translation>Das Programm, wie es jetzt dasteht, von Anfang an laufen lassen</translation>
    </message>
    <message>
        <source>Step into line</source>
        <translation>Nächste Zeile</translation>
    </message>
    <message>
        <source>Run one line of the program</source>
        <translation>Eine Zeile des Programms ausführen</translation>
    </message>
    <message>
        <source>Finish step</source>
        <translation>Schritt beenden</translation>
    </message>
    <message>
        <source>Run the rest of this step</source>
        <translation>Den Rest dieses Schritts ausführen</translation>
    </message>
    <message>
        <source>Start this step afresh…</source>
        <translation>Schritt neu beginnen…</translation>
    </message>
    <message>
        <source>Go back to the program that this step begins with</source>
        <translation>Zurück zu dem Programm, mit dem dieser Schritt beginnt</translation>
    </message>
    <message>
        <source>API reference</source>
        <translation>API-Referenz</translation>
    </message>
    <message>
        <source>What the program may use</source>
        <translation>Was das Programm benutzen kann</translation>
    </message>
    <message>
        <source>Find…</source>
        <translation>Suchen…</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Ersetzen…</translation>
    </message>
    <message>
        <source>Find next</source>
        <translation>Weitersuchen</translation>
    </message>
    <message>
        <source>Find previous</source>
        <translation>Rückwärts suchen</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>Schrift größer</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>Schrift kleiner</translation>
    </message>
    <message>
        <source>Usual text size</source>
        <translation>Übliche Schriftgröße</translation>
    </message>
    <message>
        <source>Hide the reference solution</source>
        <translation>Musterlösung ausblenden</translation>
    </message>
    <message>
        <source>Show the reference solution</source>
        <translation>Musterlösung zeigen</translation>
    </message>
    <message>
        <source>A program that passes this step, beside yours</source>
        <translation>Ein Programm, das diesen Schritt besteht, neben deinem</translation>
    </message>
    <message>
        <source>After you have passed this step, or opened all its hints</source>
        <translation>Wenn du diesen Schritt bestanden oder alle seine Hinweise geöffnet hast</translation>
    </message>
</context>
<context>
    <name>cradle::CodeDesk</name>
    <message>
        <source>in step %1, at %2 s</source>
        <translation>in Schritt %1, bei %2 s</translation>
    </message>
    <message>
        <source>Reference of the lab&apos;s Lua</source>
        <translation>Referenz: das Lua des Labs</translation>
    </message>
    <message>
        <source>Start this step afresh</source>
        <translation>Schritt neu beginnen</translation>
    </message>
    <message>
        <source>Your program goes back to what this step started from. What you have written in this step stays among its versions. Go back?</source>
        <translation>Dein Programm wird wieder das, womit dieser Schritt begann. Was du in diesem Schritt geschrieben hast, bleibt unter seinen Fassungen. Zurückgehen?</translation>
    </message>
</context>
<context>
    <name>cradle::CodeEditor</name>
    <message>
        <source>Error in line %1: %2</source>
        <translation>Fehler in Zeile %1: %2</translation>
    </message>
    <message>
        <source>Line %1 made the first failing step</source>
        <translation>Zeile %1 machte den ersten falschen Schritt</translation>
    </message>
    <message>
        <source>Line %1 runs next</source>
        <translation>Zeile %1 läuft als nächste</translation>
    </message>
    <message>
        <source>Tab indents; Ctrl+Tab, or Escape and then Tab, leaves the editor</source>
        <translation>Tab rückt ein; Strg+Tab, oder Escape und dann Tab, verlässt den Editor</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>API reference</source>
        <translation>API-Referenz</translation>
    </message>
    <message>
        <source>API reference on %1</source>
        <translation>API-Referenz zu %1</translation>
    </message>
</context>
<context>
    <name>cradle::CodeHeader</name>
    <message>
        <source>Run as I type</source>
        <translation>Beim Tippen</translation>
    </message>
    <message>
        <source>Run every change at once, as long as the program parses</source>
        <translation>Jede Änderung sofort laufen lassen, solange das Programm lesbar ist</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>More for the program</source>
        <translation>Mehr zum Programm</translation>
    </message>
</context>
<context>
    <name>cradle::CodePane</name>
    <message>
        <source>saved</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>nicht gespeichert</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>cannot be read: the last good version runs</source>
        <translation>nicht lesbar: letzte gute Fassung läuft</translation>
    </message>
    <message>
        <source>read only</source>
        <translation>nur lesen</translation>
    </message>
    <message>
        <source>cannot be read: nothing runs</source>
        <translation>nicht lesbar: nichts läuft</translation>
    </message>
</context>
<context>
    <name>cradle::CompletionPopup</name>
    <message>
        <source>Completions</source>
        <translation>Vervollständigungen</translation>
    </message>
</context>
<context>
    <name>cradle::ConsoleDelegate</name>
    <message>
        <source>load</source>
        <comment>printed while loading</comment>
        <translation>lädt</translation>
    </message>
</context>
<context>
    <name>cradle::ConsoleModel</name>
    <message>
        <source>step %1: %2</source>
        <translation>Schritt %1: %2</translation>
    </message>
    <message>
        <source>Printed in step %1</source>
        <translation>Ausgegeben in Schritt %1</translation>
    </message>
    <message>
        <source>Printed while the program was loaded</source>
        <translation>Ausgegeben, während das Programm geladen wurde</translation>
    </message>
    <message>
        <source>Printed in step %1, at %2 s; a double click shows it</source>
        <translation>Ausgegeben in Schritt %1, bei %2 s; ein Doppelklick zeigt ihn</translation>
    </message>
</context>
<context>
    <name>cradle::ConsoleView</name>
    <message>
        <source>Console</source>
        <translation>Konsole</translation>
    </message>
    <message>
        <source>print(…) in your program writes here</source>
        <translation>print(…) in deinem Programm schreibt hierher</translation>
    </message>
    <message>
        <source>Lines that the program has printed</source>
        <translation>Zeilen, die das Programm ausgegeben hat</translation>
    </message>
    <message>
        <source>Show the moment</source>
        <translation>Moment zeigen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Alles kopieren</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
</context>
<context>
    <name>cradle::DifferenceDialog</name>
    <message>
        <source>(not in mine)</source>
        <translation>(nicht in meinem)</translation>
    </message>
    <message>
        <source>(not in theirs)</source>
        <translation>(nicht in dem anderen)</translation>
    </message>
    <message>
        <source>no text</source>
        <translation>kein Text</translation>
    </message>
    <message>
        <source>Changed by another program</source>
        <translation>Von einem anderen Programm geändert</translation>
    </message>
    <message>
        <source>From mine (−) to theirs (+):</source>
        <translation>Von meinem (−) zum anderen (+):</translation>
    </message>
    <message>
        <source>Difference of the two versions</source>
        <translation>Unterschied der beiden Fassungen</translation>
    </message>
</context>
<context>
    <name>cradle::EnergyChart</name>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>Press Run to see the energy</source>
        <translation>Drücke „Starten“, um die Energie zu sehen</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Choose the curves</source>
        <translation>Kurven wählen</translation>
    </message>
    <message>
        <source>&amp;Total</source>
        <translation>&amp;Summe</translation>
    </message>
    <message>
        <source>Kinetic, &amp;each circle</source>
        <translation>Kinetisch, &amp;jeder Kreis</translation>
    </message>
    <message>
        <source>&amp;Kinetic, all circles</source>
        <translation>&amp;Kinetisch, alle Kreise</translation>
    </message>
    <message>
        <source>&amp;Potential</source>
        <translation>&amp;Potentiell</translation>
    </message>
    <message>
        <source>&amp;Dissipated in hits</source>
        <translation>Bei Stößen &amp;verloren</translation>
    </message>
    <message>
        <source>total</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>kinetisch</translation>
    </message>
    <message>
        <source>kinetic %1</source>
        <translation>kinetisch %1</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>potentiell</translation>
    </message>
    <message>
        <source>dissipated</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>Total of e&amp;ach</source>
        <translation>&amp;Gesamt je Kreis</translation>
    </message>
    <message>
        <source>By the &amp;integrator</source>
        <translation>Vom &amp;Integrator</translation>
    </message>
    <message>
        <source>Energy made by the integrator, or lost if negative: total + dissipated in hits − total at the start. So start = total + dissipated − made by the integrator.</source>
        <translation>Vom Integrator erzeugte Energie (negativ: verlorene): Summe + bei Stößen verloren − Summe am Anfang. Also Anfang = Summe + verloren − vom Integrator erzeugt.</translation>
    </message>
    <message>
        <source>total %1</source>
        <translation>gesamt %1</translation>
    </message>
    <message>
        <source>by the integrator</source>
        <translation>vom Integrator</translation>
    </message>
    <message>
        <source>By the pro&amp;gram</source>
        <translation>Vom P&amp;rogramm</translation>
    </message>
    <message>
        <source>Energy made by the program besides the hits, or lost if negative: total + dissipated in hits − total at the start.</source>
        <translation>Vom Programm außerhalb der Stöße erzeugte Energie (negativ: verlorene): Summe + bei Stößen verloren − Summe am Anfang.</translation>
    </message>
    <message>
        <source>by the program</source>
        <translation>vom Programm</translation>
    </message>
    <message>
        <source>More than the e&amp;xact motion</source>
        <translation>Mehr als die e&amp;xakte Bewegung</translation>
    </message>
    <message>
        <source>Total energy of the run minus that of the exact motion beside it: the error of integrator and timestep</source>
        <translation>Gesamtenergie des Laufs minus die der exakten Bewegung daneben: der Fehler von Integrator und Zeitschritt</translation>
    </message>
    <message>
        <source>&amp;Stacked areas</source>
        <translation>Gestapelte &amp;Flächen</translation>
    </message>
    <message>
        <source>Kinetic, potential and dissipated energy on top of each other</source>
        <translation>Kinetische, potentielle und verlorene Energie übereinander</translation>
    </message>
    <message>
        <source>more than exact</source>
        <translation>mehr als exakt</translation>
    </message>
    <message>
        <source>kinetic %1</source>
        <comment>unit</comment>
        <translation>kinetisch %1</translation>
    </message>
    <message>
        <source>+ potential</source>
        <translation>+ potentiell</translation>
    </message>
    <message>
        <source>+ dissipated</source>
        <translation>+ verloren</translation>
    </message>
    <message>
        <source>Energy that circles lose in steps with a hit, and while they rest on something; negative if hits made energy, as going back to a higher place does</source>
        <translation>Energie, die Kreise in Schritten mit einem Stoß verlieren und solange sie auf etwas ruhen; negativ, wenn Stöße Energie erzeugt haben, wie es das Zurückgehen an einen höheren Ort tut</translation>
    </message>
    <message>
        <source>taken by hits</source>
        <translation>von Stößen genommen</translation>
    </message>
</context>
<context>
    <name>cradle::ErrorLine</name>
    <message>
        <source>line %1, step %2: %3</source>
        <translation>Zeile %1, Schritt %2: %3</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>step %1: %2</source>
        <translation>Schritt %1: %2</translation>
    </message>
    <message>
        <source>The program stopped: %1</source>
        <translation>Das Programm brach ab: %1</translation>
    </message>
</context>
<context>
    <name>cradle::FindBar</name>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Replace by</source>
        <translation>Ersetzen durch</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Groß/klein beachten</translation>
    </message>
    <message>
        <source>Whole words only</source>
        <translation>Nur ganze Wörter</translation>
    </message>
    <message>
        <source>Previous match</source>
        <translation>Voriger Treffer</translation>
    </message>
    <message>
        <source>Shift+F3</source>
        <translation>Umschalt+F3</translation>
    </message>
    <message>
        <source>Next match</source>
        <translation>Nächster Treffer</translation>
    </message>
    <message>
        <source>F3</source>
        <translation>F3</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Replace all</source>
        <translation>Alle ersetzen</translation>
    </message>
    <message numerus="yes">
        <source>%n replaced</source>
        <translation>
            <numerusform>%n ersetzt</numerusform>
            <numerusform>%n ersetzt</numerusform>
        </translation>
    </message>
    <message>
        <source>no match</source>
        <translation>kein Treffer</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message numerus="yes">
        <source>%n match(es)</source>
        <translation>
            <numerusform>%n Treffer</numerusform>
            <numerusform>%n Treffer</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::FindPanel</name>
    <message>
        <source>Found nowhere</source>
        <translation>Nirgends gefunden</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n Stelle</numerusform>
            <numerusform>%n Stellen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in %n file(s)</source>
        <translation>
            <numerusform>in %n Datei</numerusform>
            <numerusform>in %n Dateien</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace “%1”</source>
        <translation>„%1“ ersetzen</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) replaced; Undo brings them back</source>
        <translation>
            <numerusform>%n Stelle ersetzt; Rückgängig bringt sie zurück</numerusform>
            <numerusform>%n Stellen ersetzt; Rückgängig bringt sie zurück</numerusform>
        </translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Text to find in the lab</source>
        <translation>Text, der im Lab gesucht wird</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Ersetzen durch</translation>
    </message>
    <message>
        <source>Text to put there</source>
        <translation>Text, der dafür eingesetzt wird</translation>
    </message>
    <message>
        <source>Replace all</source>
        <translation>Alle ersetzen</translation>
    </message>
    <message>
        <source>In all places of the list, as one edit</source>
        <translation>An allen Stellen der Liste, als eine Änderung</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Groß/klein beachten</translation>
    </message>
    <message>
        <source>Whole words</source>
        <translation>Ganze Wörter</translation>
    </message>
    <message>
        <source>In the whole lab</source>
        <translation>Im ganzen Lab</translation>
    </message>
    <message>
        <source>In this step</source>
        <translation>In diesem Schritt</translation>
    </message>
    <message>
        <source>Where to look</source>
        <translation>Wo gesucht wird</translation>
    </message>
    <message>
        <source>Close the search</source>
        <translation>Suche schließen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Places that were found</source>
        <translation>Gefundene Stellen</translation>
    </message>
</context>
<context>
    <name>cradle::FindingCard</name>
    <message>
        <source>Show what was measured</source>
        <translation>Zeigen, was gemessen wurde</translation>
    </message>
    <message>
        <source>Show what was measured: %1</source>
        <translation>Zeigen, was gemessen wurde: %1</translation>
    </message>
</context>
<context>
    <name>cradle::FindingsList</name>
    <message>
        <source>All files can be read</source>
        <translation>Alle Dateien sind lesbar</translation>
    </message>
    <message>
        <source>Findings · %1</source>
        <translation>Befunde · %1</translation>
    </message>
    <message>
        <source>Findings in the lab&apos;s files</source>
        <translation>Befunde in den Dateien des Labs</translation>
    </message>
</context>
<context>
    <name>cradle::FormulaRenderer</name>
    <message>
        <source>Cradle was built without MathJax, so formulas show as text.</source>
        <translation>Cradle wurde ohne MathJax gebaut, deshalb erscheinen Formeln als Text.</translation>
    </message>
    <message>
        <source>MathJax does not run: %1</source>
        <translation>MathJax läuft nicht: %1</translation>
    </message>
</context>
<context>
    <name>cradle::GradeDialog</name>
    <message>
        <source>Grade a class: %1</source>
        <translation>Einen Kurs bewerten: %1</translation>
    </message>
    <message>
        <source>&amp;Handed in:</source>
        <translation>&amp;Abgaben:</translation>
    </message>
    <message>
        <source>A folder with a folder, or a .cradle-work file, for each student; or a download of Moodle, Canvas, Blackboard or GitHub Classroom. Nothing in it is changed.</source>
        <translation>Ein Ordner mit einem Ordner oder einer .cradle-work-Datei für jede Person; oder ein Download aus Moodle, Canvas, Blackboard oder GitHub Classroom. Darin wird nichts verändert.</translation>
    </message>
    <message>
        <source>Choose what was handed in</source>
        <translation>Abgaben wählen</translation>
    </message>
    <message>
        <source>&amp;Results:</source>
        <translation>&amp;Ergebnisse:</translation>
    </message>
    <message>
        <source>A folder for the results: an empty one, or one with the results of the same class, which then go on where they were.</source>
        <translation>Ein Ordner für die Ergebnisse: ein leerer, oder einer mit Ergebnissen desselben Kurses, die dann fortgesetzt werden.</translation>
    </message>
    <message>
        <source>Choose a folder for the results</source>
        <translation>Ordner für die Ergebnisse wählen</translation>
    </message>
    <message>
        <source>R&amp;oster:</source>
        <translation>&amp;Teilnehmerliste:</translation>
    </message>
    <message>
        <source>A table (CSV) of who is in the class: id, folder, name, number, email, late days. It may be left out.</source>
        <translation>Eine Tabelle (CSV), wer im Kurs ist: id, folder, name, number, email, late days. Sie darf fehlen.</translation>
    </message>
    <message>
        <source>Choose a roster</source>
        <translation>Teilnehmerliste wählen</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source> % a day</source>
        <translation> % am Tag</translation>
    </message>
    <message>
        <source>What each day late that has begun takes of the points</source>
        <translation>Was jeder angefangene Tag Verspätung von den Punkten nimmt</translation>
    </message>
    <message>
        <source>&amp;Late:</source>
        <translation>&amp;Verspätung:</translation>
    </message>
    <message>
        <source>How the grading goes</source>
        <translation>Wie die Bewertung läuft</translation>
    </message>
    <message>
        <source>Students done</source>
        <translation>Fertige Personen</translation>
    </message>
    <message>
        <source>&amp;Grade</source>
        <translation>&amp;Bewerten</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>O&amp;pen the results</source>
        <translation>Ergebnisse ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>Wählen: %1</translation>
    </message>
    <message>
        <source>What was handed in is read…</source>
        <translation>Die Abgaben werden gelesen…</translation>
    </message>
    <message>
        <source>%1 of %2 students: %3 steps pass, %4 do not, %5 could not be graded.</source>
        <translation>%1 von %2 Personen: %3 Schritte bestehen, %4 nicht, %5 konnten nicht bewertet werden.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the students as they were before.</source>
        <translation>
            <numerusform>%n davon wie zuvor.</numerusform>
            <numerusform>%n davon wie zuvor.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopped. What is judged stays; grading again goes on from here.</source>
        <translation>Angehalten. Was beurteilt ist, bleibt; erneutes Bewerten geht hier weiter.</translation>
    </message>
    <message>
        <source>No program opened the page. It is %1</source>
        <translation>Kein Programm hat die Seite geöffnet. Sie liegt in %1</translation>
    </message>
    <message>
        <source>Choose what was handed in, and a folder for the results. Grading can be stopped at any time, and goes on where it was.</source>
        <translation>Wähle, was abgegeben wurde, und einen Ordner für die Ergebnisse. Das Bewerten lässt sich jederzeit anhalten und geht dann dort weiter.</translation>
    </message>
    <message>
        <source>Remarks on what was handed in</source>
        <translation>Anmerkungen zu den Abgaben</translation>
    </message>
</context>
<context>
    <name>cradle::GradeRun</name>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 lässt sich nicht starten: %2</translation>
    </message>
    <message>
        <source>cradle-cli broke down</source>
        <translation>cradle-cli ist abgestürzt</translation>
    </message>
</context>
<context>
    <name>cradle::HandInDialog</name>
    <message>
        <source>Hand in %1</source>
        <translation>%1 abgeben</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>What is handed in</source>
        <translation>Was abgegeben wird</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Steps that are handed in</source>
        <translation>Schritte, die abgegeben werden</translation>
    </message>
    <message>
        <source>Note to the teacher</source>
        <translation>Nachricht an die Lehrkraft</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Name:</translation>
    </message>
    <message>
        <source>N&amp;umber:</source>
        <translation>N&amp;ummer:</translation>
    </message>
    <message>
        <source>Note to the &amp;teacher:</source>
        <translation>Nachricht an die &amp;Lehrkraft:</translation>
    </message>
    <message>
        <source>&amp;Save the file…</source>
        <translation>Datei &amp;speichern…</translation>
    </message>
    <message>
        <source>Every step is judged once more…</source>
        <translation>Jeder Schritt wird noch einmal geprüft…</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>ein Programm</translation>
    </message>
    <message>
        <source>a scene</source>
        <translation>eine Szene</translation>
    </message>
    <message>
        <source>passes ✓</source>
        <translation>besteht ✓</translation>
    </message>
    <message>
        <source>does not pass</source>
        <translation>besteht nicht</translation>
    </message>
    <message>
        <source>stops with an error</source>
        <translation>bricht mit einem Fehler ab</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>nicht gemacht</translation>
    </message>
    <message>
        <source>%1 of %2 steps pass. All of them are handed in as they are.</source>
        <translation>%1 von %2 Schritten bestehen. Abgegeben werden alle so, wie sie sind.</translation>
    </message>
    <message>
        <source>Save what is handed in</source>
        <translation>Abgabe speichern</translation>
    </message>
    <message>
        <source>Work to hand in (*.cradle-work)</source>
        <translation>Arbeit zum Abgeben (*.cradle-work)</translation>
    </message>
    <message>
        <source>The values of this lab were drawn by this number</source>
        <translation>Mit dieser Nummer wurden die Werte dieses Labs gezogen</translation>
    </message>
</context>
<context>
    <name>cradle::HelpDesk</name>
    <message>
        <source>The step</source>
        <translation>Der Schritt</translation>
    </message>
    <message>
        <source>Here stands what to do and why. The dots are the steps of the lab; hints wait below the text.</source>
        <translation>Hier steht, was zu tun ist und warum. Die Punkte sind die Schritte des Labs; unter dem Text warten Hinweise.</translation>
    </message>
    <message>
        <source>Your program</source>
        <translation>Dein Programm</translation>
    </message>
    <message>
        <source>The scene in numbers</source>
        <translation>Die Szene in Zahlen</translation>
    </message>
    <message>
        <source>You keep one program through all steps. It is saved and runs as you type; F1 explains the word under the cursor.</source>
        <translation>Du behältst ein Programm durch alle Schritte. Es wird gespeichert und läuft, während du schreibst; F1 erklärt das Wort an der Schreibmarke.</translation>
    </message>
    <message>
        <source>World, laws and circles: what you change here or by dragging in the scene starts the run anew.</source>
        <translation>Welt, Gesetze und Kreise: Was du hier oder durch Ziehen in der Szene änderst, beginnt den Lauf von vorn.</translation>
    </message>
    <message>
        <source>The scene</source>
        <translation>Die Szene</translation>
    </message>
    <message>
        <source>What your circles do. At a hit, arrows show the parts of the velocities along and across the normal.</source>
        <translation>Was deine Kreise tun. Bei einem Stoß zeigen Pfeile die Anteile der Geschwindigkeiten längs und quer zur Normalen.</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Momentum and energy of the same run. Click where you want the numbers of that moment; every hit is marked.</source>
        <translation>Impuls und Energie desselben Laufs. Klick dorthin, wo du die Zahlen des Augenblicks sehen willst; jeder Stoß ist markiert.</translation>
    </message>
    <message>
        <source>Any moment again</source>
        <translation>Jeder Augenblick noch einmal</translation>
    </message>
    <message>
        <source>Drag to any moment of the run, or press Next hit. Space runs and pauses.</source>
        <translation>Zieh zu einem beliebigen Augenblick des Laufs, oder drück „Nächster Stoß“. Die Leertaste startet und hält an.</translation>
    </message>
    <message>
        <source>Run and check</source>
        <translation>Starten und prüfen</translation>
    </message>
    <message>
        <source>Run to watch; Check when you are done: it says what is right, what is not, and why.</source>
        <translation>Starten, um zuzusehen; Prüfen, wenn du fertig bist: Es sagt, was richtig ist, was nicht, und warum.</translation>
    </message>
    <message>
        <source>:/help/lua-for-csharp.md</source>
        <extracomment>The file of the page in your language: docs/lua-for-csharp.LANGUAGE.md, if there is one</extracomment>
        <translation>:/help/lua-for-csharp.de.md</translation>
    </message>
    <message>
        <source>Lua for C# people</source>
        <translation>Lua für Leute, die C# können</translation>
    </message>
    <message>
        <source>Comment lines, or not</source>
        <translation>Zeilen auskommentieren oder nicht</translation>
    </message>
    <message>
        <source>Words that fit here</source>
        <translation>Wörter, die hier passen</translation>
    </message>
    <message>
        <source>What the call takes</source>
        <translation>Was der Aufruf erwartet</translation>
    </message>
    <message>
        <source>Out of the program</source>
        <translation>Aus dem Programm heraus</translation>
    </message>
    <message>
        <source>Esc, then Tab</source>
        <translation>Esc, dann Tab</translation>
    </message>
    <message>
        <source>Select several circles</source>
        <translation>Mehrere Kreise auswählen</translation>
    </message>
    <message>
        <source>Ctrl+click, Shift+drag, Shift+arrows</source>
        <translation>Strg+Klick, Umschalt+Ziehen, Umschalt+Pfeile</translation>
    </message>
    <message>
        <source>Move what is selected</source>
        <translation>Ausgewähltes verschieben</translation>
    </message>
    <message>
        <source>drag; Ctrl+arrows, finer with Shift</source>
        <translation>ziehen; Strg+Pfeile, feiner mit Umschalt</translation>
    </message>
    <message>
        <source>Drag free of the grid</source>
        <translation>Frei vom Raster ziehen</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Zoom to a box</source>
        <translation>Rahmen vergrößern</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>wheel; values alone with Ctrl</source>
        <translation>Mausrad; nur die Werte mit Strg</translation>
    </message>
    <message>
        <source>Move along</source>
        <translation>Ausschnitt verschieben</translation>
    </message>
    <message>
        <source>drag with the middle button</source>
        <translation>mit mittlerer Taste ziehen</translation>
    </message>
    <message>
        <source>Reset the zoom</source>
        <translation>Zoom zurücksetzen</translation>
    </message>
    <message>
        <source>double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>In a chart</source>
        <translation>In einem Diagramm</translation>
    </message>
    <message>
        <source>Take a drag back</source>
        <translation>Ziehen zurücknehmen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Remove what is selected</source>
        <translation>Ausgewähltes entfernen</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Ausschnitt verschieben</translation>
    </message>
    <message>
        <source>drag on empty space, or the middle button</source>
        <translation>an leerer Stelle ziehen, oder mit der mittleren Taste</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Am Zeiger vergrößern</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>A step back or on</source>
        <translation>Einen Schritt zurück oder weiter</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Links, Rechts</translation>
    </message>
    <message>
        <source>The hit before or after</source>
        <translation>Der Stoß davor oder danach</translation>
    </message>
    <message>
        <source>PgUp, PgDown</source>
        <translation>Bild auf, Bild ab</translation>
    </message>
    <message>
        <source>Start and end of the run</source>
        <translation>Anfang und Ende des Laufs</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Pos1, Ende</translation>
    </message>
    <message>
        <source>From curve to curve of a chart, from bar to bar of the speeds</source>
        <translation>Von Kurve zu Kurve eines Diagramms, von Balken zu Balken der Geschwindigkeiten</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>Auf, Ab</translation>
    </message>
    <message>
        <source>Hear that curve from left to right</source>
        <translation>Diese Kurve von links nach rechts hören</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Along the dots of the steps, and open</source>
        <translation>Die Punkte der Schritte entlang, und öffnen</translation>
    </message>
    <message>
        <source>Left, Right, Return</source>
        <translation>Links, Rechts, Eingabe</translation>
    </message>
    <message>
        <source>Anywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>On the timeline and the steps</source>
        <translation>Auf der Zeitleiste und den Schritten</translation>
    </message>
    <message>
        <source>In the program</source>
        <translation>Im Programm</translation>
    </message>
    <message>
        <source>In the scene</source>
        <translation>In der Szene</translation>
    </message>
    <message>
        <source>About Cradle</source>
        <translation>Über Cradle</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Cradle %1&lt;/h3&gt;&lt;p&gt;Learn how a physics engine works by writing one.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. Built with Qt, Lua, QScintilla, MathJax and valijson.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Cradle %1&lt;/h3&gt;&lt;p&gt;Lerne, wie eine Physik-Engine arbeitet, indem du eine schreibst.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder später. Gebaut mit Qt, Lua, QScintilla, MathJax und valijson.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>cradle::HintsList</name>
    <message>
        <source>A new hint</source>
        <translation>Ein neuer Hinweis</translation>
    </message>
    <message>
        <source>Hints, in the order of opening</source>
        <translation>Hinweise, in der Reihenfolge des Öffnens</translation>
    </message>
    <message>
        <source>Add a hint</source>
        <translation>Hinweis hinzufügen</translation>
    </message>
    <message>
        <source>Remove the hint</source>
        <translation>Hinweis entfernen</translation>
    </message>
    <message>
        <source>Move the hint up</source>
        <translation>Hinweis nach oben</translation>
    </message>
    <message>
        <source>Move the hint down</source>
        <translation>Hinweis nach unten</translation>
    </message>
</context>
<context>
    <name>cradle::HitsModel</name>
    <message>
        <source>left wall</source>
        <translation>linke Wand</translation>
    </message>
    <message>
        <source>right wall</source>
        <translation>rechte Wand</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>Decke</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>circle, wall</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>circle, circle</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>N s</source>
        <translation>N s</translation>
    </message>
    <message>
        <source>kg m/s</source>
        <translation>kg m/s</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>who</source>
        <translation>wer</translation>
    </message>
    <message>
        <source>impulse</source>
        <translation>Kraftstoß</translation>
    </message>
    <message>
        <source>before</source>
        <translation>davor</translation>
    </message>
    <message>
        <source>after</source>
        <translation>danach</translation>
    </message>
    <message>
        <source>change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Hit %1 at %2 s: momentum before %3, after %4, change %5 kg m/s.</source>
        <translation>Stoß %1 bei %2 s: Impuls vorher %3, nachher %4, Änderung %5 kg m/s.</translation>
    </message>
    <message>
        <source>Hit %1 at %2 s, circle %6 on the %7: momentum before %3, after %4, change %5 kg m/s.</source>
        <translation>Stoß %1 bei %2 s, Kreis %6 (%7): Impuls vorher %3, nachher %4, Änderung %5 kg m/s.</translation>
    </message>
    <message>
        <source>Momentum (p_x, p_y) of the circles of the hit; p_x alone where there is no p_y</source>
        <translation>Impuls (p_x, p_y) der Kreise des Stoßes; p_x allein, wo es kein p_y gibt</translation>
    </message>
    <message>
        <source>Hit %1: circle %2 on the %3, in contact from %4 s to %5 s.</source>
        <translation>Stoß %1: Kreis %2 (%3), in Berührung von %4 s bis %5 s.</translation>
    </message>
    <message>
        <source>Hit %1: circles %2 and %3, in contact from %4 s to %5 s.</source>
        <translation>Stoß %1: Kreise %2 und %3, in Berührung von %4 s bis %5 s.</translation>
    </message>
</context>
<context>
    <name>cradle::Inspector</name>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>These values are the start of the run.</source>
        <translation>Diese Werte sind der Anfang des Laufs.</translation>
    </message>
    <message>
        <source>Not possible: %1.</source>
        <translation>Nicht möglich: %1.</translation>
    </message>
    <message>
        <source>“%1” is not a number; 0.5, 1e-3 or 1/240 would be right.</source>
        <translation>„%1“ ist keine Zahl; richtig wäre 0.5, 1e-3 oder 1/240.</translation>
    </message>
</context>
<context>
    <name>cradle::InstructionsPane</name>
    <message>
        <source>Hint %1</source>
        <translation>Hinweis %1</translation>
    </message>
    <message>
        <source>Hint %1 of %2 ▸</source>
        <translation>Hinweis %1 von %2 ▸</translation>
    </message>
    <message>
        <source>Show hint %1 of %2</source>
        <translation>Hinweis %1 von %2 zeigen</translation>
    </message>
    <message>
        <source>Instructions</source>
        <translation>Anleitung</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>Hinweise</translation>
    </message>
</context>
<context>
    <name>cradle::KeysDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
</context>
<context>
    <name>cradle::LabDialog</name>
    <message>
        <source>Properties of the lab</source>
        <translation>Eigenschaften des Labs</translation>
    </message>
    <message>
        <source>The progress of students is kept by the id. A corrected lab keeps its id and gets a higher version; a new lab gets a new id.</source>
        <translation>Der Fortschritt der Studierenden hängt an der Kennung. Ein berichtigtes Lab behält seine Kennung und bekommt eine höhere Version; ein neues Lab bekommt eine neue Kennung.</translation>
    </message>
    <message>
        <source>Title, %1</source>
        <translation>Titel, %1</translation>
    </message>
    <message>
        <source>Letters, digits, dots and dashes</source>
        <translation>Buchstaben, Ziffern, Punkte und Striche</translation>
    </message>
    <message>
        <source>The language of task.json and instructions.md; texts in others have files of their own</source>
        <translation>Die Sprache von task.json und instructions.md; Texte in anderen haben eigene Dateien</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Written in</source>
        <translation>Geschrieben in</translation>
    </message>
    <message>
        <source>A title of 1 to 200 characters is right</source>
        <translation>Richtig ist ein Titel von 1 bis 200 Zeichen</translation>
    </message>
    <message>
        <source>Edit the properties of the lab</source>
        <translation>Eigenschaften des Labs ändern</translation>
    </message>
    <message>
        <source>A copy of the lab</source>
        <translation>Eine Kopie des Labs</translation>
    </message>
    <message>
        <source>The copy is a lab of its own, so it has an id of its own: who has passed a step of the original has not passed that of the copy.</source>
        <translation>Die Kopie ist ein eigenes Lab mit eigener Kennung: Wer einen Schritt des Originals bestanden hat, hat den der Kopie damit nicht bestanden.</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (Kopie)</translation>
    </message>
    <message>
        <source>Another id than that of the original is right</source>
        <translation>Richtig ist eine andere Kennung als die des Originals</translation>
    </message>
</context>
<context>
    <name>cradle::LabDrop</name>
    <message>
        <source>no version</source>
        <translation>ohne Version</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Another version</source>
        <translation>Eine andere Version</translation>
    </message>
    <message>
        <source>“%1” is there already with %2. The file has %3.</source>
        <translation>„%1“ ist schon da: %2. Die Datei: %3.</translation>
    </message>
    <message>
        <source>Both have one id, so what was passed in one counts as passed in the other.</source>
        <translation>Beide haben dieselbe Kennung; was in der einen bestanden ist, gilt auch in der anderen als bestanden.</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>Beide behalten</translation>
    </message>
</context>
<context>
    <name>cradle::LanguageBox</name>
    <message>
        <source>Texts in %1</source>
        <translation>Texte: %1</translation>
    </message>
    <message>
        <source>Language of the texts</source>
        <translation>Sprache der Texte</translation>
    </message>
    <message>
        <source>What is typed in any of the tabs, and the titles of steps, are in this language</source>
        <translation>Was in irgendeinem der Reiter getippt wird und die Titel der Schritte sind in dieser Sprache</translation>
    </message>
</context>
<context>
    <name>cradle::LawsGroup</name>
    <message>
        <source>Change law for walls</source>
        <translation>Gesetz für Wände ändern</translation>
    </message>
    <message>
        <source>Change law for circles</source>
        <translation>Gesetz für Kreise ändern</translation>
    </message>
    <message>
        <source>Change timing</source>
        <translation>Zeitführung ändern</translation>
    </message>
    <message>
        <source>Laws</source>
        <translation>Gesetze</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Kreise</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>Zeitführung</translation>
    </message>
    <message>
        <source>Law: %1</source>
        <translation>Gesetz: %1</translation>
    </message>
    <message>
        <source>Circles leave the square unhindered.</source>
        <translation>Kreise verlassen das Quadrat ungehindert.</translation>
    </message>
    <message>
        <source>A wall turns the part of the velocity that points into it around, and multiplies it by e.</source>
        <translation>Eine Wand kehrt den Anteil der Geschwindigkeit um, der in sie zeigt, und multipliziert ihn mit e.</translation>
    </message>
    <message>
        <source>Circles pass through each other.</source>
        <translation>Kreise gehen durcheinander hindurch.</translation>
    </message>
    <message>
        <source>Circles that meet both stop.</source>
        <translation>Kreise, die sich treffen, bleiben beide stehen.</translation>
    </message>
    <message>
        <source>Circles that meet exchange their whole velocities.</source>
        <translation>Kreise, die sich treffen, tauschen ihre ganzen Geschwindigkeiten.</translation>
    </message>
    <message>
        <source>Only the parts of the velocities along the line of centres are exchanged; the parts across it stay.</source>
        <translation>Nur die Anteile der Geschwindigkeiten längs der Verbindungslinie der Mittelpunkte werden getauscht; die Anteile quer dazu bleiben.</translation>
    </message>
    <message>
        <source>An impulse along the line of centres keeps the momentum, with the masses and the restitution e.</source>
        <translation>Ein Kraftstoß längs der Verbindungslinie der Mittelpunkte erhält den Impuls, mit den Massen und der Stoßzahl e.</translation>
    </message>
    <message>
        <source>After each step overlaps are looked for; on a hit the circles go back to their old positions and respond.</source>
        <translation>Nach jedem Schritt werden Überlappungen gesucht; bei einem Stoß gehen die Kreise an ihren alten Ort zurück und antworten.</translation>
    </message>
    <message>
        <source>The time of a hit inside the step is found, and the rest of the step is spent after it.</source>
        <translation>Der Zeitpunkt eines Stoßes im Schritt wird bestimmt, und der Rest des Schritts läuft danach ab.</translation>
    </message>
    <message>
        <source>The motion is solved from hit to hit; the timestep only says when to look.</source>
        <translation>Die Bewegung wird von Stoß zu Stoß gelöst; der Zeitschritt sagt nur, wann hingesehen wird.</translation>
    </message>
</context>
<context>
    <name>cradle::LocalsTable</name>
    <message>
        <source>Local variables</source>
        <translation>Lokale Variablen</translation>
    </message>
    <message>
        <source>None at this line</source>
        <translation>Keine in dieser Zeile</translation>
    </message>
    <message>
        <source>Local variables at the line that runs next</source>
        <translation>Lokale Variablen in der Zeile, die als nächste läuft</translation>
    </message>
</context>
<context>
    <name>cradle::MarkdownView</name>
    <message>
        <source>(a picture)</source>
        <translation>(ein Bild)</translation>
    </message>
</context>
<context>
    <name>cradle::MomentumChart</name>
    <message>
        <source>Momentum</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>kg m/s</source>
        <translation>kg m/s</translation>
    </message>
    <message>
        <source>Press Run to see the momentum</source>
        <translation>Drücke „Starten“, um den Impuls zu sehen</translation>
    </message>
    <message>
        <source>Momentum to the right</source>
        <translation>Impuls nach rechts</translation>
    </message>
    <message>
        <source>Momentum upwards</source>
        <translation>Impuls nach oben</translation>
    </message>
    <message>
        <source>Size of the momentum</source>
        <translation>Betrag des Impulses</translation>
    </message>
    <message>
        <source>Part of the momentum</source>
        <translation>Anteil des Impulses</translation>
    </message>
    <message>
        <source>sum %1</source>
        <translation>Summe %1</translation>
    </message>
</context>
<context>
    <name>cradle::NotesPane</name>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>What you noted about this step: it becomes part of your report. Markdown, and formulas as $v = a t$.</source>
        <translation>Was du dir zu diesem Schritt notiert hast: Es wird Teil deines Berichts. Markdown, und Formeln wie $v = a t$.</translation>
    </message>
    <message>
        <source>Notes about this step</source>
        <translation>Notizen zu diesem Schritt</translation>
    </message>
    <message>
        <source>The notes, set</source>
        <translation>Die Notizen, gesetzt</translation>
    </message>
</context>
<context>
    <name>cradle::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation>Mitteilung</translation>
    </message>
    <message>
        <source>Got it</source>
        <translation>Verstanden</translation>
    </message>
</context>
<context>
    <name>cradle::Opening</name>
    <message>
        <source>Open a lab&apos;s folder</source>
        <translation>Ordner eines Labs öffnen</translation>
    </message>
    <message>
        <source>Open a lab in one file</source>
        <translation>Ein Lab aus einer Datei öffnen</translation>
    </message>
    <message>
        <source>Labs and work (*.cradle *.cradle-work);;All files (*)</source>
        <translation>Labs und Arbeiten (*.cradle *.cradle-work);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation>Szene öffnen</translation>
    </message>
    <message>
        <source>Scenes (*.json);;All files (*)</source>
        <translation>Szenen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Szene speichern</translation>
    </message>
</context>
<context>
    <name>cradle::OtherMistakesMenu</name>
    <message>
        <source>A mistake of another &amp;step</source>
        <translation>Ein Fehler eines anderen &amp;Schritts</translation>
    </message>
    <message>
        <source>No mistake of another step applies to this solution that the step does not have</source>
        <translation>Kein Fehler eines anderen Schritts passt zu dieser Lösung, den der Schritt nicht schon hat</translation>
    </message>
</context>
<context>
    <name>cradle::ParameterForm</name>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>%1 (usual)</source>
        <translation>%1 (üblich)</translation>
    </message>
</context>
<context>
    <name>cradle::PhaseChart</name>
    <message>
        <source>Vertical axis: %1</source>
        <translation>Senkrechte Achse: %1</translation>
    </message>
    <message>
        <source>Horizontal axis: %1</source>
        <translation>Waagrechte Achse: %1</translation>
    </message>
    <message>
        <source>%1 against %2</source>
        <translation>%1 über %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>quantity, unit</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Circle %1</source>
        <translation>Kreis %1</translation>
    </message>
    <message>
        <source>All together</source>
        <translation>Alle zusammen</translation>
    </message>
    <message>
        <source>Press Run to see one quantity against another</source>
        <translation>Drücke „Starten“, um eine Größe über einer anderen zu sehen</translation>
    </message>
    <message>
        <source>There is nothing to draw: choose other quantities</source>
        <translation>Hier gibt es nichts zu zeichnen: Wähle andere Größen</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <comment>quantity, unit</comment>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>against</source>
        <translation>über</translation>
    </message>
    <message>
        <source>%1, circle %2</source>
        <comment>quantity, of</comment>
        <translation>%1, Kreis %2</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <comment>quantity, value, unit</comment>
        <translation>%1: %2 %3</translation>
    </message>
</context>
<context>
    <name>cradle::PictureObjects</name>
    <message>
        <source>pictures from elsewhere are not loaded</source>
        <translation>Bilder von anderswo werden nicht geladen</translation>
    </message>
    <message>
        <source>the picture must be in the folder of the instructions</source>
        <translation>das Bild muss im Ordner der Anleitung liegen</translation>
    </message>
    <message>
        <source>there is no picture %1</source>
        <translation>es gibt kein Bild %1</translation>
    </message>
    <message>
        <source>the picture refers to another file</source>
        <translation>das Bild verweist auf eine andere Datei</translation>
    </message>
    <message>
        <source>the picture cannot be read</source>
        <translation>das Bild kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the picture is too large; at most %1 × %1 pixels are right</source>
        <translation>das Bild ist zu groß; richtig sind höchstens %1 × %1 Pixel</translation>
    </message>
</context>
<context>
    <name>cradle::PinnedRuns</name>
    <message>
        <source>pinned %1</source>
        <comment>a run</comment>
        <translation>angeheftet %1</translation>
    </message>
    <message>
        <source>%1: how it went on after %2 s</source>
        <comment>kept run, moment</comment>
        <translation>%1: wie es nach %2 s weiterging</translation>
    </message>
    <message>
        <source>%1: the same scene and program</source>
        <translation>%1: dieselbe Szene, dasselbe Programm</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 und %n weiteres</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::Plot</name>
    <message>
        <source>%1 %</source>
        <comment>share</comment>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>cradle::PlotPane</name>
    <message>
        <source>Zoom, pin and export</source>
        <translation>Zoomen, anheften und exportieren</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Vergrößern</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>&amp;Reset zoom</source>
        <translation>&amp;Zoom zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Pin this run</source>
        <translation>Diesen Lauf an&amp;heften</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <comment>a kept run</comment>
        <translation>%1 entfernen</translation>
    </message>
</context>
<context>
    <name>cradle::PlotsChart</name>
    <message>
        <source>Plots</source>
        <translation>Plots</translation>
    </message>
    <message>
        <source>plot(name, number) in your program adds a curve here</source>
        <translation>plot(name, number) in deinem Programm fügt hier eine Kurve hinzu</translation>
    </message>
</context>
<context>
    <name>cradle::PredictionCard</name>
    <message>
        <source>Not sure</source>
        <translation>Nicht sicher</translation>
    </message>
    <message>
        <source>The scene has run already. What did you expect?</source>
        <translation>Die Szene ist schon gelaufen. Was hattest du erwartet?</translation>
    </message>
    <message>
        <source>Choose before you run the scene. The check does not count it.</source>
        <translation>Wähle, bevor du die Szene startest. Für die Prüfung zählt es nicht.</translation>
    </message>
    <message>
        <source>Kept. Did it come so?</source>
        <translation>Gemerkt. Kam es so?</translation>
    </message>
    <message>
        <source>Kept. Now run the scene and watch.</source>
        <translation>Gemerkt. Starte nun die Szene und sieh zu.</translation>
    </message>
    <message>
        <source>You were not sure.</source>
        <translation>Du warst nicht sicher.</translation>
    </message>
    <message>
        <source>You predicted: %1</source>
        <translation>Deine Vorhersage: %1</translation>
    </message>
    <message>
        <source>Predict</source>
        <translation>Sag voraus</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>Vorhersage</translation>
    </message>
    <message>
        <source>What happens: %1.</source>
        <translation>Was geschieht: %1.</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>What happens</source>
        <translation>Was geschieht</translation>
    </message>
    <message>
        <source>Show what happens ▸</source>
        <translation>Zeigen, was geschieht ▸</translation>
    </message>
    <message>
        <source>Show what happens</source>
        <translation>Zeigen, was geschieht</translation>
    </message>
</context>
<context>
    <name>cradle::PredictionEditor</name>
    <message>
        <source>What will happen?</source>
        <translation>Was wird geschehen?</translation>
    </message>
    <message>
        <source>The first answer</source>
        <translation>Die erste Antwort</translation>
    </message>
    <message>
        <source>The second answer</source>
        <translation>Die zweite Antwort</translation>
    </message>
    <message>
        <source>What happens, and why.</source>
        <translation>Was geschieht, und warum.</translation>
    </message>
    <message>
        <source>Another answer</source>
        <translation>Noch eine Antwort</translation>
    </message>
    <message>
        <source>A question of 1 to %1 characters is right</source>
        <translation>Richtig ist eine Frage von 1 bis %1 Zeichen</translation>
    </message>
    <message>
        <source>A text of 1 to %1 characters on what happens is right</source>
        <translation>Richtig ist ein Text von 1 bis %1 Zeichen darüber, was geschieht</translation>
    </message>
    <message>
        <source>An answer of 1 to 100 characters is right</source>
        <translation>Richtig ist eine Antwort von 1 bis 100 Zeichen</translation>
    </message>
    <message>
        <source>This step asks for no prediction. A question that is asked before the scene is watched, and answered after it, makes students look.</source>
        <translation>Dieser Schritt fragt nach keiner Vorhersage. Wer vor dem Zusehen gefragt wird und danach die Antwort liest, sieht genauer hin.</translation>
    </message>
    <message>
        <source>Ask for a prediction</source>
        <translation>Nach einer Vorhersage fragen</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Answers: two to four that students truly believe; mark the one that comes true</source>
        <translation>Antworten: zwei bis vier, an die Studierende wirklich glauben; markiert wird die, die eintrifft</translation>
    </message>
    <message>
        <source>Answer %1 comes true</source>
        <translation>Antwort %1 trifft ein</translation>
    </message>
    <message>
        <source>Answer %1</source>
        <translation>Antwort %1</translation>
    </message>
    <message>
        <source>Remove answer %1</source>
        <translation>Antwort %1 entfernen</translation>
    </message>
    <message>
        <source>Add an answer</source>
        <translation>Antwort hinzufügen</translation>
    </message>
    <message>
        <source>What happens, and why; told after the step was passed</source>
        <translation>Was geschieht, und warum; zu lesen, wenn der Schritt bestanden ist</translation>
    </message>
    <message>
        <source>What happens, and why</source>
        <translation>Was geschieht, und warum</translation>
    </message>
    <message>
        <source>Remove the prediction</source>
        <translation>Vorhersage entfernen</translation>
    </message>
    <message>
        <source>What the student sees before</source>
        <translation>Was Studierende vorher sehen</translation>
    </message>
    <message>
        <source>And after</source>
        <translation>Und nachher</translation>
    </message>
</context>
<context>
    <name>cradle::Presenter</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
</context>
<context>
    <name>cradle::PresetDocument</name>
    <message>
        <source>This is a scene of the check; go back to your own scene to change it</source>
        <translation>Das ist eine Szene der Prüfung; geh zu deiner eigenen Szene zurück, um sie zu ändern</translation>
    </message>
    <message>
        <source>Reset to the step&apos;s own scene</source>
        <translation>Auf die Szene des Schritts zurücksetzen</translation>
    </message>
    <message>
        <source>Start from %1 s</source>
        <translation>Anfang bei %1 s</translation>
    </message>
</context>
<context>
    <name>cradle::ProgramPage</name>
    <message>
        <source>Program %1</source>
        <translation>Programm %1</translation>
    </message>
    <message>
        <source>What a student&apos;s program starts from in this step.</source>
        <translation>Womit das Programm in diesem Schritt anfängt.</translation>
    </message>
    <message>
        <source>None of its own: students go on from the solution of the step before. Write here to start from something else.</source>
        <translation>Kein eigenes: Es geht mit der Lösung des vorigen Schritts weiter. Schreib hier, um mit etwas anderem anzufangen.</translation>
    </message>
    <message>
        <source>A whole program with one mistake: it fails by a check, and who wrote the same reads the comment that it begins with.</source>
        <translation>Ein ganzes Programm mit einem Fehler: Es scheitert an einer Prüfung, und wer dasselbe schrieb, liest den Kommentar an seinem Anfang.</translation>
    </message>
    <message>
        <source>A whole program that passes and deserves a word.</source>
        <translation>Ein ganzes Programm, das besteht und ein Wort verdient.</translation>
    </message>
    <message>
        <source>Edit a program</source>
        <translation>Programm ändern</translation>
    </message>
    <message>
        <source>Edit what the student reads</source>
        <translation>Text für Studierende ändern</translation>
    </message>
    <message>
        <source>Edit a remark</source>
        <translation>Anmerkung ändern</translation>
    </message>
    <message>
        <source>What the student reads</source>
        <translation>Was Studierende lesen</translation>
    </message>
    <message>
        <source>How it is recognised</source>
        <translation>Woran es erkannt wird</translation>
    </message>
    <message>
        <source>About the program</source>
        <translation>Über das Programm</translation>
    </message>
    <message>
        <source>The comment that the program begins with, or its translation</source>
        <translation>Der Kommentar, mit dem das Programm beginnt, oder seine Übersetzung</translation>
    </message>
    <message>
        <source>What the student reads, translated</source>
        <translation>Was Studierende lesen, übersetzt</translation>
    </message>
    <message>
        <source>The reference: it should pass every check, with every seed.</source>
        <translation>Die Musterlösung: Sie soll jede Prüfung bestehen, mit jedem Startwert.</translation>
    </message>
    <message>
        <source>The solution was changed where this difference changes it. Mend the lines after @@ so that they say what stands in the solution now, and what stands here instead.</source>
        <translation>Die Lösung wurde dort geändert, wo dieser Unterschied sie ändert. Bring die Zeilen nach @@ in Ordnung: was jetzt in der Lösung steht, und was hier stattdessen steht.</translation>
    </message>
    <message>
        <source>It is kept as its difference from the solution, which is marked, and follows it.</source>
        <translation>Gespeichert ist sein Unterschied zur Lösung, der markiert ist; so folgt es ihr.</translation>
    </message>
    <message>
        <source>The starter for students who read %1: the same code, with comments in that language. Without it they get starter.lua.</source>
        <translation>Das Startprogramm für Studierende, die %1 lesen: derselbe Code mit Kommentaren in dieser Sprache. Ohne es bekommen sie starter.lua.</translation>
    </message>
</context>
<context>
    <name>cradle::ProgramsTab</name>
    <message>
        <source>-- What went wrong, in a few words
--
-- What was observed, what it means, and where to look.
</source>
        <translation>-- Was schiefging, in wenigen Worten
--
-- Was zu sehen war, was es bedeutet und wo man nachsieht.
</translation>
    </message>
    <message>
        <source>-- What is good about it, in a few words
--
-- What it does otherwise than most, and what that is worth.
</source>
        <translation>-- Was daran gut ist, in wenigen Worten
--
-- Was es anders macht als die meisten und was das wert ist.
</translation>
    </message>
    <message>
        <source>Add a mistake</source>
        <translation>Fehler hinzufügen</translation>
    </message>
    <message>
        <source>Add a remark</source>
        <translation>Anmerkung hinzufügen</translation>
    </message>
    <message>
        <source>Remove a program</source>
        <translation>Programm entfernen</translation>
    </message>
    <message>
        <source>Rename a program</source>
        <translation>Programm umbenennen</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Programs of the step</source>
        <translation>Programme des Schritts</translation>
    </message>
    <message>
        <source>Add a program</source>
        <translation>Programm hinzufügen</translation>
    </message>
    <message>
        <source>Rename the program</source>
        <translation>Programm umbenennen</translation>
    </message>
    <message>
        <source>Remove the program</source>
        <translation>Programm entfernen</translation>
    </message>
    <message>
        <source>A &amp;mistake that students make</source>
        <translation>Ein &amp;Fehler, den Studierende machen</translation>
    </message>
    <message>
        <source>A &amp;remark on work that passes</source>
        <translation>Eine &amp;Anmerkung zu Arbeiten, die bestehen</translation>
    </message>
    <message>
        <source>Take over a mistake</source>
        <translation>Einen Fehler übernehmen</translation>
    </message>
</context>
<context>
    <name>cradle::ProofMatrix</name>
    <message>
        <source>Programs and the checks that they fail</source>
        <translation>Programme und die Prüfungen, an denen sie scheitern</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Said of it</source>
        <translation>Erkannt als</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>besteht</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>Check %1</source>
        <translation>Prüfung %1</translation>
    </message>
    <message>
        <source>not recognised</source>
        <translation>nicht erkannt</translation>
    </message>
    <message>
        <source>Just wrong enough</source>
        <translation>Gerade falsch genug</translation>
    </message>
    <message>
        <source>%1: turned by %2, too fast by %3, adrift by %4</source>
        <translation>%1: gedreht um %2, zu schnell um %3, weggetrieben um %4</translation>
    </message>
    <message>
        <source>%1: not measured</source>
        <translation>%1: nicht gemessen</translation>
    </message>
    <message>
        <source>By how much a right run must be turned, too fast or adrift, or how wrong restitution and masses must be in its first hit, for the check to fail it</source>
        <translation>Um wie viel ein richtiger Lauf gedreht, zu schnell oder abgetrieben sein muss, oder wie falsch Stoßzahl und Massen in seinem ersten Stoß, damit er an der Prüfung scheitert</translation>
    </message>
    <message>
        <source>; a hit with %1</source>
        <translation>; ein Stoß mit %1</translation>
    </message>
</context>
<context>
    <name>cradle::ProofTab</name>
    <message>
        <source>All is as it should be: the solution passes, every mistake fails and is recognised, every check is needed.</source>
        <translation>Alles ist, wie es sein soll: Die Lösung besteht, jeder Fehler scheitert und wird erkannt, jede Prüfung wird gebraucht.</translation>
    </message>
    <message>
        <source>Not as it should be: %1</source>
        <translation>Nicht, wie es sein soll: %1</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Mistakes that this step does not know</source>
        <translation>Fehler, die dieser Schritt nicht kennt</translation>
    </message>
    <message>
        <source>None was found: each change of the solution is caught and explained.</source>
        <translation>Keiner gefunden: Jede Änderung der Lösung wird bemerkt und erklärt.</translation>
    </message>
    <message>
        <source>Show the run</source>
        <translation>Lauf zeigen</translation>
    </message>
    <message>
        <source>Open the program</source>
        <translation>Programm öffnen</translation>
    </message>
    <message>
        <source>Open the check</source>
        <translation>Prüfung öffnen</translation>
    </message>
    <message>
        <source>Open the programs</source>
        <translation>Programme öffnen</translation>
    </message>
    <message>
        <source>Add as a mistake</source>
        <translation>Als Fehler aufnehmen</translation>
    </message>
    <message>
        <source>Add a suggested mistake</source>
        <translation>Vorgeschlagenen Fehler aufnehmen</translation>
    </message>
    <message>
        <source>Verify this step</source>
        <translation>Diesen Schritt nachweisen</translation>
    </message>
    <message>
        <source>Judges every program of the step, the solution with five seeds</source>
        <translation>Beurteilt jedes Programm des Schritts, die Lösung mit fünf Startwerten</translation>
    </message>
    <message>
        <source>Verify the lab</source>
        <translation>Das Lab nachweisen</translation>
    </message>
    <message>
        <source>Suggest mistakes</source>
        <translation>Fehler vorschlagen</translation>
    </message>
    <message>
        <source>Changes the solution as students err, and tells which changes the checks miss or cannot explain</source>
        <translation>Ändert die Lösung so, wie Studierende irren, und sagt, welche Änderungen die Prüfungen übersehen oder nicht erklären</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Progress of the proof</source>
        <translation>Fortschritt des Nachweises</translation>
    </message>
    <message>
        <source>The lab was edited since.</source>
        <translation>Das Lab wurde seitdem geändert.</translation>
    </message>
    <message>
        <source>Press Verify this step: the starter should fail by a check, the solution pass with every seed, and each mistake fail and be recognised.</source>
        <translation>Drücke „Diesen Schritt nachweisen“: Das Startprogramm soll an einer Prüfung scheitern, die Lösung mit jedem Startwert bestehen, und jeder Fehler soll scheitern und erkannt werden.</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>Passes every check, so one is missing: %1 (%2)</source>
        <translation>Besteht jede Prüfung, also fehlt eine: %1 (%2)</translation>
    </message>
    <message>
        <source>Fails by “%1” without a word on why: %2 (%3)</source>
        <translation>Scheitert an „%1“, ohne dass gesagt wird, warum: %2 (%3)</translation>
    </message>
    <message>
        <source>So it is in every step of the lab.</source>
        <translation>So ist es in jedem Schritt des Labs.</translation>
    </message>
    <message>
        <source>Not as it should be in other steps: %1</source>
        <translation>Nicht, wie es sein soll, in anderen Schritten: %1</translation>
    </message>
    <message>
        <source>Open the scene</source>
        <translation>Szene öffnen</translation>
    </message>
    <message>
        <source>Every program runs through the checks…</source>
        <translation>Jedes Programm durchläuft die Prüfungen…</translation>
    </message>
    <message>
        <source>The solution passes, and every mistake fails and is recognised; but a check is missing: changes of the solution that pass every check: %1</source>
        <translation>Die Lösung besteht, jeder Fehler scheitert und wird erkannt; aber eine Prüfung fehlt: Änderungen der Lösung, die jede Prüfung bestehen: %1</translation>
    </message>
    <message>
        <source>All is as it should be: the solution passes, every mistake fails and is recognised.</source>
        <translation>Alles ist, wie es sein soll: Die Lösung besteht, jeder Fehler scheitert und wird erkannt.</translation>
    </message>
    <message>
        <source>Worth a look</source>
        <translation>Einen Blick wert</translation>
    </message>
    <message>
        <source>Mistakes that this step did not know before the last edits</source>
        <translation>Fehler, die dieser Schritt vor den letzten Änderungen nicht kannte</translation>
    </message>
    <message>
        <source>Fails by “%1”; students read: “%2”, of: %3 (%4)</source>
        <translation>Scheitert an „%1“; zu lesen ist „%2“, bei: %3 (%4)</translation>
    </message>
</context>
<context>
    <name>cradle::QuestionField</name>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number with its unit</source>
        <translation>eine Zahl mit ihrer Einheit</translation>
    </message>
    <message>
        <source>In a few sentences, for the teacher</source>
        <translation>In ein paar Sätzen, für die Lehrkraft</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation>Alt+Auf</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation>Alt+Ab</translation>
    </message>
</context>
<context>
    <name>cradle::QuestionsCard</name>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>The check counts your answers.</source>
        <translation>Die Prüfung zählt deine Antworten mit.</translation>
    </message>
    <message>
        <source>%1 (%2 points)</source>
        <translation>%1 (%2 Punkte)</translation>
    </message>
</context>
<context>
    <name>cradle::QuestionsEditor</name>
    <message>
        <source>Questions · %1</source>
        <translation>Fragen · %1</translation>
    </message>
    <message>
        <source>Answers in the right order; students find them in another</source>
        <translation>Antworten in der richtigen Reihenfolge; gezeigt werden sie in einer anderen</translation>
    </message>
    <message>
        <source>Answers; mark the right one</source>
        <translation>Antworten; markiere die richtige</translation>
    </message>
    <message>
        <source>Answers; mark all that are right</source>
        <translation>Antworten; markiere alle richtigen</translation>
    </message>
    <message>
        <source>A new question</source>
        <translation>Eine neue Frage</translation>
    </message>
    <message>
        <source>What is asked?</source>
        <translation>Wonach wird gefragt?</translation>
    </message>
    <message>
        <source>The first answer</source>
        <translation>Die erste Antwort</translation>
    </message>
    <message>
        <source>The second answer</source>
        <translation>Die zweite Antwort</translation>
    </message>
    <message>
        <source>A title of 1 to 200 characters is right</source>
        <translation>Richtig ist ein Titel von 1 bis 200 Zeichen</translation>
    </message>
    <message>
        <source>Another question has this id already</source>
        <translation>Eine andere Frage hat diese Kennung schon</translation>
    </message>
    <message>
        <source>Tolerance: a number from 0 is right</source>
        <translation>Toleranz: Richtig ist eine Zahl ab 0</translation>
    </message>
    <message>
        <source>%1 is no unit; one like m/s, kg m/s, N s, J, ° or % is right</source>
        <translation>%1 ist keine Einheit; richtig ist eine wie m/s, kg m/s, N s, J, ° oder %</translation>
    </message>
    <message>
        <source>Another answer</source>
        <translation>Noch eine Antwort</translation>
    </message>
    <message>
        <source>Questions of the step</source>
        <translation>Fragen des Schritts</translation>
    </message>
    <message>
        <source>Add a question</source>
        <translation>Frage hinzufügen</translation>
    </message>
    <message>
        <source>Remove the question</source>
        <translation>Frage entfernen</translation>
    </message>
    <message>
        <source>Move the question up</source>
        <translation>Frage nach oben</translation>
    </message>
    <message>
        <source>Move the question down</source>
        <translation>Frage nach unten</translation>
    </message>
    <message>
        <source>This step asks no question that counts. Add one with the plus: a number with its unit, a choice, an order, or a text that you read yourself.</source>
        <translation>Dieser Schritt stellt keine Frage, die zählt. Füge mit dem Plus eine hinzu: eine Zahl mit ihrer Einheit, eine Auswahl, eine Reihenfolge oder einen Text, den du selbst liest.</translation>
    </message>
    <message>
        <source>A number</source>
        <translation>Eine Zahl</translation>
    </message>
    <message>
        <source>One choice</source>
        <translation>Einfachauswahl</translation>
    </message>
    <message>
        <source>Several choices</source>
        <translation>Mehrfachauswahl</translation>
    </message>
    <message>
        <source>An order</source>
        <translation>Eine Reihenfolge</translation>
    </message>
    <message>
        <source>A text for the teacher</source>
        <translation>Ein Text für die Lehrkraft</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Kind of the question</source>
        <translation>Art der Frage</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Right number</source>
        <translation>Richtige Zahl</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Reports name the question by it</source>
        <translation>Berichte nennen die Frage so</translation>
    </message>
    <message>
        <source>What a right answer is worth; of a text, what you may give</source>
        <translation>Was eine richtige Antwort wert ist; bei einem Text, was du geben kannst</translation>
    </message>
    <message>
        <source>A number, or an expression like 2*9.81*5</source>
        <translation>Eine Zahl oder ein Ausdruck wie 2*9.81*5</translation>
    </message>
    <message>
        <source>How far off is still right, in the unit</source>
        <translation>Wie weit daneben noch richtig ist, in der Einheit</translation>
    </message>
    <message>
        <source>Such as m/s, kg m/s, N s, J, ° or %; answers in other units of the same kind are converted</source>
        <translation>Etwa m/s, kg m/s, N s, J, ° oder %; Antworten in anderen Einheiten derselben Art werden umgerechnet</translation>
    </message>
    <message>
        <source>What is asked</source>
        <translation>Wonach gefragt wird</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Add an answer</source>
        <translation>Antwort hinzufügen</translation>
    </message>
    <message>
        <source>Remove the answer</source>
        <translation>Antwort entfernen</translation>
    </message>
    <message>
        <source>Move the answer up</source>
        <translation>Antwort nach oben</translation>
    </message>
    <message>
        <source>Move the answer down</source>
        <translation>Antwort nach unten</translation>
    </message>
    <message>
        <source>What the student sees, answered rightly</source>
        <translation>Was zu sehen ist, richtig beantwortet</translation>
    </message>
</context>
<context>
    <name>cradle::RemarkEditor</name>
    <message>
        <source>A student&apos;s program that passes is run beside this one and beside the solution. Where these two differ and the student&apos;s does as this one, the remark is made.</source>
        <translation>Ein Programm, das besteht, läuft neben diesem und neben der Lösung. Wo diese beiden sich unterscheiden und es dasselbe tut wie dieses, erscheint die Anmerkung.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>Was verglichen wird</translation>
    </message>
    <message>
        <source>Velocities: they differ at a hit</source>
        <translation>Geschwindigkeiten: Sie unterscheiden sich bei einem Stoß</translation>
    </message>
    <message>
        <source>Positions: they differ in many steps</source>
        <translation>Orte: Sie unterscheiden sich in vielen Zeitschritten</translation>
    </message>
    <message>
        <source>Fields: numbers that the program keeps with the circles, as mass</source>
        <translation>Felder: Zahlen, die das Programm bei den Kreisen ablegt, wie mass</translation>
    </message>
</context>
<context>
    <name>cradle::ReportDialog</name>
    <message>
        <source>Looking back at %1</source>
        <translation>Rückblick auf %1</translation>
    </message>
    <message>
        <source>The steps of the lab, and what was hard</source>
        <translation>Die Schritte des Labs, und was schwer war</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Bericht…</translation>
    </message>
    <message>
        <source>&amp;Hand in…</source>
        <translation>&amp;Abgeben…</translation>
    </message>
    <message>
        <source>Every step is judged once more…</source>
        <translation>Jeder Schritt wird noch einmal geprüft…</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Documents (*.pdf);;Web pages (*.html)</source>
        <translation>Dokumente (*.pdf);;Webseiten (*.html)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
</context>
<context>
    <name>cradle::ResultPane</name>
    <message>
        <source>Checking… %1 of %2</source>
        <translation>Prüfung läuft… %1 von %2</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Prüfung läuft…</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Press Check (Ctrl+Return) when you are done.</source>
        <translation>Drücke „Prüfen“ (Strg+Eingabe), wenn du fertig bist.</translation>
    </message>
    <message>
        <source>Changed since this check</source>
        <translation>Seit dieser Prüfung geändert</translation>
    </message>
    <message>
        <source>✓ Passed: the check</source>
        <translation>✓ Bestanden: die Prüfung</translation>
    </message>
    <message>
        <source>✓ Passed: all %1 checks</source>
        <translation>✓ Bestanden: alle %1 Prüfungen</translation>
    </message>
    <message>
        <source>Next step ▸</source>
        <translation>Nächster Schritt ▸</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>Commit message</source>
        <translation>Commit-Nachricht</translation>
    </message>
    <message>
        <source>Copy the commit message</source>
        <translation>Die Commit-Nachricht kopieren</translation>
    </message>
    <message>
        <source>Not yet: %1</source>
        <translation>Noch nicht: %1</translation>
    </message>
    <message>
        <source>That was the last step.</source>
        <translation>Das war der letzte Schritt.</translation>
    </message>
    <message>
        <source>Still open: %1</source>
        <translation>Noch offen: %1</translation>
    </message>
    <message>
        <source>Line %1 ▸</source>
        <translation>Zeile %1 ▸</translation>
    </message>
    <message>
        <source>Show line %1 of the program</source>
        <translation>Zeile %1 des Programms zeigen</translation>
    </message>
    <message>
        <source>Next step (Ctrl+Page Down)</source>
        <translation>Nächster Schritt (Strg+Bild ab)</translation>
    </message>
    <message>
        <source>Compare with the reference</source>
        <translation>Musterlösung zeigen</translation>
    </message>
    <message>
        <source>Shows the reference solution beside your program</source>
        <translation>Zeigt die Musterlösung neben deinem Programm</translation>
    </message>
    <message>
        <source>✓ You have passed this step</source>
        <translation>✓ Diesen Schritt hast du geschafft</translation>
    </message>
    <message>
        <source>Nothing to check: this scene belongs to no step.</source>
        <translation>Nichts zu prüfen: Diese Szene gehört zu keinem Schritt.</translation>
    </message>
    <message>
        <source>on %1 at %2</source>
        <translation>am %1 um %2</translation>
    </message>
    <message>
        <source>✓ Passed: all %1 checks and answers</source>
        <translation>✓ Bestanden: alle %1 Prüfungen und Antworten</translation>
    </message>
    <message>
        <source>Compare with the reference ▸</source>
        <translation>Mit der Musterlösung vergleichen ▸</translation>
    </message>
    <message>
        <source>The step counts as passed as soon as the run of this work was shown.</source>
        <translation>Der Schritt gilt als bestanden, sobald der Lauf dieser Arbeit gezeigt wurde.</translation>
    </message>
    <message>
        <source>Back to the scene that passed ▸</source>
        <translation>Zurück zur bestandenen Szene ▸</translation>
    </message>
    <message>
        <source>Back to the scene that passed</source>
        <translation>Zurück zur bestandenen Szene</translation>
    </message>
    <message>
        <source>Sets the values with which you passed this step; Undo takes that back</source>
        <translation>Setzt die Werte, mit denen du diesen Schritt geschafft hast; Rückgängig nimmt das zurück</translation>
    </message>
</context>
<context>
    <name>cradle::RowsList</name>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation>Alt+Auf</translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation>Alt+Ab</translation>
    </message>
</context>
<context>
    <name>cradle::RunDesk</name>
    <message numerus="yes">
        <source>%n runs are pinned; remove one of them first.</source>
        <translation>
            <numerusform>%n Lauf ist angeheftet; entferne ihn zuerst.</numerusform>
            <numerusform>%n Läufe sind angeheftet; entferne zuerst einen davon.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no run yet: press Run, then pin it.</source>
        <translation>Es gibt noch keinen Lauf: Drücke „Starten“, dann hefte ihn an.</translation>
    </message>
    <message>
        <source>Your program sets values of circles when it is loaded: the new run starts with those.</source>
        <translation>Dein Programm setzt beim Laden Werte von Kreisen: Mit denen beginnt der neue Lauf.</translation>
    </message>
    <message>
        <source>Save the data of the run</source>
        <translation>Daten des Laufs speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
</context>
<context>
    <name>cradle::SceneActions</name>
    <message>
        <source>Cu&amp;t circles</source>
        <translation>Kreise &amp;ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy circles</source>
        <translation>Kreise &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste circles</source>
        <translation>Kreise &amp;einfügen</translation>
    </message>
    <message>
        <source>&amp;Duplicate circles</source>
        <translation>Kreise &amp;duplizieren</translation>
    </message>
    <message>
        <source>Re&amp;move circles</source>
        <translation>Kreise ent&amp;fernen</translation>
    </message>
    <message>
        <source>Set velocities to &amp;zero</source>
        <translation>Geschwindigkeiten auf &amp;null setzen</translation>
    </message>
    <message>
        <source>Select a&amp;ll circles</source>
        <translation>A&amp;lle Kreise auswählen</translation>
    </message>
</context>
<context>
    <name>cradle::SceneDesk</name>
    <message>
        <source>Nothing hits anything within the next minute.</source>
        <translation>In der nächsten Minute stößt nichts zusammen.</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Musterlösung</translation>
    </message>
    <message>
        <source>so far in this step</source>
        <translation>bisher in diesem Schritt</translation>
    </message>
    <message>
        <source>This is a scene of the check, at the moment where it went wrong.</source>
        <translation>Das ist eine Szene der Prüfung, in dem Moment, in dem sie schiefging.</translation>
    </message>
    <message>
        <source>This is a scene of the check.</source>
        <translation>Das ist eine Szene der Prüfung.</translation>
    </message>
    <message>
        <source>Back to my scene</source>
        <translation>Zurück zu meiner Szene</translation>
    </message>
</context>
<context>
    <name>cradle::SceneEditor</name>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 duplizieren</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Set velocity of %1 to zero</source>
        <translation>Geschwindigkeit von %1 auf null setzen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Your program sets this circle in on_load; change it there</source>
        <translation>Dein Programm setzt diesen Kreis in on_load; ändere ihn dort</translation>
    </message>
    <message numerus="yes">
        <source>%n circles</source>
        <translation>
            <numerusform>%n Kreis</numerusform>
            <numerusform>%n Kreise</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste a circle</source>
        <translation>Einen Kreis einfügen</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n circles</source>
        <translation>
            <numerusform>%n Kreis einfügen</numerusform>
            <numerusform>%n Kreise einfügen</numerusform>
        </translation>
    </message>
    <message>
        <source>Press Restart (R) to change the start, or start a new run from here (Ctrl+Shift+R)</source>
        <translation>Drücke „Neustart“ (R), um den Anfang zu ändern, oder beginne hier einen neuen Lauf (Strg+Umschalt+R)</translation>
    </message>
</context>
<context>
    <name>cradle::SceneForm</name>
    <message>
        <source>Kind of the scenes</source>
        <translation>Art der Szenen</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
</context>
<context>
    <name>cradle::SceneTab</name>
    <message>
        <source>Take the template %1</source>
        <translation>Vorlage %1 nehmen</translation>
    </message>
    <message>
        <source>Lock…</source>
        <translation>Festlegen…</translation>
    </message>
    <message>
        <source>Locked: %1</source>
        <translation>Festgelegt: %1</translation>
    </message>
    <message>
        <source>Lock a field</source>
        <translation>Feld festlegen</translation>
    </message>
    <message>
        <source>Unlock a field</source>
        <translation>Feld freigeben</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Scenes to begin with; the one that is here is replaced</source>
        <translation>Szenen zum Anfangen; die jetzige wird ersetzt</translation>
    </message>
    <message>
        <source>Start from this moment</source>
        <translation>Ab diesem Moment starten</translation>
    </message>
    <message>
        <source>The circles start where, and as fast as, they are at the moment shown</source>
        <translation>Die Kreise starten dort und so schnell, wie sie im gezeigten Moment sind</translation>
    </message>
    <message>
        <source>What the student may not change in this step</source>
        <translation>Was in diesem Schritt nicht geändert werden darf</translation>
    </message>
    <message>
        <source>Back to the step&apos;s scene</source>
        <translation>Zurück zur Szene des Schritts</translation>
    </message>
    <message>
        <source>Moved by the scene&apos;s laws</source>
        <translation>Bewegt von den Gesetzen der Szene</translation>
    </message>
    <message>
        <source>Moved by solution.lua</source>
        <translation>Bewegt von solution.lua</translation>
    </message>
    <message>
        <source>What moves the circles here</source>
        <translation>Was die Kreise hier bewegt</translation>
    </message>
    <message>
        <source>Add the scene that passes</source>
        <translation>Bestehende Szene hinzufügen</translation>
    </message>
    <message>
        <source>Remove the scene that passes</source>
        <translation>Bestehende Szene entfernen</translation>
    </message>
    <message>
        <source>Remove this scene</source>
        <translation>Diese Szene entfernen</translation>
    </message>
    <message>
        <source>Students may also pass without a program, by setting the scene and its laws. This step has no scene yet that passes its checks so; with one, the proof looks after it, too.</source>
        <translation>Studierende können auch ohne Programm bestehen, indem sie die Szene und ihre Gesetze einstellen. Dieser Schritt hat noch keine Szene, die seine Prüfungen so besteht; gibt es eine, gilt der Nachweis auch ihr.</translation>
    </message>
    <message>
        <source>Make it from what the student finds</source>
        <translation>Aus der vorgefundenen Szene machen</translation>
    </message>
    <message>
        <source>What the student finds</source>
        <translation>Was Studierende vorfinden</translation>
    </message>
    <message>
        <source>What passes without a program</source>
        <translation>Was ohne Programm besteht</translation>
    </message>
    <message>
        <source>Which scene of the step</source>
        <translation>Welche Szene des Schritts</translation>
    </message>
    <message>
        <source>&amp;Rack…</source>
        <translation>&amp;Dreieck…</translation>
    </message>
    <message>
        <source>Gr&amp;id…</source>
        <translation>&amp;Gitter…</translation>
    </message>
    <message>
        <source>Ri&amp;ng…</source>
        <translation>&amp;Ring…</translation>
    </message>
    <message>
        <source>As text</source>
        <translation>Als Text</translation>
    </message>
    <message>
        <source>The file of this scene, in which numbers may be expressions</source>
        <translation>Die Datei dieser Szene, in der Zahlen Ausdrücke sein dürfen</translation>
    </message>
    <message>
        <source>Add a circle: + Add circle</source>
        <translation>Noch kein Kreis: + Kreis hinzufügen</translation>
    </message>
</context>
<context>
    <name>cradle::SceneText</name>
    <message>
        <source>Write the scene</source>
        <translation>Szene schreiben</translation>
    </message>
    <message>
        <source>Numbers may be expressions, in quotes: &quot;1 + 0.42*cos(pi/6)&quot;, &quot;20 cm&quot;, or with the lab&apos;s values, &quot;-e*v&quot;. What cannot be read stays here and is not in the lab yet.</source>
        <translation>Zahlen dürfen Ausdrücke in Anführungszeichen sein: &quot;1 + 0.42*cos(pi/6)&quot;, &quot;20 cm&quot;, oder mit den Werten des Labs, &quot;-e*v&quot;. Was nicht lesbar ist, bleibt hier stehen und ist noch nicht im Lab.</translation>
    </message>
    <message>
        <source>The scene as text</source>
        <translation>Die Szene als Text</translation>
    </message>
</context>
<context>
    <name>cradle::SceneView</name>
    <message>
        <source>first %1 s dropped</source>
        <translation>erste %1 s verworfen</translation>
    </message>
    <message>
        <source>first %1 min dropped</source>
        <translation>erste %1 min verworfen</translation>
    </message>
    <message>
        <source>Add a circle: Edit → Add circle (Ctrl+Shift+N)</source>
        <translation>Füge einen Kreis hinzu: Bearbeiten → Kreis hinzufügen (Strg+Umschalt+N)</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiterer</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>selected: %1</source>
        <translation>gewählt: %1</translation>
    </message>
    <message>
        <source>No circles</source>
        <translation>Keine Kreise</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Add circle here</source>
        <translation>Hier Kreis hinzufügen</translation>
    </message>
    <message>
        <source>Fit view</source>
        <translation>Ansicht einpassen</translation>
    </message>
    <message>
        <source>ghost: %1 · %2 m apart</source>
        <translation>Geist: %1 · %2 m entfernt</translation>
    </message>
    <message>
        <source>No exact motion beside more than %1 circles</source>
        <translation>Keine exakte Bewegung neben mehr als %1 Kreisen</translation>
    </message>
    <message>
        <source>No exact motion: the circles overlap or lie outside at the start</source>
        <translation>Keine exakte Bewegung: Die Kreise überlappen sich am Anfang oder liegen außerhalb</translation>
    </message>
    <message>
        <source>Exact motion; the run is %1 m off</source>
        <translation>Exakte Bewegung; der Lauf liegt %1 m daneben</translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n ausgewählt</numerusform>
            <numerusform>%n ausgewählt</numerusform>
        </translation>
    </message>
    <message>
        <source>Start a new run from here</source>
        <translation>Neuer Lauf ab hier</translation>
    </message>
    <message>
        <source>contacts merged from %1 s on</source>
        <translation>Kontakte ab %1 s zusammengefasst</translation>
    </message>
    <message>
        <source>%1 at %2 m with %3 m/s, radius %4 m</source>
        <translation>%1 bei %2 m mit %3 m/s, Radius %4 m</translation>
    </message>
    <message>
        <source>No hit at this moment: N goes on to the next one</source>
        <translation>Kein Stoß in diesem Moment: N geht weiter zum nächsten</translation>
    </message>
</context>
<context>
    <name>cradle::ShareDialog</name>
    <message>
        <source>Share with git</source>
        <translation>Mit git teilen</translation>
    </message>
    <message>
        <source>Your work is a git repository in %1. Its commits and versions can be sent to one of yours elsewhere; who may read that, reads all of them.</source>
        <translation>Deine Arbeit ist ein git-Repository in %1. Ihre Commits und Fassungen lassen sich an eines von dir anderswo senden; wer das lesen darf, liest sie alle.</translation>
    </message>
    <message>
        <source>&amp;Address:</source>
        <translation>&amp;Adresse:</translation>
    </message>
    <message>
        <source>Sent so far:</source>
        <translation>Bisher gesendet:</translation>
    </message>
    <message>
        <source>&amp;Send</source>
        <translation>&amp;Senden</translation>
    </message>
    <message>
        <source>All is sent.</source>
        <translation>Alles ist gesendet.</translation>
    </message>
    <message>
        <source>Sending…</source>
        <translation>Wird gesendet…</translation>
    </message>
    <message>
        <source>up to the commit of %1</source>
        <translation>bis zum Commit vom %1</translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>noch nichts</translation>
    </message>
</context>
<context>
    <name>cradle::SolutionView</name>
    <message>
        <source>Reference solution</source>
        <translation>Musterlösung</translation>
    </message>
    <message>
        <source>Close the reference solution (Esc)</source>
        <translation>Die Musterlösung schließen (Esc)</translation>
    </message>
    <message>
        <source>Close the reference solution</source>
        <translation>Die Musterlösung schließen</translation>
    </message>
</context>
<context>
    <name>cradle::Sounds</name>
    <message>
        <source>There is no sound here: no sound server (PulseAudio or PipeWire) could be reached. Everything else goes on.</source>
        <translation>Hier gibt es keinen Ton: Kein Klangserver (PulseAudio oder PipeWire) ist zu erreichen. Alles andere geht weiter.</translation>
    </message>
</context>
<context>
    <name>cradle::SpeedHistogram</name>
    <message>
        <source>Speeds</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>A distribution of speeds takes %1 circles or more: Lab → Example scenes → Gas has 1000</source>
        <translation>Eine Verteilung des Tempos braucht mindestens %1 Kreise: Lab → Beispielszenen → Gas hat 1000</translation>
    </message>
    <message>
        <source>Nothing moves yet: press Run</source>
        <translation>Noch bewegt sich nichts: Drücke „Starten“</translation>
    </message>
    <message>
        <source>%1 · v √(m/m̄) · kT = %2 J</source>
        <translation>%1 · v √(m/m̄) · kT = %2 J</translation>
    </message>
    <message>
        <source>%1 · kT = %2 J</source>
        <translation>%1 · kT = %2 J</translation>
    </message>
    <message>
        <source>share per %1 m/s, mean of 1 s</source>
        <translation>Anteil je %1 m/s, Mittel über 1 s</translation>
    </message>
    <message>
        <source>Maxwell–Boltzmann</source>
        <translation>Maxwell-Boltzmann</translation>
    </message>
    <message>
        <source>In equilibrium: distance from the curve %1, chance allows %2.</source>
        <translation>Im Gleichgewicht: Abstand von der Kurve %1, der Zufall erlaubt %2.</translation>
    </message>
    <message>
        <source>Not in equilibrium: distance from the curve %1, chance allows %2.</source>
        <translation>Nicht im Gleichgewicht: Abstand von der Kurve %1, der Zufall erlaubt %2.</translation>
    </message>
    <message>
        <source>Histogram of the speeds, m/s</source>
        <translation>Histogramm des Tempos, m/s</translation>
    </message>
    <message>
        <source>Distance from equilibrium</source>
        <translation>Abstand vom Gleichgewicht</translation>
    </message>
    <message>
        <source>The distance of Kolmogorov and Smirnov, at the moment shown: the greatest difference between the share of circles slower than a speed and what the curve says. Of a hundred gases in equilibrium one is further away by chance.</source>
        <translation>Der Abstand von Kolmogorow und Smirnow im gezeigten Moment: der größte Unterschied zwischen dem Anteil der Kreise, die langsamer sind als ein Tempo, und dem, was die Kurve sagt. Von hundert Gasen im Gleichgewicht ist eines durch Zufall weiter entfernt.</translation>
    </message>
</context>
<context>
    <name>cradle::SpeedPlot</name>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>%1 % faster</source>
        <translation>%1 % schneller</translation>
    </message>
    <message>
        <source>%1 to %2 m/s: %3 %, the curve %4 %</source>
        <translation>%1 bis %2 m/s: %3 %, die Kurve %4 %</translation>
    </message>
</context>
<context>
    <name>cradle::StepDesk</name>
    <message>
        <source># %1

This scene belongs to no step: play with it. Choose a step above to go back to the lab.</source>
        <translation># %1

Diese Szene gehört zu keinem Schritt: Spiel mit ihr. Wähle oben einen Schritt, um zum Lab zurückzukehren.</translation>
    </message>
    <message>
        <source>A scene of your own</source>
        <translation>Eine eigene Szene</translation>
    </message>
    <message>
        <source>Explore</source>
        <translation>Erkunden</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
</context>
<context>
    <name>cradle::StepDots</name>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>current</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
</context>
<context>
    <name>cradle::StepFields</name>
    <message>
        <source>Rename the step&apos;s folder</source>
        <translation>Ordner des Schritts umbenennen</translation>
    </message>
    <message>
        <source>Edit the step</source>
        <translation>Schritt ändern</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Id of the step, and its folder</source>
        <translation>Kennung des Schritts und sein Ordner</translation>
    </message>
    <message>
        <source>Letters, digits, dots and dashes; also the name of the folder</source>
        <translation>Buchstaben, Ziffern, Punkte und Striche; auch der Name des Ordners</translation>
    </message>
    <message>
        <source>Commit message</source>
        <translation>Commit-Nachricht</translation>
    </message>
    <message>
        <source>What a student writes into the history after passing</source>
        <translation>Was nach dem Bestehen in die Versionsgeschichte kommt</translation>
    </message>
    <message>
        <source>Extra step</source>
        <translation>Zusatzschritt</translation>
    </message>
    <message>
        <source>Outside the lab&apos;s own count</source>
        <translation>Außerhalb der Zählung des Labs</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Title of the step</source>
        <translation>Titel des Schritts</translation>
    </message>
    <message>
        <source>In the language that is open; also in the list of steps (F2)</source>
        <translation>In der geöffneten Sprache; auch in der Liste der Schritte (F2)</translation>
    </message>
    <message>
        <source>Moved by program or laws</source>
        <translation>Bewegt: Programm oder Gesetze</translation>
    </message>
    <message>
        <source>Moved by a program</source>
        <translation>Bewegt: ein Programm</translation>
    </message>
    <message>
        <source>Moved by the laws</source>
        <translation>Bewegt: die Gesetze</translation>
    </message>
    <message>
        <source>Who may move the circles</source>
        <translation>Wer die Kreise bewegen darf</translation>
    </message>
    <message>
        <source>What passes the step: a program of the student, the laws of the scene, or either</source>
        <translation>Womit der Schritt bestanden wird: mit einem eigenen Programm, mit den Gesetzen der Szene oder gleich womit</translation>
    </message>
</context>
<context>
    <name>cradle::StepsList</name>
    <message>
        <source>extra</source>
        <translation>extra</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>current</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Steps · %1 of %2</source>
        <translation>Schritte · %1 von %2</translation>
    </message>
    <message>
        <source>Steps passed</source>
        <translation>Bestandene Schritte</translation>
    </message>
    <message>
        <source>1 file of this lab could not be read</source>
        <translation>1 Datei dieses Labs konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>%1 files of this lab could not be read</source>
        <translation>%1 Dateien dieses Labs konnten nicht gelesen werden</translation>
    </message>
    <message>
        <source>Close ▴</source>
        <translation>Schließen ▴</translation>
    </message>
    <message>
        <source>All steps ▾</source>
        <translation>Alle Schritte ▾</translation>
    </message>
    <message>
        <source>Close the list of steps</source>
        <translation>Liste der Schritte schließen</translation>
    </message>
    <message>
        <source>All steps, %1</source>
        <translation>Alle Schritte, %1</translation>
    </message>
    <message>
        <source>Search the steps</source>
        <translation>Schritte durchsuchen</translation>
    </message>
</context>
<context>
    <name>cradle::StepsPanel</name>
    <message>
        <source>Add a step</source>
        <translation>Schritt hinzufügen</translation>
    </message>
    <message>
        <source>New step</source>
        <translation>Neuer Schritt</translation>
    </message>
    <message>
        <source>Duplicate the step</source>
        <translation>Schritt duplizieren</translation>
    </message>
    <message>
        <source>Remove the step</source>
        <translation>Schritt entfernen</translation>
    </message>
    <message>
        <source>Rename the step</source>
        <translation>Schritt umbenennen</translation>
    </message>
    <message>
        <source>Move the step</source>
        <translation>Schritt verschieben</translation>
    </message>
    <message>
        <source>Steps · %1</source>
        <translation>Schritte · %1</translation>
    </message>
    <message>
        <source>Steps of the lab</source>
        <translation>Schritte des Labs</translation>
    </message>
    <message>
        <source>Move the step up</source>
        <translation>Schritt nach oben</translation>
    </message>
    <message>
        <source>Move the step down</source>
        <translation>Schritt nach unten</translation>
    </message>
    <message>
        <source>Title, version and id of the lab</source>
        <translation>Titel, Version und Kennung des Labs</translation>
    </message>
    <message>
        <source>Files that the step did not use stay: %1</source>
        <translation>Dateien, die der Schritt nicht benutzt hat, bleiben: %1</translation>
    </message>
</context>
<context>
    <name>cradle::TextTab</name>
    <message>
        <source>No text in this language yet: students read it in the lab&apos;s own.</source>
        <translation>Noch kein Text in dieser Sprache: Gelesen wird der in der Sprache des Labs.</translation>
    </message>
    <message>
        <source>No hint yet: add one with the plus above.</source>
        <translation>Noch kein Hinweis: Füge oben mit dem Plus einen hinzu.</translation>
    </message>
    <message>
        <source>Line %1: nothing here is called “%2”</source>
        <translation>Zeile %1: Nichts heißt hier „%2“</translation>
    </message>
    <message>
        <source>%1, and %2 more</source>
        <translation>%1, und %2 weitere</translation>
    </message>
    <message>
        <source>Edit the text</source>
        <translation>Text ändern</translation>
    </message>
    <message>
        <source>Edit a hint</source>
        <translation>Hinweis ändern</translation>
    </message>
    <message>
        <source>Change the hints</source>
        <translation>Hinweise ändern</translation>
    </message>
    <message>
        <source>Instructions</source>
        <translation>Anleitung</translation>
    </message>
    <message>
        <source>Hints without a program</source>
        <translation>Hinweise ohne Programm</translation>
    </message>
    <message>
        <source>Hints for a program</source>
        <translation>Hinweise für ein Programm</translation>
    </message>
    <message>
        <source>As seen in Code mode</source>
        <translation>Wie im Modus Code</translation>
    </message>
    <message>
        <source>As seen in Explore mode</source>
        <translation>Wie im Modus Erkunden</translation>
    </message>
    <message>
        <source>Which text</source>
        <translation>Welcher Text</translation>
    </message>
    <message>
        <source>Mode of the preview</source>
        <translation>Modus der Vorschau</translation>
    </message>
    <message>
        <source>Insert the scene as a figure</source>
        <translation>Szene als Abbildung einfügen</translation>
    </message>
    <message>
        <source>Draws the moment that the Scene tab shows, with its arrows, as an SVG in the step&apos;s folder</source>
        <translation>Zeichnet den Moment aus dem Reiter Szene mit seinen Pfeilen als SVG in den Ordner des Schritts</translation>
    </message>
    <message>
        <source>Text in Markdown</source>
        <translation>Text in Markdown</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Names in backticks that neither the scene nor the programs have</source>
        <translation>Namen in Backticks, die weder in der Szene noch in den Programmen vorkommen</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>Vorhersage</translation>
    </message>
    <message>
        <source>Edit the prediction</source>
        <translation>Vorhersage ändern</translation>
    </message>
    <message>
        <source>Questions that count</source>
        <translation>Fragen, die zählen</translation>
    </message>
    <message>
        <source>Edit the questions</source>
        <translation>Fragen ändern</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
</context>
<context>
    <name>cradle::Timeline</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>hit %1</source>
        <translation>Stoß %1</translation>
    </message>
    <message>
        <source>hits %1–%2</source>
        <translation>Stöße %1–%2</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>The step shown. Left and Right go a step, Page Up and Page Down to the previous and the next hit.</source>
        <translation>Der gezeigte Schritt. Pfeil links und rechts gehen einen Schritt, Bild auf und Bild ab zum vorigen und zum nächsten Stoß.</translation>
    </message>
    <message>
        <source>Drag to any moment</source>
        <translation>Zieh zu einem beliebigen Moment</translation>
    </message>
    <message>
        <source>program stopped in line %1</source>
        <translation>Programm brach in Zeile %1 ab</translation>
    </message>
    <message>
        <source>program stopped</source>
        <translation>Programm brach ab</translation>
    </message>
</context>
<context>
    <name>cradle::Tour</name>
    <message>
        <source>End the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>Tour of the window</source>
        <translation>Rundgang durch das Fenster</translation>
    </message>
    <message>
        <source>%1 of %2 · %3</source>
        <translation>%1 von %2 · %3</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Anfangen</translation>
    </message>
    <message>
        <source>Next ▸</source>
        <translation>Weiter ▸</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
</context>
<context>
    <name>cradle::TransportBar</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Stop the check</source>
        <translation>Die Prüfung abbrechen</translation>
    </message>
    <message>
        <source>Check this step</source>
        <translation>Diesen Schritt prüfen</translation>
    </message>
    <message>
        <source>t = %1 s</source>
        <translation>t = %1 s</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neustart</translation>
    </message>
    <message>
        <source>Back to the start of the run</source>
        <translation>Zurück zum Anfang des Laufs</translation>
    </message>
    <message>
        <source>Step back</source>
        <translation>Schritt zurück</translation>
    </message>
    <message>
        <source>Step</source>
        <comment>back</comment>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>One step back</source>
        <translation>Einen Schritt zurück</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>One step on</source>
        <translation>Einen Schritt weiter</translation>
    </message>
    <message>
        <source>Run or pause</source>
        <translation>Starten oder Pause</translation>
    </message>
    <message>
        <source>Next hit</source>
        <translation>Nächster Stoß</translation>
    </message>
    <message>
        <source>Run on to the next collision</source>
        <translation>Bis zum nächsten Stoß weiterlaufen</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Simulated time per real time ([ slower, ] faster)</source>
        <translation>Simulierte Zeit je wirklicher Zeit ([ langsamer, ] schneller)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Steps since the start</source>
        <translation>Schritte seit dem Anfang</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Fortschritt der Prüfung</translation>
    </message>
    <message>
        <source>Previous hit</source>
        <translation>Voriger Stoß</translation>
    </message>
    <message>
        <source>Back to the collision before, or to the start</source>
        <translation>Zurück zum vorigen Stoß oder zum Anfang</translation>
    </message>
    <message>
        <source>Stop</source>
        <comment>search</comment>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>End the search and go back to where it began</source>
        <translation>Die Suche beenden und dorthin zurückgehen, wo sie begann</translation>
    </message>
    <message>
        <source>Progress of the search for a hit</source>
        <translation>Fortschritt der Suche nach einem Stoß</translation>
    </message>
    <message>
        <source>Speed now</source>
        <translation>Tempo jetzt</translation>
    </message>
    <message>
        <source>How fast it goes now: slower around a hit, if that is chosen</source>
        <translation>Wie schnell es jetzt geht: um einen Stoß herum langsamer, wenn das gewählt ist</translation>
    </message>
</context>
<context>
    <name>cradle::UndoActions</name>
    <message>
        <source>typing</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
</context>
<context>
    <name>cradle::ValuesEditor</name>
    <message>
        <source>Values · %1</source>
        <translation>Werte · %1</translation>
    </message>
    <message>
        <source>%1: from %2 to %3, drawn</source>
        <translation>%1: von %2 bis %3, gezogen</translation>
    </message>
    <message>
        <source>%1 (whole lab)</source>
        <translation>%1 (ganzes Lab)</translation>
    </message>
    <message>
        <source>Write {{%1}} in texts, programs and checks; in scenes and other values %1 alone.</source>
        <translation>In Texten, Programmen und Prüfungen steht dafür {{%1}}, in Szenen und anderen Werten %1 allein.</translation>
    </message>
    <message numerus="yes">
        <source>Each student gets one of %n number(s): %1. You, and who gives no number, have the first.</source>
        <translation>
            <numerusform>Alle Studierenden erhalten diese %n Zahl: %1.</numerusform>
            <numerusform>Wer das Lab bearbeitet, erhält eine von %n Zahlen: %1. Du und wer keine Nummer angibt, haben die erste.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing uses it yet.</source>
        <translation>Noch benutzt ihn nichts.</translation>
    </message>
    <message>
        <source>Used in %1.</source>
        <translation>Benutzt in %1.</translation>
    </message>
    <message>
        <source>Student %1 has %2 = %3</source>
        <translation>Nummer %1 hat %2 = %3</translation>
    </message>
    <message>
        <source>Edit a value</source>
        <translation>Wert ändern</translation>
    </message>
    <message>
        <source>A name of letters, digits and underscores that means nothing else, as sin does, is right</source>
        <translation>Richtig ist ein Name aus Buchstaben, Ziffern und Unterstrichen, der nichts anderes bedeutet wie etwa sin</translation>
    </message>
    <message>
        <source>Another value has this name already</source>
        <translation>Ein anderer Wert hat diesen Namen schon</translation>
    </message>
    <message>
        <source>There is a value %1 already</source>
        <translation>Einen Wert %1 gibt es schon</translation>
    </message>
    <message>
        <source>Edit the draw</source>
        <translation>Ziehung ändern</translation>
    </message>
    <message>
        <source>Add a value</source>
        <translation>Wert hinzufügen</translation>
    </message>
    <message>
        <source>Remove a value</source>
        <translation>Wert entfernen</translation>
    </message>
    <message>
        <source>Values of the lab and of the step</source>
        <translation>Werte des Labs und des Schritts</translation>
    </message>
    <message>
        <source>Remove the value</source>
        <translation>Wert entfernen</translation>
    </message>
    <message>
        <source>No number has a name yet. Add one with the plus, and write it in braces, as {{e}}, where texts, programs and checks need it: then it stands in one place, and may be another for each student.</source>
        <translation>Noch hat keine Zahl einen Namen. Füge mit dem Plus eine hinzu und schreibe sie in Klammern, als {{e}}, wo Texte, Programme und Prüfungen sie brauchen: Dann steht sie an einer Stelle und darf für alle Studierenden eine andere sein.</translation>
    </message>
    <message>
        <source>The same for all</source>
        <translation>Für alle gleich</translation>
    </message>
    <message>
        <source>Drawn for each student</source>
        <translation>Für jede Person gezogen</translation>
    </message>
    <message>
        <source>In the whole lab</source>
        <translation>Im ganzen Lab</translation>
    </message>
    <message>
        <source>In this step</source>
        <translation>In diesem Schritt</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Whether the value is drawn</source>
        <translation>Ob der Wert gezogen wird</translation>
    </message>
    <message>
        <source>Known</source>
        <translation>Bekannt</translation>
    </message>
    <message>
        <source>Where the value is known</source>
        <translation>Wo der Wert bekannt ist</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>Letters, digits and underscores</source>
        <translation>Buchstaben, Ziffern und Unterstriche</translation>
    </message>
    <message>
        <source>A number, or an expression like 2*k or sqrt(2*9.81*5), in the unit that its uses want</source>
        <translation>Eine Zahl oder ein Ausdruck wie 2*k oder sqrt(2*9.81*5), in der Einheit, die dort gebraucht wird, wo er steht</translation>
    </message>
    <message>
        <source>From one number to the next</source>
        <translation>Von einer Zahl zur nächsten</translation>
    </message>
    <message>
        <source>Student number</source>
        <translation>Matrikelnummer</translation>
    </message>
    <message>
        <source>Student number to try the draw with</source>
        <translation>Matrikelnummer, mit der die Ziehung versucht wird</translation>
    </message>
    <message>
        <source>To see what that student gets; it is kept nowhere</source>
        <translation>Um zu sehen, was diese Person erhält; sie wird nirgends aufbewahrt</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Ziehung</translation>
    </message>
    <message>
        <source>Draw of the lab</source>
        <translation>Ziehung des Labs</translation>
    </message>
    <message>
        <source>Another text draws other values: change it every year</source>
        <translation>Ein anderer Text zieht andere Werte: Ändere ihn jedes Jahr</translation>
    </message>
</context>
<context>
    <name>cradle::ValuesModel</name>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Position to the right of the middle</source>
        <translation>Ort rechts von der Mitte</translation>
    </message>
    <message>
        <source>Position above the middle</source>
        <translation>Ort über der Mitte</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Velocity to the right</source>
        <translation>Geschwindigkeit nach rechts</translation>
    </message>
    <message>
        <source>Velocity upwards</source>
        <translation>Geschwindigkeit nach oben</translation>
    </message>
    <message>
        <source>kg</source>
        <translation>kg</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>kg m/s</source>
        <translation>kg m/s</translation>
    </message>
    <message>
        <source>Momentum to the right</source>
        <translation>Impuls nach rechts</translation>
    </message>
    <message>
        <source>Momentum upwards</source>
        <translation>Impuls nach oben</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>kinetisch</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>Kinetic energy</source>
        <translation>Kinetische Energie</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>quantity, unit</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>All circles together</source>
        <translation>Alle Kreise zusammen</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>number unit</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Distance from the exact motion</source>
        <translation>Abstand von der exakten Bewegung</translation>
    </message>
    <message>
        <source>Total energy more than in the exact motion</source>
        <translation>Gesamtenergie über der exakten Bewegung</translation>
    </message>
</context>
<context>
    <name>cradle::ValuesPane</name>
    <message>
        <source>Hits</source>
        <translation>Stöße</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Values and hits</source>
        <translation>Werte und Stöße</translation>
    </message>
    <message>
        <source>Hits; Enter shows the moment</source>
        <translation>Stöße; Eingabe zeigt den Moment</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Alles kopieren</translation>
    </message>
    <message>
        <source>No hits yet: press Run or Next hit</source>
        <translation>Noch keine Stöße: Drücke „Starten“ oder „Nächster Stoß“</translation>
    </message>
    <message>
        <source>%1 •</source>
        <comment>a tab with news</comment>
        <translation>%1 •</translation>
    </message>
    <message>
        <source>Hits %1</source>
        <translation>Stöße %1</translation>
    </message>
</context>
<context>
    <name>cradle::ValuesTab</name>
    <message>
        <source>No hit so far.</source>
        <translation>Noch kein Stoß.</translation>
    </message>
    <message>
        <source>Values of the circles at the moment shown</source>
        <translation>Werte der Kreise im gezeigten Moment</translation>
    </message>
    <message>
        <source>Last hit</source>
        <translation>Letzter Stoß</translation>
    </message>
    <message>
        <source>Distance from the exact motion</source>
        <translation>Abstand von der exakten Bewegung</translation>
    </message>
</context>
<context>
    <name>cradle::VerdictDesk</name>
    <message>
        <source>Not yet: %1</source>
        <translation>Noch nicht: %1</translation>
    </message>
    <message>
        <source>Check passed.</source>
        <translation>Prüfung bestanden.</translation>
    </message>
</context>
<context>
    <name>cradle::VersionsList</name>
    <message>
        <source>Written</source>
        <translation>Geschrieben</translation>
    </message>
    <message>
        <source>Before it was replaced</source>
        <translation>Bevor sie ersetzt wurde</translation>
    </message>
    <message>
        <source>By another program</source>
        <translation>Von einem anderen Programm</translation>
    </message>
    <message>
        <source>From another window</source>
        <translation>Aus einem anderen Fenster</translation>
    </message>
    <message>
        <source>✓ passed</source>
        <translation>✓ bestanden</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>without: %1</source>
        <translation>ohne: %1</translation>
    </message>
    <message>
        <source>the same program</source>
        <translation>dasselbe Programm</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>First difference</source>
        <translation>Erster Unterschied</translation>
    </message>
    <message>
        <source>Versions of this step&apos;s program</source>
        <translation>Fassungen des Programms dieses Schritts</translation>
    </message>
</context>
<context>
    <name>cradle::VersionsPane</name>
    <message>
        <source>Versions</source>
        <translation>Fassungen</translation>
    </message>
    <message>
        <source>Every Check keeps a version of your program here, and so do ten minutes of writing.</source>
        <translation>Jede Prüfung bewahrt hier eine Fassung deines Programms auf, und ebenso zehn Minuten Schreiben.</translation>
    </message>
    <message>
        <source>The version</source>
        <translation>Die Fassung</translation>
    </message>
    <message>
        <source>Your program now</source>
        <translation>Dein Programm jetzt</translation>
    </message>
    <message>
        <source>&amp;Go back to this</source>
        <translation>&amp;Dahin zurück</translation>
    </message>
    <message>
        <source>Your program now becomes a version, so nothing is lost</source>
        <translation>Dein Programm von jetzt wird eine Fassung, es geht also nichts verloren</translation>
    </message>
    <message>
        <source>Back to what &amp;passed</source>
        <translation>Zur &amp;bestandenen Fassung</translation>
    </message>
    <message>
        <source>To the newest version that passed this step</source>
        <translation>Zur neuesten Fassung, die diesen Schritt bestand</translation>
    </message>
</context>
<context>
    <name>cradle::WaysBack</name>
    <message>
        <source>Back to the scene that passed</source>
        <translation>Zurück zur bestandenen Szene</translation>
    </message>
</context>
<context>
    <name>cradle::WorkDialogs</name>
    <message>
        <source>Nothing of this work is kept on a disk.</source>
        <translation>Von dieser Arbeit wird nichts auf einem Datenträger aufbewahrt.</translation>
    </message>
    <message>
        <source>Open a step of a lab first.</source>
        <translation>Öffne zuerst einen Schritt eines Labs.</translation>
    </message>
</context>
<context>
    <name>cradle::WorkJob</name>
    <message>
        <source>What you typed last could not be saved; on the disk your work is older. Save it first: the window says what is in the way.</source>
        <translation>Was du zuletzt getippt hast, konnte nicht gespeichert werden; auf der Platte ist deine Arbeit älter. Zuerst muss sie gespeichert sein: Das Fenster sagt, was im Weg ist.</translation>
    </message>
</context>
<context>
    <name>cradle::WorkNotices</name>
    <message>
        <source>Another program has changed your program. Its text is shown now; yours is among the versions of this step.</source>
        <translation>Ein anderes Programm hat dein Programm geändert. Jetzt steht sein Text da; deiner ist unter den Fassungen dieses Schritts.</translation>
    </message>
    <message>
        <source>Another program has changed your program while you typed. Yours stays; the other is among the versions of this step.</source>
        <translation>Ein anderes Programm hat dein Programm geändert, während du getippt hast. Deines bleibt; das andere ist unter den Fassungen dieses Schritts.</translation>
    </message>
    <message>
        <source>Another program has made %1 a file that is no program. It is kept as %2; what can be read of it is among the versions of this step.</source>
        <translation>Ein anderes Programm hat aus %1 eine Datei gemacht, die kein Programm ist. Sie ist als %2 aufbewahrt; was davon lesbar ist, steht unter den Fassungen dieses Schritts.</translation>
    </message>
    <message>
        <source>Your number</source>
        <translation>Deine Nummer</translation>
    </message>
    <message>
        <source>This lab draws its values for each student by the number that you hand in with.
Your number:</source>
        <translation>Dieses Lab zieht seine Werte für jede Person anhand der Nummer, mit der du abgibst.
Deine Nummer:</translation>
    </message>
    <message>
        <source>The values of this lab are those of nobody until you give your number: open the lab again for that.</source>
        <translation>Die Werte dieses Labs gelten für niemanden, bis du deine Nummer angibst: Öffne es dazu noch einmal.</translation>
    </message>
    <message>
        <source>Work that %1 handed in. Run it, check it, read its versions and notes: nothing of it is changed, and nothing of what it says about itself is believed.</source>
        <translation>Arbeit, die %1 abgegeben hat. Starte und prüfe sie, lies ihre Fassungen und Notizen: Nichts davon wird geändert, und nichts von dem, was sie über sich selbst sagt, wird geglaubt.</translation>
    </message>
    <message>
        <source>somebody</source>
        <translation>jemand</translation>
    </message>
    <message>
        <source>They write: “%1”</source>
        <translation>Dazu steht: „%1“</translation>
    </message>
    <message>
        <source>Make a program of it</source>
        <translation>Ein Programm daraus machen</translation>
    </message>
    <message>
        <source>Back to the newest version</source>
        <translation>Zurück zur neuesten Fassung</translation>
    </message>
    <message>
        <source>Begin this step anew</source>
        <translation>Diesen Schritt neu beginnen</translation>
    </message>
    <message>
        <source>The file of your program is no program, and is left as it is. %1 Whatever you choose, the file is kept beside it.</source>
        <translation>Die Datei deines Programms ist kein Programm und bleibt, wie sie ist. %1 Was du auch wählst, die Datei wird daneben aufbewahrt.</translation>
    </message>
    <message>
        <source>This step goes on from the one before, which you have not done. You begin with your own program.</source>
        <translation>Dieser Schritt baut auf dem vorigen auf, den du nicht gemacht hast. Du beginnst mit deinem eigenen Programm.</translation>
    </message>
    <message>
        <source>Begin with the solution of “%1”</source>
        <translation>Mit der Lösung von „%1“ beginnen</translation>
    </message>
    <message>
        <source>Read the step on the left, write your program in the middle, press Run to watch, and Check when you are done.</source>
        <translation>Lies links den Schritt, schreib in der Mitte dein Programm, drück „Starten“, um zuzusehen, und „Prüfen“, wenn du fertig bist.</translation>
    </message>
    <message>
        <source>Read the step on the left, set the values beside the scene, press Run to watch, and Check when you are done.</source>
        <translation>Lies links den Schritt, stell neben der Szene die Werte ein, drück „Starten“, um zuzusehen, und „Prüfen“, wenn du fertig bist.</translation>
    </message>
    <message>
        <source>Show me around</source>
        <translation>Zeig mir alles</translation>
    </message>
    <message>
        <source>Got it</source>
        <translation>Verstanden</translation>
    </message>
    <message>
        <source>Another window works on this lab (process %1 on %2, since %3). In this one you can look, but nothing is saved.</source>
        <translation>Ein anderes Fenster arbeitet an diesem Lab (Prozess %1 auf %2, seit %3). In diesem kannst du dich umsehen, aber nichts wird gespeichert.</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>What you pass is kept in your history, signed “Student”. It can be signed with your name.</source>
        <translation>Was du bestehst, wird in deinem Verlauf aufbewahrt, gezeichnet „Student“. Es kann mit deinem Namen gezeichnet werden.</translation>
    </message>
    <message>
        <source>Give your name…</source>
        <translation>Namen angeben…</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Dein Name</translation>
    </message>
    <message>
        <source>Your name:</source>
        <translation>Dein Name:</translation>
    </message>
    <message>
        <source>Your program is not saved</source>
        <translation>Dein Programm ist nicht gespeichert</translation>
    </message>
    <message>
        <source>What you typed since it was last saved is lost if you close the window.</source>
        <translation>Was du seit dem letzten Speichern getippt hast, geht verloren, wenn du das Fenster schließt.</translation>
    </message>
</context>
<context>
    <name>cradle::Workbench</name>
    <message>
        <source>Open a scene</source>
        <translation>Szene öffnen</translation>
    </message>
    <message>
        <source>this is work in the lab %1, which is not here; open that lab once, and then the work</source>
        <translation>das ist Arbeit im Lab %1, das es hier nicht gibt; öffne einmal dieses Lab und dann die Arbeit</translation>
    </message>
</context>
<context>
    <name>cradle::WorldGroup</name>
    <message>
        <source>World</source>
        <translation>Welt</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>Restitution e</source>
        <translation>Stoßzahl e</translation>
    </message>
    <message>
        <source>Timestep</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Half width</source>
        <translation>Halbe Breite</translation>
    </message>
    <message>
        <source>Acceleration of every circle, to the right and upward</source>
        <translation>Beschleunigung jedes Kreises, nach rechts und nach oben</translation>
    </message>
    <message>
        <source>From 0, no rebound, to 1, elastic</source>
        <translation>Von 0, kein Rückprall, bis 1, elastisch</translation>
    </message>
    <message>
        <source>Up doubles it, Down halves it; 1/240 can be typed</source>
        <translation>Pfeil auf verdoppelt, Pfeil ab halbiert; 1/240 lässt sich eintippen</translation>
    </message>
    <message>
        <source>From the middle of the square to a wall</source>
        <translation>Von der Mitte des Quadrats bis zu einer Wand</translation>
    </message>
    <message>
        <source>Gravity to the right, m/s²</source>
        <translation>Schwerkraft nach rechts, m/s²</translation>
    </message>
    <message>
        <source>Gravity upward, m/s²</source>
        <translation>Schwerkraft nach oben, m/s²</translation>
    </message>
    <message>
        <source>Timestep, s</source>
        <translation>Zeitschritt, s</translation>
    </message>
    <message>
        <source>Half width of the square, m</source>
        <translation>Halbe Breite des Quadrats, m</translation>
    </message>
    <message>
        <source>= %1 s</source>
        <translation>= %1 s</translation>
    </message>
    <message>
        <source>Change gravity</source>
        <translation>Schwerkraft ändern</translation>
    </message>
    <message>
        <source>Change restitution</source>
        <translation>Stoßzahl ändern</translation>
    </message>
    <message>
        <source>Change timestep</source>
        <translation>Zeitschritt ändern</translation>
    </message>
    <message>
        <source>Change half width</source>
        <translation>Halbe Breite ändern</translation>
    </message>
</context>
</TS>
