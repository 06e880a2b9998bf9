<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
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
        <translation>In Schritt %1 bewegte sich Kreis %2 schon mit %4 m/s von %3 weg und wurde noch einmal umgedreht; er soll in Ruhe gelassen werden</translation>
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
        <source>At step %1 the circles changed their velocities although their rims were still %2 m apart; they should touch first, at a distance of r₁ + r₂</source>
        <translation>In Schritt %1 änderten die Kreise ihre Geschwindigkeiten, obwohl ihre Ränder noch %2 m auseinander waren; sie sollen sich zuerst berühren, beim Abstand r₁ + r₂</translation>
    </message>
    <message>
        <source>At step %1 the circles were already moving apart with %2 m/s and were hit again; circles that move apart should be left alone</source>
        <translation>In Schritt %1 entfernten sich die Kreise schon mit %2 m/s voneinander und stießen noch einmal; Kreise, die sich entfernen, sollen in Ruhe gelassen werden</translation>
    </message>
    <message>
        <source>At step %1 circle 1 left the hit with %2 m/s and circle 2 with %3 m/s; along the line of centres %4 it should be %5 and %6 m/s</source>
        <translation>In Schritt %1 kam Kreis 1 mit %2 m/s aus dem Stoß und Kreis 2 mit %3 m/s; längs der Verbindungslinie der Mittelpunkte %4 sollen es %5 und %6 m/s sein</translation>
    </message>
    <message>
        <source>At step %1 the circles have run into each other and go on as if nothing had happened; they should answer as soon as their distance is r₁ + r₂</source>
        <translation>In Schritt %1 sind die Kreise ineinander gelaufen und bewegen sich weiter, als wäre nichts geschehen; sie sollen antworten, sobald ihr Abstand r₁ + r₂ ist</translation>
    </message>
    <message>
        <source>The circles hit each other %1 times; at least %2 is right</source>
        <translation>Die Kreise stießen %1-mal zusammen; richtig ist mindestens %2-mal</translation>
    </message>
    <message>
        <source>The circles never hit each other; they should</source>
        <translation>Die Kreise stießen nie zusammen; sie sollen es</translation>
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
        <translation>In Schritt %1 bewegte sich Kreis %2 um %3 m; das Verfahren %4 bewegt ihn um %5 m</translation>
    </message>
    <message>
        <source>. This is what %1 does</source>
        <translation>. Das tut das Verfahren %1</translation>
    </message>
    <message>
        <source>Circle %1 is never free of walls and other circles, so its motion cannot be judged; a start in the open is right</source>
        <translation>Kreis %1 ist nie frei von Wänden und anderen Kreisen, also lässt sich seine Bewegung nicht beurteilen; richtig ist ein Start im Freien</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>Circle %1 moves by none of the four integrators under gravity %2 m/s²</source>
        <translation>Kreis %1 bewegt sich nach keinem der vier Integratoren unter der Schwerkraft %2 m/s²</translation>
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
        <source>circle %1</source>
        <translation>Kreis %1</translation>
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
</context>
<context>
    <name>CircleEdits</name>
    <message>
        <source>circle %1</source>
        <translation>circle %1</translation>
    </message>
</context>
<context>
    <name>Cli</name>
    <message>
        <source>Judges a preset for one step: the engine&apos;s laws, by what they do.</source>
        <translation>Beurteilt eine Szene für einen Schritt: die Gesetze der Engine, nach dem, was sie tun.</translation>
    </message>
    <message>
        <source>the step, like L42T5</source>
        <translation>der Schritt, etwa L42T5</translation>
    </message>
    <message>
        <source>the preset to judge</source>
        <translation>die Szene, die beurteilt wird</translation>
    </message>
    <message>
        <source>the lab&apos;s folder; without it the shipped lab</source>
        <translation>der Ordner des Labs; ohne ihn das mitgelieferte Lab</translation>
    </message>
    <message>
        <source>of the scenes; 1 without it</source>
        <translation>Startwert für den Zufall der Szenen; ohne ihn 1</translation>
    </message>
    <message>
        <source>text or json</source>
        <translation>text oder json</translation>
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
        <source>--preset P.json is missing: what is to be judged?</source>
        <translation>--preset P.json fehlt: Was soll beurteilt werden?</translation>
    </message>
    <message>
        <source>unknown format %1; text or json is right</source>
        <translation>unbekanntes Format %1; richtig ist text oder json</translation>
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
        <source>Runs a scene and writes what happens.</source>
        <translation>Lässt eine Szene laufen und schreibt auf, was geschieht.</translation>
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
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
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
    <name>LabReader</name>
    <message>
        <source>another step has the id %1 already; an id of its own is right</source>
        <translation>ein anderer Schritt hat schon die Kennung %1; richtig ist eine eigene Kennung</translation>
    </message>
    <message>
        <source>the text is not in UTF-8, which would be right; some letters are lost</source>
        <translation>der Text ist nicht in UTF-8, was richtig wäre; einige Buchstaben gehen verloren</translation>
    </message>
</context>
<context>
    <name>Main</name>
    <message>
        <source>open this step</source>
        <translation>diesen Schritt öffnen</translation>
    </message>
    <message>
        <source>speak this language: en or de</source>
        <translation>diese Sprache sprechen: en oder de</translation>
    </message>
    <message>
        <source>system, light or dark</source>
        <translation>system, light oder dark</translation>
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
        <source>cradle: --language %1: en or de is right</source>
        <translation>cradle: --language %1: richtig ist en oder de</translation>
    </message>
    <message>
        <source>cradle: --theme %1: system, light or dark is right</source>
        <translation>cradle: --theme %1: richtig ist system, light oder dark</translation>
    </message>
    <message>
        <source>--at %1: a number of seconds from 0 to %2 is right</source>
        <translation>--at %1: richtig ist eine Zahl von Sekunden von 0 bis %2</translation>
    </message>
    <message>
        <source>--size %1: a size like 1280x800 is right</source>
        <translation>--size %1: richtig ist eine Größe wie 1280x800</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>cradle: unexpected argument %1; one lab or scene is right</source>
        <translation>cradle: unerwartetes Argument %1; richtig ist ein Lab oder eine Szene</translation>
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
        <translation>&amp;Lab öffnen…</translation>
    </message>
    <message>
        <source>Open &amp;scene…</source>
        <translation>&amp;Szene öffnen…</translation>
    </message>
    <message>
        <source>Save scene &amp;as…</source>
        <translation>Szene speichern &amp;unter…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
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
        <source>&amp;Add circle</source>
        <translation>Kreis &amp;hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Duplicate circle</source>
        <translation>Kreis &amp;duplizieren</translation>
    </message>
    <message>
        <source>Re&amp;move circle</source>
        <translation>Kreis &amp;entfernen</translation>
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
        <source>Show the &amp;whole square</source>
        <translation>&amp;Ganzes Quadrat zeigen</translation>
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
        <translation>S&amp;prache</translation>
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
</context>
<context>
    <name>Preset</name>
    <message>
        <source>%1 circles of radius %2 m do not fit into the square; at most %3 are right</source>
        <translation>%1 Kreise mit Radius %2 m passen nicht in das Quadrat; richtig sind höchstens %3</translation>
    </message>
    <message>
        <source>circle %1</source>
        <translation>circle %1</translation>
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
        <source>your progress could not be read and was moved to %1; Cradle begins anew</source>
        <translation>dein Fortschritt konnte nicht gelesen werden und liegt jetzt in %1; Cradle beginnt von vorn</translation>
    </message>
    <message>
        <source>your progress could not be saved: %1</source>
        <translation>dein Fortschritt konnte nicht gespeichert werden: %1</translation>
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
        <source>%1 did not pass</source>
        <translation>%1 nicht bestanden</translation>
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
        <source>a list of numbers</source>
        <translation>eine Liste von Zahlen</translation>
    </message>
    <message>
        <source>a list of texts</source>
        <translation>eine Liste von Texten</translation>
    </message>
    <message>
        <source>a list of timesteps in s</source>
        <translation>eine Liste von Zeitschritten in s</translation>
    </message>
    <message>
        <source>a list of velocities [x, y] in m/s, one per circle</source>
        <translation>eine Liste von Geschwindigkeiten [x, y] in m/s, eine je Kreis</translation>
    </message>
    <message>
        <source>a list out of euler, symplectic_euler, verlet, rk4</source>
        <translation>eine Liste aus euler, symplectic_euler, verlet, rk4</translation>
    </message>
    <message>
        <source>a list out of stop, swap_velocities, swap_normal, impulse</source>
        <translation>eine Liste aus stop, swap_velocities, swap_normal, impulse</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
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
        <source>a short name of letters, digits, dots and dashes</source>
        <translation>ein kurzer Name aus Buchstaben, Ziffern, Punkten und Bindestrichen</translation>
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
        <source>an object with format, id, title, commit, preset, hints, checks and extra</source>
        <translation>ein Objekt mit format, id, title, commit, preset, hints, checks und extra</translation>
    </message>
    <message>
        <source>an object with format, id, title, version, language and steps</source>
        <translation>ein Objekt mit format, id, title, version, language und steps</translation>
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
        <source>an object with id, kind, title, parameters and scene</source>
        <translation>ein Objekt mit id, kind, title, parameters und scene</translation>
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
        <source>an object with title, hints and checks</source>
        <translation>ein Objekt mit title, hints und checks</translation>
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
        <source>how far off centre the circles meet at most, in r1 + r2, a number from 0 to 0.95</source>
        <translation>wie weit außermittig sich die Kreise höchstens treffen, in r1 + r2, eine Zahl von 0 bis 0.95</translation>
    </message>
    <message>
        <source>how long each runs in s, a number above 0 and at most 600</source>
        <translation>wie lange jede läuft in s, eine Zahl über 0 und höchstens 600</translation>
    </message>
    <message>
        <source>how many circles, a whole number from 1 to 100000</source>
        <translation>wie viele Kreise, eine ganze Zahl von 1 bis 100000</translation>
    </message>
    <message>
        <source>how many hits there must be at least, a whole number</source>
        <translation>wie viele Stöße es mindestens sein müssen, eine ganze Zahl</translation>
    </message>
    <message>
        <source>how many scenes, a whole number from 1 to 200</source>
        <translation>wie viele Szenen, eine ganze Zahl von 1 bis 200</translation>
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
        <source>one of own, flight, directions, corners, encounters, drop</source>
        <translation>eines von own, flight, directions, corners, encounters, drop</translation>
    </message>
    <message>
        <source>one of stop, swap_velocities, swap_normal, impulse</source>
        <translation>eines von stop, swap_velocities, swap_normal, impulse</translation>
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
        <source>two numbers [x, y]</source>
        <translation>zwei Zahlen [x, y]</translation>
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
        <source>two numbers, the least and the most</source>
        <translation>zwei Zahlen, die kleinste und die größte</translation>
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
        <source>circle %1 at %2°</source>
        <translation>Kreis %1 unter %2°</translation>
    </message>
    <message>
        <source>drop %1</source>
        <translation>Fall %1</translation>
    </message>
    <message>
        <source>contact at %1°</source>
        <translation>Berührung unter %1°</translation>
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
        <source>circle %1</source>
        <translation>Kreis %1</translation>
    </message>
</context>
<context>
    <name>cradle::ChartPlot</name>
    <message>
        <source>s</source>
        <comment>seconds</comment>
        <translation>s</translation>
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
        <translation>Drücke Starten, um die Energie zu sehen</translation>
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
        <translation>Gesamt &amp;je Kreis</translation>
    </message>
    <message>
        <source>By the &amp;integrator</source>
        <translation>Vom &amp;Integrator</translation>
    </message>
    <message>
        <source>Energy made by the integrator, or lost if negative: total + dissipated in hits − total at the start. So start = total + dissipated − made by the integrator.</source>
        <translation>Vom Integrator erzeugte Energie, negativ: verlorene: gesamt + in Stößen abgegeben − gesamt am Anfang. Also Anfang = gesamt + abgegeben − vom Integrator erzeugt.</translation>
    </message>
    <message>
        <source>total %1</source>
        <translation>gesamt %1</translation>
    </message>
    <message>
        <source>by the integrator</source>
        <translation>vom Integrator</translation>
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
        <translation>Stoß %1 bei %2 s, Kreis %6 an: %7; Impuls vorher %3, nachher %4, Änderung %5 kg m/s.</translation>
    </message>
    <message>
        <source>Momentum (p_x, p_y) of the circles of the hit; p_x alone where there is no p_y</source>
        <translation>Impuls (p_x, p_y) der Kreise des Stoßes; p_x allein, wo es kein p_y gibt</translation>
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
        <source>None</source>
        <comment>law for walls</comment>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Circles leave the square unhindered.</source>
        <translation>Kreise verlassen das Quadrat ungehindert.</translation>
    </message>
    <message>
        <source>Reflect</source>
        <translation>Reflektieren</translation>
    </message>
    <message>
        <source>A wall turns the part of the velocity that points into it around, and multiplies it by e.</source>
        <translation>Eine Wand kehrt den Anteil der Geschwindigkeit um, der in sie zeigt, und multipliziert ihn mit e.</translation>
    </message>
    <message>
        <source>None</source>
        <comment>law for circles</comment>
        <translation>Keines</translation>
    </message>
    <message>
        <source>Circles pass through each other.</source>
        <translation>Kreise gehen durcheinander hindurch.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Circles that meet both stop.</source>
        <translation>Kreise, die sich treffen, bleiben beide stehen.</translation>
    </message>
    <message>
        <source>Swap velocities</source>
        <translation>Geschwindigkeiten tauschen</translation>
    </message>
    <message>
        <source>Circles that meet exchange their whole velocities.</source>
        <translation>Kreise, die sich treffen, tauschen ihre ganzen Geschwindigkeiten.</translation>
    </message>
    <message>
        <source>Swap normal parts</source>
        <translation>Normalanteile tauschen</translation>
    </message>
    <message>
        <source>Only the parts of the velocities along the line of centres are exchanged; the parts across it stay.</source>
        <translation>Nur die Anteile der Geschwindigkeiten längs der Verbindungslinie der Mittelpunkte werden getauscht; die Anteile quer dazu bleiben.</translation>
    </message>
    <message>
        <source>Impulse</source>
        <translation>Kraftstoß</translation>
    </message>
    <message>
        <source>An impulse along the line of centres keeps the momentum, with the masses and the restitution e.</source>
        <translation>Ein Kraftstoß längs der Verbindungslinie der Mittelpunkte erhält den Impuls, mit den Massen und der Stoßzahl e.</translation>
    </message>
    <message>
        <source>Discrete</source>
        <translation>Diskret</translation>
    </message>
    <message>
        <source>After each step overlaps are looked for; on a hit the circles go back to their old positions and respond.</source>
        <translation>Nach jedem Schritt werden Überlappungen gesucht; bei einem Stoß gehen die Kreise an ihren alten Ort zurück und antworten.</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Kontinuierlich</translation>
    </message>
    <message>
        <source>The time of a hit inside the step is found, and the rest of the step is spent after it.</source>
        <translation>Der Zeitpunkt eines Stoßes im Schritt wird bestimmt, und der Rest des Schritts läuft danach ab.</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>The motion is solved from hit to hit; the timestep only says when to look.</source>
        <translation>Die Bewegung wird von Stoß zu Stoß gelöst; der Zeitschritt sagt nur, wann hingesehen wird.</translation>
    </message>
</context>
<context>
    <name>cradle::MainWindow</name>
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
        <source>Read the step on the left, set the values below the scene, press Run to watch, and Check when you are done.</source>
        <translation>Lies links den Schritt, setze die Werte unter der Szene, drücke Starten, um zuzusehen, und Prüfen, wenn du fertig bist.</translation>
    </message>
    <message>
        <source>This is a scene of the check, at the moment where it went wrong.</source>
        <translation>Das ist eine Szene der Prüfung, in dem Moment, in dem sie schiefging.</translation>
    </message>
    <message>
        <source>Back to my scene</source>
        <translation>Zurück zu meiner Szene</translation>
    </message>
    <message>
        <source>Open a lab&apos;s folder</source>
        <translation>Ordner eines Labs öffnen</translation>
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
    <message>
        <source>About Cradle</source>
        <translation>Über Cradle</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Cradle %1&lt;/h3&gt;&lt;p&gt;Learn how a physics engine works by writing one.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. Built with Qt, MathJax and valijson.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Cradle %1&lt;/h3&gt;&lt;p&gt;Lerne, wie eine Physik-Engine arbeitet, indem du eine schreibst.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder später. Gebaut mit Qt, MathJax und valijson.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
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
    <message>
        <source>Nothing hits anything within the next minute.</source>
        <translation>In der nächsten Minute stößt nichts zusammen.</translation>
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
        <translation>Drücke Starten, um den Impuls zu sehen</translation>
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
        <translation>Drücke Prüfen (Strg+Eingabe), wenn du fertig bist.</translation>
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
        <source>Copy</source>
        <translation>Kopieren</translation>
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
        <source>Press Restart (R) to change the start</source>
        <translation>Drücke Neustart (R), um den Anfang zu ändern</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
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
    <message>
        <source>%1 at %2 m</source>
        <translation>%1 bei %2 m</translation>
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
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Set velocity to zero</source>
        <translation>Geschwindigkeit auf null setzen</translation>
    </message>
    <message>
        <source>Fit view</source>
        <translation>Ansicht einpassen</translation>
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
</context>
<context>
    <name>cradle::ValuesPane</name>
    <message>
        <source>Hits %L1</source>
        <translation>Stöße %L1</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>Stöße</translation>
    </message>
    <message>
        <source>No hit so far.</source>
        <translation>Noch kein Stoß.</translation>
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
        <source>Values of the circles at the moment shown</source>
        <translation>Werte der Kreise im gezeigten Moment</translation>
    </message>
    <message>
        <source>Hits; Enter shows the moment</source>
        <translation>Stöße; Eingabe zeigt den Moment</translation>
    </message>
    <message>
        <source>Last hit</source>
        <translation>Letzter Stoß</translation>
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
        <translation>Noch keine Stöße: drücke Starten oder Nächster Stoß</translation>
    </message>
</context>
<context>
    <name>cradle::Workbench</name>
    <message>
        <source>Open a scene</source>
        <translation>Szene öffnen</translation>
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
