<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Arrangement</name>
    <message>
        <source>Rack</source>
        <translation>Triangle</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>Anneau</translation>
    </message>
    <message>
        <source>%1 circles are too many: at most %2 are right</source>
        <translation>%1 cercles sont trop nombreux&#xa0;: %2 au plus conviennent</translation>
    </message>
    <message>
        <source>They do not fit into the square: fewer or smaller ones are right</source>
        <translation>Ils ne tiennent pas dans le carré&#xa0;: il en faut moins ou de plus petits</translation>
    </message>
</context>
<context>
    <name>AuthorForms</name>
    <message>
        <source>An id of letters, digits, dots, dashes and underscores is right</source>
        <translation>Il faut un id fait de lettres, de chiffres, de points, de traits d&apos;union et de tirets bas</translation>
    </message>
    <message>
        <source>Points: a number from 0 to 1000 is right</source>
        <translation>Points&#xa0;: il faut un nombre de 0 à 1000</translation>
    </message>
</context>
<context>
    <name>AuthorMenu</name>
    <message>
        <source>&amp;Lab</source>
        <translation>&amp;TP</translation>
    </message>
    <message>
        <source>&amp;New lab…</source>
        <translation>&amp;Nouveau TP…</translation>
    </message>
    <message>
        <source>&amp;Open a folder…</source>
        <translation>&amp;Ouvrir un dossier…</translation>
    </message>
    <message>
        <source>Open lab in one &amp;file…</source>
        <translation>Ouvrir un TP en un seul &amp;fichier…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>&amp;Export as one file…</source>
        <translation>E&amp;xporter en un seul fichier…</translation>
    </message>
    <message>
        <source>Export for st&amp;udents…</source>
        <translation>Exporter pour &amp;les étudiants…</translation>
    </message>
    <message>
        <source>&amp;Properties…</source>
        <translation>&amp;Propriétés…</translation>
    </message>
    <message>
        <source>Open as a s&amp;tudent</source>
        <translation>Ouvrir comme é&amp;tudiant</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Fer&amp;mer</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>F&amp;ind and replace in the lab…</source>
        <translation>Rec&amp;hercher et remplacer dans le TP…</translation>
    </message>
    <message>
        <source>Insert the scene as a &amp;figure</source>
        <translation>Insérer la scène comme &amp;figure</translation>
    </message>
    <message>
        <source>&amp;Values of lab and step</source>
        <translation>&amp;Valeurs du TP et de l&apos;étape</translation>
    </message>
    <message>
        <source>Start from the moment &amp;shown</source>
        <translation>Démarrer à l&apos;&amp;instant affiché</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>Étap&amp;e</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Ajouter</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Renommer</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>Suppri&amp;mer</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>Mon&amp;ter</translation>
    </message>
    <message>
        <source>Move d&amp;own</source>
        <translation>De&amp;scendre</translation>
    </message>
    <message>
        <source>&amp;Proof</source>
        <translation>&amp;Preuve</translation>
    </message>
    <message>
        <source>&amp;Verify this step</source>
        <translation>&amp;Vérifier cette étape</translation>
    </message>
    <message>
        <source>Verify the &amp;lab</source>
        <translation>Vérifier &amp;le TP</translation>
    </message>
    <message>
        <source>&amp;Suggest mistakes</source>
        <translation>&amp;Proposer des erreurs</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Affi&amp;chage</translation>
    </message>
</context>
<context>
    <name>AuthorPanes</name>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Vérifications</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programmes</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Preuve</translation>
    </message>
    <message>
        <source>Parts of the step</source>
        <translation>Parties de l&apos;étape</translation>
    </message>
</context>
<context>
    <name>ChartExport</name>
    <message>
        <source>the name ends in .%1, but this is a .%2 file; choose another name</source>
        <translation>le nom se termine par .%1, mais c&apos;est un fichier .%2&#xa0;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>Drawings (*.svg)</source>
        <translation>Dessins (*.svg)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation>Enregistrer le graphique</translation>
    </message>
    <message>
        <source>Save the numbers of the chart</source>
        <translation>Enregistrer les nombres du graphique</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>&amp;Copier l&apos;image</translation>
    </message>
    <message>
        <source>Picture as PN&amp;G…</source>
        <translation>Image en PN&amp;G…</translation>
    </message>
    <message>
        <source>Picture as &amp;SVG…</source>
        <translation>Image en &amp;SVG…</translation>
    </message>
    <message>
        <source>&amp;Numbers as CSV…</source>
        <translation>&amp;Nombres en CSV…</translation>
    </message>
</context>
<context>
    <name>CheckKinds</name>
    <message>
        <source>Gravity</source>
        <translation>Pesanteur</translation>
    </message>
    <message>
        <source>What is right; that of the scene if left out</source>
        <translation>La bonne valeur&#xa0;; celle de la scène si omise</translation>
    </message>
    <message>
        <source>Circles collide</source>
        <translation>Chocs de cercles</translation>
    </message>
    <message>
        <source>Leave out the moments at which circles may touch</source>
        <translation>Exclure les instants où des cercles peuvent se toucher</translation>
    </message>
    <message>
        <source>Restitution e</source>
        <translation>Restitution e</translation>
    </message>
    <message>
        <source>Hits at least</source>
        <translation>Chocs au moins</translation>
    </message>
    <message>
        <source>How often walls must turn the circles round, together, in every scene</source>
        <translation>Combien de fois les parois doivent renvoyer les cercles, en tout, dans chaque scène</translation>
    </message>
    <message>
        <source>Visits at least</source>
        <translation>Passages au moins</translation>
    </message>
    <message>
        <source>How often each circle must come to a wall</source>
        <translation>Combien de fois chaque cercle doit arriver à une paroi</translation>
    </message>
    <message>
        <source>Free at least</source>
        <translation>Libre au moins</translation>
    </message>
    <message>
        <source>How long each circle must be free of walls and circles; a tenth of the duration if left out</source>
        <translation>Combien de temps chaque cercle doit rester loin des parois et des autres cercles&#xa0;; un dixième de la durée si omis</translation>
    </message>
    <message>
        <source>How many hits there must be</source>
        <translation>Nombre de chocs qu&apos;il doit y avoir</translation>
    </message>
    <message>
        <source>Integrators</source>
        <translation>Intégrateurs</translation>
    </message>
    <message>
        <source>Any of these is right</source>
        <translation>N&apos;importe lequel convient</translation>
    </message>
    <message>
        <source>Laws</source>
        <translation>Lois</translation>
    </message>
    <message>
        <source>Any of these is right: both stop; they swap their velocities; they swap the parts along the line of centres; the impulse of masses and e</source>
        <translation>N&apos;importe laquelle convient&#xa0;: les deux s&apos;arrêtent&#xa0;; ils échangent leurs vitesses&#xa0;; ils échangent les composantes suivant la ligne des centres&#xa0;; l&apos;impulsion calculée avec les masses et e</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>How far off is still right</source>
        <translation>L&apos;écart encore admis</translation>
    </message>
    <message>
        <source>One for each of the circles; not looked at if left out</source>
        <translation>Une pour chacun des cercles&#xa0;; non examinée si omise</translation>
    </message>
    <message>
        <source>Not looked at if left out</source>
        <translation>Non examiné si omis</translation>
    </message>
    <message>
        <source>Starts with these values</source>
        <translation>Démarre avec ces valeurs</translation>
    </message>
    <message>
        <source>The values that a circle starts with</source>
        <translation>Les valeurs avec lesquelles un cercle démarre</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Masse volumique</translation>
    </message>
    <message>
        <source>How many circles there are</source>
        <translation>Nombre de cercles</translation>
    </message>
    <message>
        <source>Moves by an integrator</source>
        <translation>Se déplace selon un intégrateur</translation>
    </message>
    <message>
        <source>Every step far from walls is one of the named integrators under the named gravity</source>
        <translation>Chaque pas loin des parois est celui d&apos;un des intégrateurs nommés, sous la pesanteur nommée</translation>
    </message>
    <message>
        <source>Follows x₀ + v₀t + ½gt²</source>
        <translation>Suit x₀ + v₀t + ½gt²</translation>
    </message>
    <message>
        <source>Up to the first bounce it is where the formula says</source>
        <translation>Jusqu&apos;au premier rebond, il est là où le dit la formule</translation>
    </message>
    <message>
        <source>Stay together</source>
        <translation>Restent ensemble</translation>
    </message>
    <message>
        <source>Two circles are in the same place with the same velocity at every step</source>
        <translation>Deux cercles sont au même endroit avec la même vitesse à chaque pas</translation>
    </message>
    <message>
        <source>Use the same integrator</source>
        <translation>Utilisent le même intégrateur</translation>
    </message>
    <message>
        <source>Two circles follow one and the same integrator, whichever it is</source>
        <translation>Deux cercles suivent un seul et même intégrateur, quel qu&apos;il soit</translation>
    </message>
    <message>
        <source>Is there at a moment</source>
        <translation>Est là à un instant</translation>
    </message>
    <message>
        <source>Positions and velocities at a moment; between two steps, on the straight line between them</source>
        <translation>Positions et vitesses à un instant&#xa0;; entre deux pas, sur le segment qui les joint</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Instant</translation>
    </message>
    <message>
        <source>Seconds from the start; the end if left out</source>
        <translation>En secondes depuis le début&#xa0;; la fin si omis</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positions</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>Vitesses</translation>
    </message>
    <message>
        <source>Walls reflect with e</source>
        <translation>Les parois renvoient avec e</translation>
    </message>
    <message>
        <source>At a wall v_n&apos; = −e v_n; the part along the wall stays; at the rim and in time</source>
        <translation>À une paroi v_n&apos; = −e v_n&#xa0;; la composante le long de la paroi est conservée&#xa0;; au bord et à temps</translation>
    </message>
    <message>
        <source>Stays inside</source>
        <translation>Reste à l&apos;intérieur</translation>
    </message>
    <message>
        <source>Never further beyond a wall than the way of one step and the tolerance</source>
        <translation>Jamais plus loin derrière une paroi que le chemin d&apos;un pas et la tolérance</translation>
    </message>
    <message>
        <source>Bounces to the heights e²ⁿ h₀</source>
        <translation>Rebondit aux hauteurs e²ⁿ h₀</translation>
    </message>
    <message>
        <source>After the n-th bounce it rises to e²ⁿ times the height it came from</source>
        <translation>Après le n-ième rebond, il remonte à e²ⁿ fois la hauteur d&apos;où il venait</translation>
    </message>
    <message>
        <source>Bounces</source>
        <translation>Rebonds</translation>
    </message>
    <message>
        <source>How many are looked at; those lower than the tolerance are not</source>
        <translation>Combien sont examinés&#xa0;; ceux plus bas que la tolérance ne le sont pas</translation>
    </message>
    <message>
        <source>How far off is still right, as a share of the first height</source>
        <translation>L&apos;écart encore admis, en part de la première hauteur</translation>
    </message>
    <message>
        <source>Comes to rest</source>
        <translation>S&apos;immobilise</translation>
    </message>
    <message>
        <source>At the end it lies on the floor as still as its integrator allows</source>
        <translation>À la fin, il repose sur le sol, aussi immobile que le permet son intégrateur</translation>
    </message>
    <message>
        <source>Collide by a law</source>
        <translation>Se heurtent selon une loi</translation>
    </message>
    <message>
        <source>Circles 1 and 2 answer every contact, in time, by one of the named laws: stop, exchange velocities, exchange normal parts, impulse with e</source>
        <translation>Les cercles 1 et 2 réagissent à chaque contact, à temps, selon l&apos;une des lois nommées&#xa0;: arrêt, échange des vitesses, échange des composantes normales, impulsion avec e</translation>
    </message>
    <message>
        <source>Hit when the gap closes</source>
        <translation>Choc quand l&apos;écart se ferme</translation>
    </message>
    <message>
        <source>Circles 1 and 2 answer every contact when their rims meet, neither earlier nor later, in whatever way</source>
        <translation>Les cercles 1 et 2 réagissent à chaque contact quand leurs bords se rencontrent, ni plus tôt ni plus tard, de quelque façon que ce soit</translation>
    </message>
    <message>
        <source>Part with e times the speed</source>
        <translation>Se séparent avec e fois la vitesse</translation>
    </message>
    <message>
        <source>In every hit of circles 1 and 2 their relative speed along the line of centres becomes e times what it was</source>
        <translation>À chaque choc des cercles 1 et 2, leur vitesse relative suivant la ligne des centres devient e fois ce qu&apos;elle était</translation>
    </message>
    <message>
        <source>Keep momentum and energy</source>
        <translation>Conservent quantité de mouvement et énergie</translation>
    </message>
    <message>
        <source>Every hit of circles 1 and 2 keeps the momentum and, if asked, the kinetic energy</source>
        <translation>Chaque choc des cercles 1 et 2 conserve la quantité de mouvement et, si c&apos;est demandé, l&apos;énergie cinétique</translation>
    </message>
    <message>
        <source>Kinetic energy, too</source>
        <translation>L&apos;énergie cinétique aussi</translation>
    </message>
    <message>
        <source>Else only the momentum is looked at</source>
        <translation>Sinon, seule la quantité de mouvement est examinée</translation>
    </message>
    <message>
        <source>What share may be missing</source>
        <translation>Quelle part peut manquer</translation>
    </message>
    <message>
        <source>Leave the first hit with</source>
        <translation>Quittent le premier choc avec</translation>
    </message>
    <message>
        <source>The velocities of circles 1 and 2 after their first hit</source>
        <translation>Les vitesses des cercles 1 et 2 après leur premier choc</translation>
    </message>
    <message>
        <source>One for each of the two circles</source>
        <translation>Une pour chacun des deux cercles</translation>
    </message>
    <message>
        <source>Lose energy</source>
        <translation>Perdent de l&apos;énergie</translation>
    </message>
    <message>
        <source>The first hit of circles 1 and 2 takes kinetic energy</source>
        <translation>Le premier choc des cercles 1 et 2 fait perdre de l&apos;énergie cinétique</translation>
    </message>
    <message>
        <source>Pass through each other</source>
        <translation>Se traversent</translation>
    </message>
    <message>
        <source>Circles 1 and 2 cross without changing</source>
        <translation>Les cercles 1 et 2 se croisent sans changer</translation>
    </message>
    <message>
        <source>Your own, in Lua</source>
        <translation>La vôtre, en Lua</translation>
    </message>
    <message>
        <source>The function check(run) of a file looks at the whole run and says what is wrong with it</source>
        <translation>La fonction check(run) d&apos;un fichier examine toute l&apos;exécution et dit ce qui n&apos;y va pas</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>In the folder checks of the step, such as heights.lua</source>
        <translation>Dans le dossier checks de l&apos;étape, par exemple heights.lua</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> en %1</translation>
    </message>
    <message>
        <source> from %1 to %2</source>
        <translation> de %1 à %2</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>une valeur parmi %1</translation>
    </message>
    <message>
        <source>a list out of %1</source>
        <translation>une liste prise dans %1</translation>
    </message>
    <message>
        <source>a list [x, y], each %1</source>
        <translation>une liste [x, y], chacun %1</translation>
    </message>
    <message>
        <source>a list of lists [x, y], each %1</source>
        <translation>une liste de listes [x, y], chacun %1</translation>
    </message>
    <message>
        <source>a list [least, most], each %1</source>
        <translation>une liste [minimum, maximum], chacun %1</translation>
    </message>
    <message>
        <source>a list, each %1</source>
        <translation>une liste, chaque élément %1</translation>
    </message>
    <message>
        <source>the name of a file in the folder checks, such as heights.lua</source>
        <translation>le nom d&apos;un fichier du dossier checks, par exemple heights.lua</translation>
    </message>
    <message>
        <source>the moment %1 s is after the end of the scene; at most its duration of %2 s is right</source>
        <translation>l&apos;instant %1 s est après la fin de la scène&#xa0;; au plus sa durée de %2 s convient</translation>
    </message>
    <message numerus="yes">
        <source>there is no circle %1; the scene of the step has %n circle(s)</source>
        <translation>
            <numerusform>il n&apos;y a pas de cercle %1&#xa0;; la scène de l&apos;étape a %n cercle</numerusform>
            <numerusform>il n&apos;y a pas de cercle %1&#xa0;; la scène de l&apos;étape a %n cercles</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is not right here; right would be one of %2</source>
        <translation>%1 ne convient pas ici&#xa0;; il faudrait une valeur parmi %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 needs %2 circles; the scene of the step has %n circle(s)</source>
        <translation>
            <numerusform>%1 a besoin de %2 cercles&#xa0;; la scène de l&apos;étape a %n cercle</numerusform>
            <numerusform>%1 a besoin de %2 cercles&#xa0;; la scène de l&apos;étape a %n cercles</numerusform>
        </translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing; right would be %2</source>
        <translation>«&#xa0;%1&#xa0;» manque&#xa0;; il faudrait %2</translation>
    </message>
    <message>
        <source>%1 has no parameters</source>
        <translation>%1 n&apos;a pas de paramètres</translation>
    </message>
    <message>
        <source>%1 has no parameter &quot;%2&quot;; it has %3</source>
        <translation>%1 n&apos;a pas de paramètre «&#xa0;%2&#xa0;»&#xa0;; il a %3</translation>
    </message>
    <message>
        <source>%1 is not right here; right would be %2</source>
        <translation>%1 ne convient pas ici&#xa0;; il faudrait %2</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>How long every scene runs</source>
        <translation>Durée de chaque scène</translation>
    </message>
    <message>
        <source>Timesteps</source>
        <translation>Pas de temps</translation>
    </message>
    <message>
        <source>The scenes take turns with these; 1/60 s if left out, in the student&apos;s own scene its own</source>
        <translation>Les scènes les prennent à tour de rôle&#xa0;; 1/60 s si omis, et dans la scène de l&apos;étudiant le sien</translation>
    </message>
    <message>
        <source>Drawn between the least and the most</source>
        <translation>Tiré au sort entre le minimum et le maximum</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>Vitesses</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Angles</translation>
    </message>
    <message>
        <source>From the x axis; the scenes divide them evenly</source>
        <translation>À partir de l&apos;axe x&#xa0;; les scènes les répartissent régulièrement</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>Scènes</translation>
    </message>
    <message>
        <source>How many scenes are drawn</source>
        <translation>Nombre de scènes tirées au sort</translation>
    </message>
    <message>
        <source>Radii</source>
        <translation>Rayons</translation>
    </message>
    <message>
        <source>Densities</source>
        <translation>Masses volumiques</translation>
    </message>
    <message>
        <source>None if left out</source>
        <translation>Aucune si omise</translation>
    </message>
    <message>
        <source>Restitutions e</source>
        <translation>Restitutions e</translation>
    </message>
    <message>
        <source>The scenes take turns with these</source>
        <translation>Les scènes les prennent à tour de rôle</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>The same scenes in every check; drawn anew with the seed of the check if left out</source>
        <translation>Les mêmes scènes à chaque vérification&#xa0;; tirées à nouveau avec la graine de la vérification si omise</translation>
    </message>
    <message>
        <source>The student&apos;s own scene</source>
        <translation>La scène de l&apos;étudiant</translation>
    </message>
    <message>
        <source>With each of the timesteps</source>
        <translation>Avec chacun des pas de temps</translation>
    </message>
    <message>
        <source>Throws</source>
        <translation>Lancers</translation>
    </message>
    <message>
        <source>The circles thrown together from the middle, in any direction</source>
        <translation>Les cercles lancés ensemble depuis le milieu, dans n&apos;importe quelle direction</translation>
    </message>
    <message>
        <source>Shots in all directions</source>
        <translation>Tirs dans toutes les directions</translation>
    </message>
    <message>
        <source>Each of the circles at the walls, all round, while the others move on where nothing meets them</source>
        <translation>Chacun des cercles contre les parois, tout autour, pendant que les autres avancent là où rien ne les rencontre</translation>
    </message>
    <message>
        <source>Shots at the corners</source>
        <translation>Tirs dans les coins</translation>
    </message>
    <message>
        <source>Each of the circles straight at the corners and just beside them, while the others move on where nothing meets them</source>
        <translation>Chacun des cercles droit dans les coins et juste à côté, pendant que les autres avancent là où rien ne les rencontre</translation>
    </message>
    <message>
        <source>Encounters</source>
        <translation>Rencontres</translation>
    </message>
    <message>
        <source>Circles 1 and 2 thrown so that they meet, from all angles</source>
        <translation>Cercles 1 et 2 lancés de façon à se rencontrer, sous tous les angles</translation>
    </message>
    <message>
        <source>Off centre</source>
        <translation>Excentrement</translation>
    </message>
    <message>
        <source>How far off centre they meet at most, in r₁ + r₂</source>
        <translation>De combien ils se rencontrent au plus hors du centre, en r₁ + r₂</translation>
    </message>
    <message>
        <source>Both move</source>
        <translation>Les deux bougent</translation>
    </message>
    <message>
        <source>Also one after the other, or one of them at rest; else circle 2 rests before the hit</source>
        <translation>Aussi l&apos;un derrière l&apos;autre, ou l&apos;un d&apos;eux au repos&#xa0;; sinon le cercle 2 est au repos avant le choc</translation>
    </message>
    <message>
        <source>Circles that part</source>
        <translation>Cercles qui se séparent</translation>
    </message>
    <message>
        <source>Circles 1 and 2 overlap, as after a hit that was told late, and move apart already; ask for 0 hits</source>
        <translation>Les cercles 1 et 2 se chevauchent, comme après un choc constaté trop tard, et se séparent déjà&#xa0;; demandez 0 choc</translation>
    </message>
    <message>
        <source>Slow hits</source>
        <translation>Chocs lents</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Chutes</translation>
    </message>
    <message>
        <source>Sideways</source>
        <translation>Vitesse latérale</translation>
    </message>
    <message>
        <source>Speed to the right, drawn between the least and the most</source>
        <translation>Vitesse vers la droite, tirée au sort entre le minimum et le maximum</translation>
    </message>
    <message>
        <source>Again at once</source>
        <translation>De nouveau aussitôt</translation>
    </message>
    <message>
        <source>another check has the id %1 already; an id of its own is right</source>
        <translation>une autre vérification a déjà l&apos;identifiant %1&#xa0;; il en faut un à elle</translation>
    </message>
    <message>
        <source>Some, between equal circles, are in front of a wall that sends circle 2 back to a second hit, with another line of centres; in two more the heavier circle meets the other twice on one line, which a wall sends back</source>
        <translation>Certaines, entre cercles égaux, ont lieu devant une paroi qui renvoie le cercle 2 vers un second choc, avec une autre ligne des centres&#xa0;; dans deux de plus, le cercle le plus lourd rencontre l&apos;autre, qu&apos;une paroi renvoie, deux fois sur une même ligne</translation>
    </message>
    <message>
        <source>The circles come slowly to the floor and to the ceiling, sooner or later in a step: what leaves a wall more slowly than it came is easily turned twice. Some are let go at rest, just above the floor</source>
        <translation>Les cercles arrivent lentement au sol et au plafond, plus ou moins tôt dans un pas&#xa0;: ce qui quitte une paroi plus lentement qu&apos;il n&apos;y est arrivé est facilement renvoyé deux fois. Certains sont lâchés au repos, juste au-dessus du sol</translation>
    </message>
    <message>
        <source>The circles fall onto the floor; in the last scene, where e is 1, from so low that they bounce often</source>
        <translation>Les cercles tombent sur le sol&#xa0;; dans la dernière scène, si e y vaut 1, de si bas qu&apos;ils rebondissent souvent</translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message>
        <source>There is no circle %1; add one</source>
        <translation>Il n&apos;y a pas de cercle %1&#xa0;; ajoutez-en un</translation>
    </message>
    <message>
        <source>A check runs at most %1 circles; there are %2</source>
        <translation>Une vérification fait tourner au plus %1 cercles&#xa0;; il y en a %2</translation>
    </message>
    <message>
        <source>The timestep %1 s is too short to be judged; %2 s or more is right</source>
        <translation>Le pas de temps %1 s est trop court pour être évalué&#xa0;; il faut %2 s ou plus</translation>
    </message>
    <message>
        <source>After bounce %1 circle %2 rises to %3 m above the floor; e to the power of %4 times the first height, with e = %5, is %6 m</source>
        <translation>Après le rebond %1, le cercle %2 remonte à %3 m au-dessus du sol&#xa0;; e à la puissance %4 fois la première hauteur, avec e = %5, donne %6 m</translation>
    </message>
    <message>
        <source>Circle %1 comes off the floor and down again %2 times; at least %3 is right</source>
        <translation>Le cercle %1 quitte le sol et y retombe %2 fois&#xa0;; il faut au moins %3 fois</translation>
    </message>
    <message>
        <source>At step %1 circle %2 hit a wall and its velocity along the wall changed from %3 to %4 m/s; only the part into the wall should change</source>
        <translation>Au pas %1, le cercle %2 a heurté une paroi et sa vitesse le long de la paroi est passée de %3 à %4 m/s&#xa0;; seule la composante vers la paroi doit changer</translation>
    </message>
    <message>
        <source>At step %1 circle %2 turned round although its rim was still %3 m from the %4; it should touch first</source>
        <translation>Au pas %1, le cercle %2 a fait demi-tour alors que son bord n&apos;avait pas encore atteint %4 (il restait %3 m)&#xa0;; il doit d&apos;abord y avoir contact</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was already leaving the %3 with %4 m/s and was turned round again; it should be left alone</source>
        <translation>Au pas %1, le cercle %2 quittait déjà %3 à %4 m/s et a été renvoyé de nouveau&#xa0;; il faut le laisser partir</translation>
    </message>
    <message>
        <source>At step %1 circle %2 came to the %3 with %4 m/s and left it with %5 m/s; %6 m/s is right</source>
        <translation>Au pas %1, le cercle %2 est arrivé contre %3 à %4 m/s et en est reparti à %5 m/s&#xa0;; il faut %6 m/s</translation>
    </message>
    <message>
        <source>At step %1 circle %2 came to the %3 with %4 m/s and left it with %5 m/s; −e times %4 m/s with e = %6 is %7 m/s</source>
        <translation>Au pas %1, le cercle %2 est arrivé contre %3 à %4 m/s et en est reparti à %5 m/s&#xa0;; −e fois %4 m/s avec e = %6 donne %7 m/s</translation>
    </message>
    <message>
        <source>At step %1 the rim of circle %2 is %3 m beyond the %4; at most the way of one step, %5 m, is right</source>
        <translation>Au pas %1, le bord du cercle %2 dépasse %4 de %3 m&#xa0;; au plus le chemin d&apos;un pas, %5 m, est admis</translation>
    </message>
    <message>
        <source>In %1 s circle %2 came to a wall %3 times; at least %4 must be seen to judge whether it stays inside</source>
        <translation>En %1 s, le cercle %2 est arrivé %3 fois à une paroi&#xa0;; il faut le voir au moins %4 fois pour juger s&apos;il reste à l&apos;intérieur</translation>
    </message>
    <message>
        <source>At step %1 the circles met with %2 m/s along the line of centres and parted with %3 m/s; e times as much, with e = %4, is %5 m/s</source>
        <translation>Au pas %1, les cercles se sont rencontrés à %2 m/s suivant la ligne des centres et séparés à %3 m/s&#xa0;; e fois autant, avec e = %4, donne %5 m/s</translation>
    </message>
    <message>
        <source>At step %1 the circles have run into each other and go on as if nothing had happened; they should answer as soon as their distance is r₁ + r₂</source>
        <translation>Au pas %1, les cercles sont entrés l&apos;un dans l&apos;autre et continuent comme si de rien n&apos;était&#xa0;; ils doivent réagir dès que leur distance vaut r₁ + r₂</translation>
    </message>
    <message>
        <source>At step %1 the hit changed the total momentum from %2 to %3 kg m/s; it should stay</source>
        <translation>Au pas %1, le choc a fait passer la quantité de mouvement totale de %2 à %3 kg m/s&#xa0;; elle doit se conserver</translation>
    </message>
    <message>
        <source>At step %1 the hit changed the kinetic energy from %2 to %3 J; it should stay</source>
        <translation>Au pas %1, le choc a fait passer l&apos;énergie cinétique de %2 à %3 J&#xa0;; elle doit se conserver</translation>
    </message>
    <message>
        <source>At step %1 circle %2 left the first hit with %3 m/s; %4 m/s is right</source>
        <translation>Au pas %1, le cercle %2 est sorti du premier choc à %3 m/s&#xa0;; il faut %4 m/s</translation>
    </message>
    <message>
        <source>At step %1 the kinetic energy was %2 J before the hit and %3 J after it; with e below 1 it should be less</source>
        <translation>Au pas %1, l&apos;énergie cinétique valait %2 J avant le choc et %3 J après&#xa0;; avec e inférieur à 1, elle doit diminuer</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed from %3 to %4 m/s; the circles should pass through each other unchanged</source>
        <translation>Au pas %1, la vitesse du cercle %2 est passée de %3 à %4 m/s&#xa0;; les cercles doivent se traverser sans rien changer</translation>
    </message>
    <message>
        <source>At %1 s circle %2 is at %3 m; %4 m is right</source>
        <translation>À %1 s, le cercle %2 est en %3 m&#xa0;; il faut %4 m</translation>
    </message>
    <message>
        <source>At %1 s circle %2 moves with %3 m/s; %4 m/s is right</source>
        <translation>À %1 s, le cercle %2 a la vitesse %3 m/s&#xa0;; il faut %4 m/s</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed by %3 m/s, an acceleration of %4 m/s²; %5 m/s² is right here</source>
        <translation>Au pas %1, la vitesse du cercle %2 a changé de %3 m/s, soit une accélération de %4 m/s²&#xa0;; il faut ici %5 m/s²</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m; by %4 it moves by %5 m</source>
        <translation>Au pas %1, le cercle %2 s&apos;est déplacé de %3 m&#xa0;; selon %4, il se déplace de %5 m</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m; its velocity times the timestep is %4 m</source>
        <translation>Au pas %1, le cercle %2 s&apos;est déplacé de %3 m&#xa0;; sa vitesse multipliée par le pas de temps donne %4 m</translation>
    </message>
    <message>
        <source>Circle %1 was free of walls and other circles for %2 s only; at least %3 s must be seen to judge its motion</source>
        <translation>Le cercle %1 n&apos;a été loin des parois et des autres cercles que pendant %2 s&#xa0;; il faut le voir au moins %3 s pour évaluer son mouvement</translation>
    </message>
    <message>
        <source> or </source>
        <translation> ou </translation>
    </message>
    <message>
        <source>Circle %1 moves by %2 and circle %3 by %4; the same for both is right</source>
        <translation>Le cercle %1 se déplace selon %2 et le cercle %3 selon %4&#xa0;; il faut le même pour les deux</translation>
    </message>
    <message>
        <source>At step %1 circle %2 is at %3 m; x₀ + v₀t + ½gt² is %4 m</source>
        <translation>Au pas %1, le cercle %2 est en %3 m&#xa0;; x₀ + v₀t + ½gt² donne %4 m</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m at once; with its velocity it comes %4 m far</source>
        <translation>Au pas %1, le cercle %2 s&apos;est déplacé de %3 m d&apos;un coup&#xa0;; avec sa vitesse, il parcourt %4 m</translation>
    </message>
    <message>
        <source>left wall</source>
        <translation>la paroi gauche</translation>
    </message>
    <message>
        <source>right wall</source>
        <translation>la paroi droite</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>le sol</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>le plafond</translation>
    </message>
    <message>
        <source>Euler</source>
        <translation>Euler</translation>
    </message>
    <message>
        <source>symplectic Euler</source>
        <translation>Euler symplectique</translation>
    </message>
    <message>
        <source>velocity Verlet</source>
        <translation>Verlet vitesse</translation>
    </message>
    <message>
        <source>Runge-Kutta 4</source>
        <translation>Runge-Kutta 4</translation>
    </message>
    <message>
        <source>%1: the check itself stopped, so it says nothing of your work: %2</source>
        <translation>%1&#xa0;: la vérification elle-même s&apos;est arrêtée, elle ne dit donc rien de votre travail&#xa0;: %2</translation>
    </message>
    <message>
        <source>After %1 s circle %2 still comes %3 m above the floor with e = %4; at most %5 m is right for its integrator</source>
        <translation>Après %1 s, le cercle %2 remonte encore à %3 m au-dessus du sol avec e = %4&#xa0;; au plus %5 m convient pour son intégrateur</translation>
    </message>
    <message>
        <source>%1 is %2 %4 at the start; %3 %4 is asked for</source>
        <translation>%1 vaut %2 %4 au début&#xa0;; il faut %3 %4</translation>
    </message>
    <message>
        <source>The position of circle %1</source>
        <translation>La position du cercle %1</translation>
    </message>
    <message>
        <source>The velocity of circle %1</source>
        <translation>La vitesse du cercle %1</translation>
    </message>
    <message>
        <source>The radius of circle %1</source>
        <translation>Le rayon du cercle %1</translation>
    </message>
    <message>
        <source>The density of circle %1</source>
        <translation>La masse volumique du cercle %1</translation>
    </message>
    <message>
        <source>There are %1 circles; %2 are asked for</source>
        <translation>Nombre de cercles&#xa0;: %1&#xa0;; il en faut %2</translation>
    </message>
    <message>
        <source>At step %1 circle %2 is at %3 m with %4 m/s and circle %5 at %6 m with %7 m/s; they should be in the same place with the same velocity</source>
        <translation>Au pas %1, le cercle %2 est en %3 m avec %4 m/s et le cercle %5 en %6 m avec %7 m/s&#xa0;; ils doivent être au même endroit avec la même vitesse</translation>
    </message>
    <message>
        <source>Circle %1 came %2 m far in %3 s; at least its diameter of %4 m must be seen to judge whether they stay together</source>
        <translation>Le cercle %1 a parcouru %2 m en %3 s&#xa0;; il faut voir au moins son diamètre de %4 m pour juger s&apos;ils restent ensemble</translation>
    </message>
    <message>
        <source>not judged: your program does not move the circles</source>
        <translation>non évalué&#xa0;: votre programme ne déplace pas les cercles</translation>
    </message>
    <message>
        <source>not judged: what moves the circles is not what the step asks for</source>
        <translation>non évalué&#xa0;: ce qui déplace les cercles n&apos;est pas ce que demande l&apos;étape</translation>
    </message>
    <message>
        <source>not judged: the program stopped with an error</source>
        <translation>non évalué&#xa0;: le programme s&apos;est arrêté sur une erreur</translation>
    </message>
    <message>
        <source>Your program moves the circles</source>
        <translation>Votre programme déplace les cercles</translation>
    </message>
    <message>
        <source>The laws of the scene move the circles</source>
        <translation>Les lois de la scène déplacent les cercles</translation>
    </message>
    <message>
        <source>Your program moves the circles: leave on_update out, and the laws of the scene do it</source>
        <translation>Votre programme déplace les cercles&#xa0;: supprimez on_update, et les lois de la scène le feront</translation>
    </message>
    <message>
        <source>What the step fixes is as the step has it</source>
        <translation>Ce que l&apos;étape impose est comme l&apos;étape le veut</translation>
    </message>
    <message>
        <source>the check took more than %1 million instructions; an update should take a few thousand</source>
        <translation>la vérification a utilisé plus de %1 millions d&apos;instructions&#xa0;; une mise à jour devrait en prendre quelques milliers</translation>
    </message>
    <message>
        <source>stopped by the machine: the check took more than %1 s. This is no verdict on the program</source>
        <translation>arrêtée par la machine&#xa0;: la vérification a pris plus de %1 s. Ce n&apos;est pas un verdict sur le programme</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 into the %3 was %4 m/s before the step and %5 m/s after it; with e = %6 and gravity, %7 to %8 m/s is right</source>
        <translation>Au pas %1, la vitesse du cercle %2 vers %3 était de %4 m/s avant le pas et de %5 m/s après&#xa0;; avec e = %6 et la pesanteur, il faut de %7 à %8 m/s</translation>
    </message>
    <message>
        <source>Hits that the circles answered: %1; at least %2 is right</source>
        <translation>Chocs auxquels les cercles ont réagi&#xa0;: %1&#xa0;; il en faut au moins %2</translation>
    </message>
    <message>
        <source>Turns at walls, away from the other circle, in %1 s: %2; at least %3 must be seen to judge them</source>
        <translation>Retours aux parois, loin de l&apos;autre cercle, en %1 s&#xa0;: %2&#xa0;; il faut en voir au moins %3 pour les juger</translation>
    </message>
    <message>
        <source>Turns at walls in %1 s: %2; at least %3 must be seen to judge them</source>
        <translation>Retours aux parois en %1 s&#xa0;: %2&#xa0;; il faut en voir au moins %3 pour les juger</translation>
    </message>
    <message>
        <source>At step %1 the rim of circle %2 is %3 m beyond the %4, where it was without any speed; it should not be beyond it</source>
        <translation>Au pas %1, le bord du cercle %2 dépasse %4 de %3 m alors qu&apos;il n&apos;y avait plus de vitesse&#xa0;; il ne doit pas dépasser</translation>
    </message>
    <message>
        <source>At step %1, at a wall, circle %2 had %3 m/s along the wall before the step and %4 m/s after it; with gravity alone it is %5 m/s</source>
        <translation>Au pas %1, à une paroi, le cercle %2 avait %3 m/s le long de la paroi avant le pas et %4 m/s après&#xa0;; avec la seule pesanteur, c&apos;est %5 m/s</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was leaving the %3, with %4 m/s before the step and %5 m/s after it; with gravity alone it is %6 m/s</source>
        <translation>Au pas %1, le cercle %2 quittait %3, à %4 m/s avant le pas et à %5 m/s après&#xa0;; avec la seule pesanteur, c&apos;est %6 m/s</translation>
    </message>
    <message>
        <source>At step %1 the circles were already moving apart with %2 m/s, and their velocities changed from %3 and %4 to %5 and %6 m/s; circles that move apart should be left alone</source>
        <translation>Au pas %1, les cercles s&apos;éloignaient déjà l&apos;un de l&apos;autre à %2 m/s, et leurs vitesses sont passées de %3 et %4 à %5 et %6 m/s&#xa0;; il ne faut plus toucher à des cercles qui s&apos;éloignent</translation>
    </message>
    <message>
        <source>At step %1, with e = %2, the circles have run into each other and go on as if nothing had happened; they should answer as soon as their distance is r₁ + r₂</source>
        <translation>Au pas %1, avec e = %2, les cercles sont entrés l&apos;un dans l&apos;autre et continuent comme si de rien n&apos;était&#xa0;; ils doivent réagir dès que leur distance vaut r₁ + r₂</translation>
    </message>
    <message>
        <source>In this scene no velocity changed in a hit of the circles, so there is none to judge</source>
        <translation>Dans cette scène, aucune vitesse n&apos;a changé lors d&apos;un choc des cercles&#xa0;: il n&apos;y en a donc aucun à juger</translation>
    </message>
    <message>
        <source>In this scene no hit changed the velocities of the circles; one should</source>
        <translation>Dans cette scène, aucun choc n&apos;a changé les vitesses des cercles&#xa0;; il doit y en avoir un</translation>
    </message>
    <message>
        <source>. In this step %1 does so</source>
        <translation>. À ce pas, c&apos;est ce que fait %1</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed from %3 to %4 m/s although it touched neither a wall nor the other circle, from whose rim it was still %5 m away</source>
        <translation>Au pas %1, la vitesse du cercle %2 est passée de %3 à %4 m/s alors qu&apos;il ne touchait ni une paroi ni l&apos;autre cercle, dont le bord était encore à %5 m</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moved by %3 m, as by no integrator that this check allows; the nearest of them, %4, moves it by %5 m</source>
        <translation>Au pas %1, le cercle %2 s&apos;est déplacé de %3 m, ce que ne fait aucun des intégrateurs admis par cette vérification&#xa0;; le plus proche, %4, le déplace de %5 m</translation>
    </message>
    <message>
        <source>At step %1 circle %2 still has %4 m/s into the %3, as it has since step %5; the wall should turn it round at once</source>
        <translation>Au pas %1, le cercle %2 a toujours %4 m/s vers %3, comme depuis le pas %5&#xa0;; la paroi doit le renvoyer aussitôt</translation>
    </message>
    <message>
        <source>At step %1 circle %2 still has %4 m/s into the %3, as it has since step %5; with e = %6 the wall should answer at once</source>
        <translation>Au pas %1, le cercle %2 a toujours %4 m/s vers %3, comme depuis le pas %5&#xa0;; avec e = %6, la paroi doit réagir aussitôt</translation>
    </message>
    <message>
        <source>In this scene the circles never met, so nothing shows whether they pass through each other</source>
        <translation>Dans cette scène, les cercles ne se sont jamais rencontrés&#xa0;; rien ne montre donc s&apos;ils se traversent</translation>
    </message>
    <message>
        <source>At step %1, where the circles do not touch, the total momentum changed from %2 to %3 kg m/s; it should stay</source>
        <translation>Au pas %1, où les cercles ne se touchent pas, la quantité de mouvement totale est passée de %2 à %3 kg m/s&#xa0;; elle doit se conserver</translation>
    </message>
    <message>
        <source>At step %1, where the circles do not touch, the kinetic energy changed from %2 to %3 J; it should stay</source>
        <translation>Au pas %1, où les cercles ne se touchent pas, l&apos;énergie cinétique est passée de %2 à %3 J&#xa0;; elle doit se conserver</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 went from %3 to %4 m/s although it touched neither a wall nor the other circle, from whose rim it was still %5 m away; %6 m/s is right</source>
        <translation>Au pas %1, la vitesse du cercle %2 est passée de %3 à %4 m/s alors qu&apos;il ne touchait ni une paroi ni l&apos;autre cercle, dont le bord était encore à %5 m&#xa0;; la valeur juste est %6 m/s</translation>
    </message>
    <message>
        <source>At step %1 circle 1 left the hit with %2 m/s and circle 2 with %3 m/s; where their line of centres points along %4, %5 and %6 m/s are right</source>
        <translation>Au pas %1, le cercle 1 est sorti du choc à %2 m/s et le cercle 2 à %3 m/s&#xa0;; là où leur ligne des centres pointe suivant %4, les valeurs justes sont %5 et %6 m/s</translation>
    </message>
    <message>
        <source>%1. Their hit before, at step %2, came out right</source>
        <translation>%1. Leur choc précédent, au pas %2, était juste</translation>
    </message>
    <message>
        <source>%1. A wall is reached in this step, too: judge it when the walls are right</source>
        <translation>%1. Une paroi est aussi atteinte à ce pas&#xa0;: jugez-le quand les parois seront justes</translation>
    </message>
    <message>
        <source>At step %1 circle %2 moves by %3, and in steps before by another method; one for all steps is right</source>
        <translation>Au pas %1, le cercle %2 se déplace selon %3, et aux pas précédents selon une autre méthode&#xa0;; une seule pour tous les pas est juste</translation>
    </message>
    <message>
        <source>None of the four integrators makes all steps of circle %1 under gravity %2 m/s²</source>
        <translation>Aucun des quatre intégrateurs ne donne tous les pas du cercle %1 sous la pesanteur %2 m/s²</translation>
    </message>
    <message>
        <source>At step %1 the circles met with %2 m/s along the line of centres, and after the hit they still come nearer, with %3 m/s; they should part with e times as much as they met with: with e = %4, %5 m/s</source>
        <translation>Au pas %1, les cercles se sont rencontrés à %2 m/s le long de la ligne des centres, et après le choc ils se rapprochent encore, à %3 m/s&#xa0;; ils devraient se séparer à e fois cette vitesse&#xa0;: avec e = %4, à %5 m/s</translation>
    </message>
    <message>
        <source>By step %1 the circles have run into each other, and they are answered only in step %2, which begins with their centres %3 m apart; they should answer as soon as their distance is r₁ + r₂</source>
        <translation>Au pas %1, les cercles se sont déjà chevauchés, et la réponse ne vient qu&apos;au pas %2, au début duquel leurs centres sont à %3 m l&apos;un de l&apos;autre&#xa0;; ils devraient répondre dès que leur distance vaut r₁ + r₂</translation>
    </message>
    <message>
        <source>Nothing in your program moves the circles: write on_update</source>
        <translation>Rien dans votre programme ne déplace les cercles&#xa0;: écrivez on_update</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed from %3 to %4 m/s, while the circles moved apart and the other one kept its own; it should stay as it was</source>
        <translation>Au pas %1, la vitesse du cercle %2 est passée de %3 à %4 m/s, alors que les cercles s&apos;éloignaient l&apos;un de l&apos;autre et que l&apos;autre gardait la sienne&#xa0;; elle doit rester telle qu&apos;elle était</translation>
    </message>
    <message>
        <source>At step %1, while the circles did not come nearer, the total momentum changed from %2 to %3 kg m/s; it should stay</source>
        <translation>Au pas %1, où les cercles ne se rapprochaient pas, la quantité de mouvement totale est passée de %2 à %3 kg m/s&#xa0;; elle doit se conserver</translation>
    </message>
    <message>
        <source>At step %1, while the circles did not come nearer, the kinetic energy changed from %2 to %3 J; it should stay</source>
        <translation>Au pas %1, où les cercles ne se rapprochaient pas, l&apos;énergie cinétique est passée de %2 à %3 J&#xa0;; elle doit se conserver</translation>
    </message>
    <message>
        <source>At step %1, where it touches nothing, circle %2 moved by %3 m; its velocity times the timestep is %4 m. Hits are judged once this is mended</source>
        <translation>Au pas %1, où il ne touche rien, le cercle %2 s&apos;est déplacé de %3 m&#xa0;; sa vitesse multipliée par le pas de temps donne %4 m. Les chocs seront jugés une fois cela corrigé</translation>
    </message>
    <message>
        <source>At step %1, where it touches nothing, circle %2 moved by %3 m; its velocity times the timestep is %4 m, and gravity adds at most %5 m. Hits are judged once this is mended</source>
        <translation>Au pas %1, où il ne touche rien, le cercle %2 s&apos;est déplacé de %3 m&#xa0;; sa vitesse multipliée par le pas de temps donne %4 m, et la pesanteur ajoute au plus %5 m. Les chocs seront jugés une fois cela corrigé</translation>
    </message>
    <message>
        <source>At step %1, where it touches nothing, the velocity of circle %2 went from %3 to %4 m/s; %5 m/s is right. Hits are judged once this is mended</source>
        <translation>Au pas %1, où il ne touche rien, la vitesse du cercle %2 est passée de %3 à %4 m/s&#xa0;; la valeur juste est %5 m/s. Les chocs seront jugés une fois cela corrigé</translation>
    </message>
    <message>
        <source>In %2 s circle %1 never came to the floor as fast as a fall makes it; that must be seen to judge how it comes to rest</source>
        <translation>En %2 s, le cercle %1 n&apos;est jamais arrivé au sol aussi vite qu&apos;une chute le rend&#xa0;; il faut le voir pour évaluer comment il s&apos;immobilise</translation>
    </message>
    <message>
        <source>. Nothing moved</source>
        <translation>. Rien n&apos;a bougé</translation>
    </message>
    <message>
        <source>. From %1 s on nothing moved</source>
        <translation>. À partir de %1 s, rien n&apos;a bougé</translation>
    </message>
    <message>
        <source>. For %1 s it was within a step&apos;s way of a wall or beyond it, for %2 s of another circle: look at what it does there</source>
        <translation>. Pendant %1 s, il était à un pas au plus d&apos;une paroi ou au-delà, pendant %2 s d&apos;un autre cercle&#xa0;: regardez ce qu&apos;il y fait</translation>
    </message>
    <message>
        <source>. For %1 s it was within a step&apos;s way of a wall or beyond it: look at what it does there</source>
        <translation>. Pendant %1 s, il était à un pas au plus d&apos;une paroi ou au-delà&#xa0;: regardez ce qu&apos;il y fait</translation>
    </message>
    <message>
        <source>. For %1 s it was within a step&apos;s way of another circle: look at what it does there</source>
        <translation>. Pendant %1 s, il était à un pas au plus d&apos;un autre cercle&#xa0;: regardez ce qu&apos;il y fait</translation>
    </message>
    <message>
        <source>At step %1, which began away from the walls, the velocity of circle %2 went from %3 to %4 m/s; %5 m/s is right. Hits are judged once this is mended</source>
        <translation>Au pas %1, qui a commencé loin des parois, la vitesse du cercle %2 est passée de %3 à %4 m/s&#xa0;; la valeur juste est %5 m/s. Les chocs seront jugés une fois cela corrigé</translation>
    </message>
    <message>
        <source>In %2 s circle %1 never came to the floor; that must be seen to judge how it comes to rest</source>
        <translation>En %2 s, le cercle %1 n&apos;est jamais arrivé au sol&#xa0;; il faut le voir pour évaluer comment il s&apos;immobilise</translation>
    </message>
    <message>
        <source>At step %1 the hit put circle %2 %3 m nearer to the other one than its velocities before and after it take it; a hit may move circles apart, not into each other</source>
        <translation>Au pas %1, le choc a placé le cercle %2 de %3 m plus près de l&apos;autre que ne l&apos;amènent ses vitesses avant et après&#xa0;; un choc peut écarter les cercles, pas les enfoncer l&apos;un dans l&apos;autre</translation>
    </message>
    <message>
        <source>At step %1 the hit put circle %2 %3 m farther from the other one than its velocities and twice what they overlapped explain; it is enough that they touch</source>
        <translation>Au pas %1, le choc a placé le cercle %2 de %3 m plus loin de l&apos;autre que ne l&apos;expliquent ses vitesses et le double du chevauchement&#xa0;; il suffit qu&apos;ils se touchent</translation>
    </message>
    <message>
        <source>At step %1 the hit put circle %2 %3 m to the side of the ways that its velocities before and after it take it; a hit may move circles apart along the line of centres only</source>
        <translation>Au pas %1, le choc a placé le cercle %2 à %3 m à côté des chemins où l&apos;amènent ses vitesses avant et après&#xa0;; un choc ne peut écarter les cercles que le long de la ligne des centres</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was put %4 m further in from the %3 than its velocities and twice the way of its rim beyond the wall explain; it is enough that its rim is at the wall</source>
        <translation>Au pas %1, le cercle %2 a été placé, contre %3, de %4 m plus à l&apos;intérieur que ne l&apos;expliquent ses vitesses et le double du chemin de son bord au-delà de la paroi&#xa0;; il suffit que son bord soit à la paroi</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was put %4 m further out at the %3 than its velocity takes it; it belongs where its rim is at the wall, or back</source>
        <translation>Au pas %1, le cercle %2 a été placé, contre %3, de %4 m plus à l&apos;extérieur que ne l&apos;amène sa vitesse&#xa0;; sa place est là où son bord touche la paroi, ou en arrière</translation>
    </message>
    <message>
        <source>At step %1 circle %2 was put %4 m along the %3 beside the ways that its velocities before and after it take it; a wall should move it inward only, or back</source>
        <translation>Au pas %1, le cercle %2 a été placé, contre %3, à %4 m sur le côté des chemins où l&apos;amènent ses vitesses avant et après&#xa0;; une paroi ne doit le déplacer que vers l&apos;intérieur, ou en arrière</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 changed from %3 to %4 m/s although the circles were moving apart, with %5 m between their rims</source>
        <translation>Au pas %1, la vitesse du cercle %2 est passée de %3 à %4 m/s alors que les cercles s&apos;éloignaient, avec %5 m entre leurs bords</translation>
    </message>
    <message>
        <source>At step %1 the velocity of circle %2 went from %3 to %4 m/s although the circles were moving apart, with %5 m between their rims; %6 m/s is right</source>
        <translation>Au pas %1, la vitesse du cercle %2 est allée de %3 à %4 m/s alors que les cercles s&apos;éloignaient, avec %5 m entre leurs bords&#xa0;; %6 m/s est juste</translation>
    </message>
    <message>
        <source>After a hit at step %1 circle %2 has a velocity of %3 m/s, away from what it hit. From there to step %4 it moved by %5 m; with its velocity it comes %6 m far</source>
        <translation>Après un choc au pas %1, le cercle %2 a une vitesse de %3 m/s, qui l&apos;éloigne de ce qu&apos;il a touché. De là jusqu&apos;au pas %4, il s&apos;est déplacé de %5 m&#xa0;; avec sa vitesse, il parcourt %6 m</translation>
    </message>
</context>
<context>
    <name>CircleClipboard</name>
    <message>
        <source>The clipboard is empty: copy circles first</source>
        <translation>Le presse-papiers est vide&#xa0;: copiez d&apos;abord des cercles</translation>
    </message>
    <message>
        <source>The clipboard holds too much text to be circles</source>
        <translation>Le presse-papiers contient trop de texte pour que ce soient des cercles</translation>
    </message>
    <message>
        <source>The clipboard holds no circles: %1</source>
        <translation>Le presse-papiers ne contient pas de cercles&#xa0;: %1</translation>
    </message>
    <message>
        <source>The scene on the clipboard has no circles</source>
        <translation>La scène du presse-papiers n&apos;a pas de cercles</translation>
    </message>
</context>
<context>
    <name>CircleName</name>
    <message>
        <source>circle %1</source>
        <translation>cercle %1</translation>
    </message>
</context>
<context>
    <name>Cli</name>
    <message>
        <source>an object with an answer for each id of a question is right</source>
        <translation>il faut un objet avec une réponse pour l&apos;id de chaque question</translation>
    </message>
    <message>
        <source>Judges a program, or with --preset alone the engine&apos;s laws, for one step: by what they do. A program that does not load or that stops does not pass; why is also on standard error, as FILE:LINE: message.</source>
        <translation>Évalue un programme, ou avec --preset seul les lois du moteur, pour une étape&#xa0;: d&apos;après ce qu&apos;ils font. Un programme qui ne se charge pas ou qui s&apos;arrête ne réussit pas&#xa0;; la raison est aussi sur la sortie d&apos;erreur, sous la forme FICHIER:LIGNE: message.</translation>
    </message>
    <message>
        <source>the step, like L42T5</source>
        <translation>l&apos;étape, par exemple L42T5</translation>
    </message>
    <message>
        <source>the program to judge; - is standard input</source>
        <translation>le programme à évaluer&#xa0;; - est l&apos;entrée standard</translation>
    </message>
    <message>
        <source>the scene; without it that of the step</source>
        <translation>la scène&#xa0;; par défaut celle de l&apos;étape</translation>
    </message>
    <message>
        <source>the answers to the step&apos;s questions: {&quot;ID&quot;: ANSWER}</source>
        <translation>les réponses aux questions de l&apos;étape&#xa0;: {&quot;ID&quot;: RÉPONSE}</translation>
    </message>
    <message>
        <source>number of the student for whom the lab draws its values</source>
        <translation>numéro de l&apos;étudiant pour qui le TP tire ses valeurs au sort</translation>
    </message>
    <message>
        <source>the lab&apos;s folder or NAME.cradle; without it the shipped lab</source>
        <translation>le dossier du TP ou NOM.cradle&#xa0;; par défaut le TP fourni</translation>
    </message>
    <message>
        <source>of the scenes; 1 without it</source>
        <translation>des scènes&#xa0;; 1 par défaut</translation>
    </message>
    <message>
        <source>one of %1; text without it</source>
        <translation>une valeur parmi %1&#xa0;; text par défaut</translation>
    </message>
    <message>
        <source>where to write; without it the terminal</source>
        <translation>où écrire&#xa0;; par défaut le terminal</translation>
    </message>
    <message>
        <source>judge only where rlimits, seccomp and namespaces are to be had</source>
        <translation>n&apos;évaluer que là où rlimits, seccomp et espaces de noms sont disponibles</translation>
    </message>
    <message>
        <source>exit with 0 also if it did not pass</source>
        <translation>terminer avec 0 même en cas d&apos;échec</translation>
    </message>
    <message>
        <source>SCRIPT.lua or --preset P.json is missing: what is to be judged?</source>
        <translation>SCRIPT.lua ou --preset P.json manque&#xa0;: que faut-il évaluer&#xa0;?</translation>
    </message>
    <message>
        <source>unknown format %1; one of %2 is right</source>
        <translation>format inconnu&#xa0;: %1&#xa0;; il faut une valeur parmi %2</translation>
    </message>
    <message>
        <source>--seed %1 is not a whole number</source>
        <translation>--seed %1 n&apos;est pas un nombre entier</translation>
    </message>
    <message>
        <source>the lab has no step %1; it has %2</source>
        <translation>le TP n&apos;a pas d&apos;étape %1&#xa0;; il a %2</translation>
    </message>
    <message>
        <source>left out of the zip: %1</source>
        <translation>laissé hors du zip&#xa0;: %1</translation>
    </message>
    <message>
        <source>the results may not go where the submissions are</source>
        <translation>les résultats ne peuvent pas aller là où sont les rendus</translation>
    </message>
    <message>
        <source>there is no folder %1</source>
        <translation>il n&apos;y a pas de dossier %1</translation>
    </message>
    <message>
        <source>a secret was made for the scenes of this class: %1; keep it, and publish it to nobody</source>
        <translation>un secret a été créé pour les scènes de cette classe&#xa0;: %1&#xa0;; conservez-le et ne le donnez à personne</translation>
    </message>
    <message>
        <source>the lab</source>
        <translation>le TP</translation>
    </message>
    <message>
        <source>the secret</source>
        <translation>le secret</translation>
    </message>
    <message>
        <source>the language</source>
        <translation>la langue</translation>
    </message>
    <message>
        <source>--require-isolation: this machine has only: %1</source>
        <translation>--require-isolation&#xa0;: cette machine n&apos;a que&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 holds results of another version (%2); another folder is right, or --again to begin anew</source>
        <translation>%1 contient des résultats d&apos;une autre version (%2)&#xa0;; prenez un autre dossier, ou --again pour tout recommencer</translation>
    </message>
    <message>
        <source>the shard</source>
        <translation>le lot</translation>
    </message>
    <message>
        <source>programs: %1</source>
        <translation>programmes&#xa0;: %1</translation>
    </message>
    <message>
        <source>nothing to judge</source>
        <translation>rien à évaluer</translation>
    </message>
    <message>
        <source>missing: %1 %2</source>
        <translation>manque&#xa0;: %1 %2</translation>
    </message>
    <message>
        <source>students: %1</source>
        <translation>étudiants&#xa0;: %1</translation>
    </message>
    <message>
        <source>none of the folders has the lab; --lab LAB is right</source>
        <translation>aucun des dossiers n&apos;a le TP&#xa0;; il faut --lab TP</translation>
    </message>
    <message>
        <source>the results were judged by another version of the lab</source>
        <translation>les résultats ont été évalués par une autre version du TP</translation>
    </message>
    <message>
        <source>the results of all may not go where those of a shard are</source>
        <translation>les résultats de tous ne peuvent pas aller là où sont ceux d&apos;un lot</translation>
    </message>
    <message>
        <source>--language %1: the results are in the language %2, in which they were judged</source>
        <translation>--language %1&#xa0;: les résultats sont dans la langue %2, celle de leur évaluation</translation>
    </message>
    <message>
        <source>%1 holds results of another version; another folder is right, or --again to begin anew</source>
        <translation>%1 contient des résultats d&apos;une autre version&#xa0;; prenez un autre dossier, ou --again pour tout recommencer</translation>
    </message>
    <message>
        <source>isolation: %1</source>
        <translation>isolation&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 of %2 students</source>
        <translation>étudiants&#xa0;: %1 sur %2</translation>
    </message>
    <message>
        <source>, %1 a minute, %2 left</source>
        <translation>, %1 par minute, reste %2</translation>
    </message>
    <message>
        <source>, %1 steps not passed</source>
        <translation>, étapes non réussies&#xa0;: %1</translation>
    </message>
    <message>
        <source>, %1 not graded</source>
        <translation>, non notées&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 of %2 students, %3 of them as they were before; steps: %4 passed, %5 not passed, %6 not graded; %7</source>
        <translation>étudiants&#xa0;: %1 sur %2, dont inchangés&#xa0;: %3&#xa0;; étapes réussies&#xa0;: %4, non réussies&#xa0;: %5, non notées&#xa0;: %6&#xa0;; %7</translation>
    </message>
    <message>
        <source>the folder of the results</source>
        <translation>le dossier des résultats</translation>
    </message>
    <message>
        <source>from which, with the id, each student&apos;s scenes follow; without it one is made and kept in RESULTS/secret.txt</source>
        <translation>dont découlent, avec l&apos;identifiant, les scènes de chaque étudiant&#xa0;; sinon un secret est créé et gardé dans RESULTS/secret.txt</translation>
    </message>
    <message>
        <source>students at a time; without it as many as processors</source>
        <translation>étudiants à la fois&#xa0;; par défaut autant que de processeurs</translation>
    </message>
    <message>
        <source>who is in the class: a table with columns id, folder, name, number, email, late days</source>
        <translation>qui est dans la classe&#xa0;: un tableau avec les colonnes id, folder, name, number, email, late days</translation>
    </message>
    <message>
        <source>what each late day takes of the points; 0 without it</source>
        <translation>ce que chaque jour de retard retire aux points&#xa0;; 0 par défaut</translation>
    </message>
    <message>
        <source>more percent are never taken; 100 without it</source>
        <translation>retrait maximal, en pour cent&#xa0;; 100 par défaut</translation>
    </message>
    <message>
        <source>judge part I of N of the class, for --merge</source>
        <translation>évaluer le lot I sur N de la classe, pour --merge</translation>
    </message>
    <message>
        <source>judge nothing; put together the results of shards, each a folder</source>
        <translation>ne rien évaluer&#xa0;; réunir les résultats de lots, chacun un dossier</translation>
    </message>
    <message>
        <source>of the pages and of what students are told, such as en or de; en without it</source>
        <translation>des pages et de ce qu&apos;on dit aux étudiants, par exemple fr ou en&#xa0;; en par défaut</translation>
    </message>
    <message>
        <source>tell how the folder was understood, and judge nothing</source>
        <translation>dire comment le dossier a été compris, et ne rien évaluer</translation>
    </message>
    <message>
        <source>begin anew where RESULTS holds those of another version</source>
        <translation>recommencer quand RESULTS contient ceux d&apos;une autre version</translation>
    </message>
    <message>
        <source>text, or json: events on standard output, one a line</source>
        <translation>text, ou json&#xa0;: des événements sur la sortie standard, un par ligne</translation>
    </message>
    <message>
        <source>exit with 0 also if somebody did not pass, if only all are graded</source>
        <translation>terminer avec 0 même si quelqu&apos;un a échoué, du moment que tous sont notés</translation>
    </message>
    <message>
        <source>--jobs %1: a number from 1 to %2 is right</source>
        <translation>--jobs %1&#xa0;: il faut un nombre de 1 à %2</translation>
    </message>
    <message>
        <source>--shard %1: I/N is right, with I from 1 to N</source>
        <translation>--shard %1&#xa0;: il faut I/N, avec I de 1 à N</translation>
    </message>
    <message>
        <source>--shard needs --secret FILE, the same for every shard</source>
        <translation>--shard demande --secret FICHIER, le même pour chaque lot</translation>
    </message>
    <message>
        <source>--language %1: one of %2 is right</source>
        <translation>--language %1&#xa0;: il faut une valeur parmi %2</translation>
    </message>
    <message>
        <source>--late-percent and --late-most are numbers from 0 to 100</source>
        <translation>--late-percent et --late-most sont des nombres de 0 à 100</translation>
    </message>
    <message>
        <source>Judges a class: every step of every student, each in a process of its own that can do nothing else. SUBMISSIONS is a folder of folders or of .cradle-work files, a download of Moodle, Canvas or Blackboard, clones of GitHub Classroom, or a zip of any of these; nothing in it is written. Stopped at any time it goes on where it was. Exit status: 1 if not all passed.</source>
        <translation>Évalue une classe&#xa0;: chaque étape de chaque étudiant, chacune dans un processus à part qui ne peut rien faire d&apos;autre. SUBMISSIONS est un dossier de dossiers ou de fichiers .cradle-work, un téléchargement de Moodle, Canvas ou Blackboard, des clones de GitHub Classroom, ou un zip de tout cela&#xa0;; rien n&apos;y est écrit. Arrêtée à tout moment, l&apos;évaluation reprend où elle en était. Code de sortie&#xa0;: 1 si tous n&apos;ont pas réussi.</translation>
    </message>
    <message>
        <source>what was handed in; with --merge: results</source>
        <translation>ce qui a été rendu&#xa0;; avec --merge&#xa0;: des résultats</translation>
    </message>
    <message>
        <source>unexpected argument %1; see %2 --help</source>
        <translation>argument inattendu&#xa0;: %1&#xa0;; voir %2 --help</translation>
    </message>
    <message>
        <source>--out RESULTS is missing: where are the results to go?</source>
        <translation>--out RESULTS manque&#xa0;: où doivent aller les résultats&#xa0;?</translation>
    </message>
    <message>
        <source>there is no verdict; of the process that judged: %1</source>
        <translation>il n&apos;y a pas de verdict&#xa0;; du processus qui évaluait&#xa0;: %1</translation>
    </message>
    <message>
        <source>this is a folder; a file is right</source>
        <translation>c&apos;est un dossier&#xa0;; il faut un fichier</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>illisible&#xa0;: %1</translation>
    </message>
    <message>
        <source>the application that prints PDF is not beside cradle-cli; F.html is right without it</source>
        <translation>l&apos;application qui imprime le PDF n&apos;est pas à côté de cradle-cli&#xa0;; F.html convient sans elle</translation>
    </message>
    <message>
        <source>the report could not be printed: %1</source>
        <translation>le rapport n&apos;a pas pu être imprimé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Runs a scene, by its laws or by a program, and writes what happens: tables, or without any a summary. If the program stops, why is on standard error as FILE:LINE: message, the tables reach up to there, and the exit status is 1. Ctrl+C ends the run: what is written reaches up to there, and the exit status is 130.</source>
        <translation>Fait tourner une scène, selon ses lois ou par un programme, et écrit ce qui se passe&#xa0;: des tableaux, ou sinon un résumé. Si le programme s&apos;arrête, la raison est sur la sortie d&apos;erreur sous la forme FICHIER:LIGNE: message, les tableaux vont jusque-là et le code de sortie est 1. Ctrl+C met fin à l&apos;exécution&#xa0;: ce qui est écrit va jusque-là, et le code de sortie est 130.</translation>
    </message>
    <message>
        <source>the scene</source>
        <translation>la scène</translation>
    </message>
    <message>
        <source>stopped at %1 s</source>
        <translation>arrêté à %1 s</translation>
    </message>
    <message>
        <source>%1 % of the run; Ctrl+C ends it here</source>
        <translation>%1&#xa0;% de l&apos;exécution&#xa0;; Ctrl+C l&apos;arrête ici</translation>
    </message>
    <message>
        <source>how long, s</source>
        <translation>durée, en s</translation>
    </message>
    <message>
        <source>instead of the preset&apos;s, s</source>
        <translation>au lieu de celui du préréglage, en s</translation>
    </message>
    <message>
        <source>discrete, continuous or exact</source>
        <translation>discrete, continuous ou exact</translation>
    </message>
    <message>
        <source>a program that moves the circles; what it prints goes to standard error, what it plots and draws is dropped, its hits are inferred</source>
        <translation>un programme qui déplace les cercles&#xa0;; ce qu&apos;il affiche va sur la sortie d&apos;erreur, ce qu&apos;il trace et dessine est ignoré, ses chocs sont déduits</translation>
    </message>
    <message>
        <source>write every N-th step only</source>
        <translation>n&apos;écrire qu&apos;un pas sur N</translation>
    </message>
    <message>
        <source>table of the circles&apos; states</source>
        <translation>tableau des états des cercles</translation>
    </message>
    <message>
        <source>table of momentum and energy</source>
        <translation>tableau de la quantité de mouvement et de l&apos;énergie</translation>
    </message>
    <message>
        <source>table of the hits</source>
        <translation>tableau des chocs</translation>
    </message>
    <message>
        <source>of the summary: text, or json, which is written beside tables, too</source>
        <translation>du résumé&#xa0;: text, ou json, qui est écrit même à côté de tableaux</translation>
    </message>
    <message>
        <source>--%1 %2 is not right; %3 is right</source>
        <translation>--%1 %2 ne convient pas&#xa0;; il faut %3</translation>
    </message>
    <message>
        <source>a number above 0 and at most %1</source>
        <translation>un nombre supérieur à 0 et d&apos;au plus %1</translation>
    </message>
    <message>
        <source>a table and the summary cannot both go to standard output; a file for the table is right</source>
        <translation>un tableau et le résumé ne peuvent pas aller tous deux sur la sortie standard&#xa0;; il faut un fichier pour le tableau</translation>
    </message>
    <message>
        <source>--duration S is missing: how long, in s?</source>
        <translation>--duration S manque&#xa0;: combien de temps, en s&#xa0;?</translation>
    </message>
    <message>
        <source>a whole number from 1</source>
        <translation>un nombre entier à partir de 1</translation>
    </message>
    <message>
        <source>%1 steps are too many; at most %2 are right</source>
        <translation>%1 pas, c&apos;est trop&#xa0;; au plus %2 conviennent</translation>
    </message>
    <message>
        <source>contacts merged from %1 s on</source>
        <translation>contacts fusionnés à partir de %1 s</translation>
    </message>
    <message>
        <source>%1: %2 circles, %3 steps, %4 s, %5 hits
momentum (%6, %7) kg m/s, kinetic %8 J, potential %9 J
</source>
        <translation>%1&#xa0;: %2 cercles, %3 pas, %4 s, %5 chocs
quantité de mouvement (%6, %7) kg m/s, énergie cinétique %8 J, potentielle %9 J
</translation>
    </message>
    <message>
        <source>an argument is missing; see %1 --help</source>
        <translation>un argument manque&#xa0;; voir %1 --help</translation>
    </message>
    <message>
        <source>      passes every check
</source>
        <translation>      réussit toutes les vérifications
</translation>
    </message>
    <message>
        <source>      fails %1 without a diagnosis: %2
</source>
        <translation>      échoue à %1 sans diagnostic&#xa0;: %2
</translation>
    </message>
    <message>
        <source>the lab&apos;s folder, or NAME.cradle</source>
        <translation>le dossier du TP, ou NOM.cradle</translation>
    </message>
    <message>
        <source>this step alone</source>
        <translation>cette étape seulement</translation>
    </message>
    <message>
        <source>It was stopped after %1 s of processor time.</source>
        <translation>Il a été arrêté après %1 s de temps de processeur.</translation>
    </message>
    <message>
        <source>It was stopped: it asked the system for what no program needs.</source>
        <translation>Il a été arrêté&#xa0;: il demandait au système ce dont aucun programme n&apos;a besoin.</translation>
    </message>
    <message>
        <source>The process that judged it broke down.</source>
        <translation>Le processus qui l&apos;évaluait est tombé en panne.</translation>
    </message>
    <message>
        <source>No process could be had to judge it.</source>
        <translation>Aucun processus n&apos;a pu être obtenu pour l&apos;évaluer.</translation>
    </message>
    <message>
        <source>%1 programs became differences, %2 lines fewer</source>
        <translation>%1 programmes sont devenus des différences, %2 lignes de moins</translation>
    </message>
    <message>
        <source>Judges a lab itself: starters fail by a check, solutions pass, every known mistake fails and is recognised, and every check is failed by a mistake. Prints which mistake (row) fails which check (column, x) and what it is taken for.</source>
        <translation>Évalue un TP lui-même&#xa0;: les programmes de départ échouent à une vérification, les corrigés réussissent, chaque erreur connue échoue et est reconnue, et chaque vérification est mise en échec par une erreur. Affiche quelle erreur (ligne) échoue à quelle vérification (colonne, x) et pour quoi elle est prise.</translation>
    </message>
    <message>
        <source>keep mistakes and remarks as differences from their solution where that is shorter</source>
        <translation>garder erreurs et appréciations comme différences par rapport à leur corrigé quand c&apos;est plus court</translation>
    </message>
    <message>
        <source>also ask of every check whether some change of the solution fails by it alone; takes minutes</source>
        <translation>demander aussi pour chaque vérification si une modification du corrigé échoue par elle seule&#xa0;; prend des minutes</translation>
    </message>
    <message>
        <source>with how many seeds every solution is judged, 1 to 1000</source>
        <translation>avec combien de graines chaque corrigé est évalué, de 1 à 1000</translation>
    </message>
    <message>
        <source>--seeds takes a whole number from 1 to 1000, not %1</source>
        <translation>--seeds prend un nombre entier de 1 à 1000, pas %1</translation>
    </message>
    <message>
        <source>the lab&apos;s folder or NAME.cradle; without it the shipped lab that the work belongs to</source>
        <translation>le dossier du TP ou NOM.cradle&#xa0;; par défaut le TP fourni auquel le travail appartient</translation>
    </message>
    <message>
        <source>of the student</source>
        <translation>de l&apos;étudiant</translation>
    </message>
    <message>
        <source>to the teacher</source>
        <translation>à l&apos;enseignant</translation>
    </message>
    <message>
        <source>where to write</source>
        <translation>où écrire</translation>
    </message>
    <message>
        <source>of the report, such as en or de; without it that of the system</source>
        <translation>du rapport, par exemple fr ou en&#xa0;; par défaut celle du système</translation>
    </message>
    <message>
        <source>Writes the report of a student&apos;s work: what was asked, what the program does, how it came about. Every step is judged anew.</source>
        <translation>Écrit le rapport du travail d&apos;un étudiant&#xa0;: ce qui était demandé, ce que fait le programme, comment il est né. Chaque étape est évaluée à nouveau.</translation>
    </message>
    <message>
        <source>the folder, or a FILE.cradle-work</source>
        <translation>le dossier, ou un FICHIER.cradle-work</translation>
    </message>
    <message>
        <source>--output F.pdf or --output F.html is right</source>
        <translation>il faut --output F.pdf ou --output F.html</translation>
    </message>
    <message>
        <source>Writes a student&apos;s work into one file to be handed in: the programs, scenes, notes, the history and a report. Every step is judged once more.</source>
        <translation>Écrit le travail d&apos;un étudiant dans un seul fichier à rendre&#xa0;: les programmes, les scènes, les remarques, l&apos;historique et un rapport. Chaque étape est évaluée encore une fois.</translation>
    </message>
    <message>
        <source>the folder</source>
        <translation>le dossier</translation>
    </message>
    <message>
        <source>--output FILE.cradle-work is right</source>
        <translation>il faut --output FICHIER.cradle-work</translation>
    </message>
    <message>
        <source>this is too long for a program; at most %1 are right</source>
        <translation>c&apos;est trop long pour un programme&#xa0;; au plus %1 conviennent</translation>
    </message>
    <message>
        <source>this is text in UTF-16; UTF-8 would be right</source>
        <translation>c&apos;est du texte en UTF-16&#xa0;; il faut de l&apos;UTF-8</translation>
    </message>
    <message>
        <source>this is no text in UTF-8, which would be right</source>
        <translation>ce n&apos;est pas du texte en UTF-8&#xa0;; il faut de l&apos;UTF-8</translation>
    </message>
    <message>
        <source>Writes a lab into one file. For students it leaves out solutions, mistakes, remarks and files that no step uses; what checks and questions ask for stays.</source>
        <translation>Écrit un TP dans un seul fichier. Pour les étudiants, il laisse de côté corrigés, erreurs, appréciations et fichiers qu&apos;aucune étape n&apos;utilise&#xa0;; ce que demandent vérifications et questions reste.</translation>
    </message>
    <message>
        <source>leave out what students shall find</source>
        <translation>laisser de côté ce que les étudiants doivent trouver</translation>
    </message>
    <message>
        <source>the file to write; needed</source>
        <translation>le fichier à écrire&#xa0;; nécessaire</translation>
    </message>
    <message>
        <source>--output is missing: the file to write</source>
        <translation>--output manque&#xa0;: le fichier à écrire</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) left out</source>
        <translation>
            <numerusform>%n fichier laissé de côté</numerusform>
            <numerusform>%n fichiers laissés de côté</numerusform>
        </translation>
    </message>
    <message>
        <source>students are told what checks saw, and not which law is wrong, in %1: these checks tell no law</source>
        <translation>dans %1, les étudiants lisent ce que les vérifications ont vu, et non quelle loi est fausse&#xa0;: ces vérifications n&apos;en nomment aucune</translation>
    </message>
    <message>
        <source>this is an edition for students, without the solutions and mistakes that prove a lab; the whole lab is right</source>
        <translation>ceci est une édition pour étudiants, sans les corrigés et les erreurs qui prouvent un TP&#xa0;; il faut le TP entier</translation>
    </message>
    <message>
        <source>writing, %1 of %2</source>
        <translation>écriture, %1 sur %2</translation>
    </message>
    <message>
        <source>there is nothing of that name; the name of something new must be UTF-8</source>
        <translation>rien ne porte ce nom&#xa0;; le nom de ce qui est nouveau doit être en UTF-8</translation>
    </message>
    <message>
        <source>of what the student is told, such as en or de; en without it</source>
        <translation>de ce qu&apos;on dit à l&apos;étudiant, par exemple fr ou en&#xa0;; en par défaut</translation>
    </message>
    <message>
        <source>the step %1 cannot be read; why is said above</source>
        <translation>l&apos;étape %1 ne peut pas être lue&#xa0;; la raison est dite plus haut</translation>
    </message>
    <message>
        <source>of files of a lab that draws values: those of the student with this number</source>
        <translation>pour les fichiers d&apos;un TP qui tire des valeurs&#xa0;: celles de l&apos;étudiant portant ce numéro</translation>
    </message>
    <message>
        <source>      fails %1; what is measured tells: %2
</source>
        <translation>      échoue à %1&#xa0;; ce qui est mesuré dit&#xa0;: %2
</translation>
    </message>
    <message>
        <source>Makes mistakes that students make out of the solutions of a lab, and names those that pass every check (a check may be missing), those that fail without a diagnosis (a mistake may be missing), and those of which a law that is measured tells.</source>
        <translation>Fabrique, à partir des corrigés d&apos;un TP, des erreurs comme en font les étudiants, et nomme celles qui passent toutes les vérifications (il en manque peut-être une), celles qui échouent sans diagnostic (il manque peut-être une erreur) et celles dont une loi mesurée dit quelque chose.</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n étape</numerusform>
            <numerusform>%n étapes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mistakes</source>
        <translation>
            <numerusform>%n erreur</numerusform>
            <numerusform>%n erreurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problems</source>
        <translation>
            <numerusform>%n problème</numerusform>
            <numerusform>%n problèmes</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>the folder %1 is no step: lab.json does not list it
</source>
        <translation>le dossier %1 n&apos;est pas une étape&#xa0;: lab.json ne le cite pas
</translation>
    </message>
    <message>
        <source>Values of students that were tried:
</source>
        <translation>Valeurs d&apos;étudiants essayées&#xa0;:
</translation>
    </message>
    <message>
        <source>%1 is written: %2 of %3 steps passed</source>
        <translation>%1 est écrit&#xa0;: %2 étapes réussies sur %3</translation>
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
        <translation>jusqu&apos;à %1 m (moyenne quadratique %2 m)</translation>
    </message>
    <message>
        <source>%1 J</source>
        <comment>an energy, with its sign</comment>
        <translation>%1 J</translation>
    </message>
    <message>
        <source>Off the exact motion: %1, %2.</source>
        <comment>energy, distance</comment>
        <translation>Écart au mouvement exact&#xa0;: %1, %2.</translation>
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
        <translation>Mille cercles égaux partent à la même vitesse, 2 m/s, dans toutes les directions. Appuyez sur «&#xa0;Lancer&#xa0;» et observez les vitesses en bas à droite.

Aucun choc n&apos;est visé, et pourtant en une ou deux secondes les vitesses s&apos;étalent jusqu&apos;à se placer sur une courbe, celle de Maxwell et Boltzmann. Aucune énergie ne se perd&#xa0;: seule change la façon dont les cercles la partagent.

- Remontez la ligne de temps&#xa0;: la courbe est toujours la même, car elle ne dépend que de l&apos;énergie moyenne.
- Mettez la restitution à 0.99&#xa0;: le gaz se refroidit et la courbe se déplace vers la gauche.
- Les couleurs disent de quelle moitié vient un cercle. Elles se mélangent bien plus lentement que les vitesses.</translation>
    </message>
    <message>
        <source>A heavy circle falls onto a bed of 124 light ones, each of which has a six-thousandth of its mass. Press Run and watch the energy.

A hit with e = 0.9 leaves e² = 81 % of the energy of the motion towards each other. Yet here a fifth of all energy goes in less than a tenth of a second, most of it in two blows, at 0.94 s and 0.99 s: light circles that are caught between the heavy one and the floor are hit to and fro ever faster, hundreds of times in a hundredth of a second. That is how an inelastic collapse begins.

- Go back on the timeline to the blows, and step through them with → and ←.
- Set the restitution to 1: the bed becomes a gas under a piston, and throws it back.</source>
        <translation>Un cercle lourd tombe sur un lit de 124 cercles légers, dont chacun a un six-millième de sa masse. Appuyez sur «&#xa0;Lancer&#xa0;» et observez l&apos;énergie.

Un choc avec e = 0.9 laisse e² = 81&#xa0;% de l&apos;énergie du mouvement de rapprochement. Pourtant, ici, un cinquième de toute l&apos;énergie disparaît en moins d&apos;un dixième de seconde, surtout en deux coups, à 0.94 s et 0.99 s&#xa0;: des cercles légers pris entre le lourd et le sol sont renvoyés de l&apos;un à l&apos;autre de plus en plus vite, des centaines de fois en un centième de seconde. C&apos;est ainsi que commence un effondrement inélastique.

- Remontez la ligne de temps jusqu&apos;à ces coups et parcourez-les pas à pas avec → et ←.
- Mettez la restitution à 1&#xa0;: le lit devient un gaz sous un piston, et le renvoie.</translation>
    </message>
    <message>
        <source>Gas</source>
        <translation>Gaz</translation>
    </message>
    <message>
        <source>Piston drop</source>
        <translation>Chute d&apos;un piston</translation>
    </message>
    <message>
        <source>This scene belongs to no step. Choose a step above to go back to the lab.</source>
        <translation>Cette scène n&apos;appartient à aucune étape. Choisissez une étape ci-dessus pour revenir au TP.</translation>
    </message>
</context>
<context>
    <name>Expression</name>
    <message>
        <source>“%1” is not expected there</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas attendu là</translation>
    </message>
    <message>
        <source>it comes to no finite number</source>
        <translation>cela ne donne pas un nombre fini</translation>
    </message>
    <message>
        <source>“%1” is no number: %2</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas un nombre&#xa0;: %2</translation>
    </message>
    <message>
        <source>it is too deep</source>
        <translation>c&apos;est trop imbriqué</translation>
    </message>
    <message>
        <source>a closing parenthesis is missing</source>
        <translation>il manque une parenthèse fermante</translation>
    </message>
    <message>
        <source>something is missing at its end</source>
        <translation>il manque quelque chose à la fin</translation>
    </message>
    <message>
        <source>there is no value called %1</source>
        <translation>il n&apos;y a pas de valeur nommée %1</translation>
    </message>
    <message>
        <source>a parenthesis behind %1 is missing</source>
        <translation>il manque une parenthèse après %1</translation>
    </message>
    <message>
        <source>a comma and another number are missing</source>
        <translation>il manque une virgule et un autre nombre</translation>
    </message>
    <message>
        <source>an expression of at most %1 characters is right</source>
        <translation>une expression d&apos;au plus %1 caractères convient</translation>
    </message>
    <message>
        <source>%1 and %2 stand side by side</source>
        <translation>%1 et %2 se côtoient</translation>
    </message>
    <message>
        <source>a power with that unit is none</source>
        <translation>une puissance avec cette unité n&apos;existe pas</translation>
    </message>
    <message>
        <source>there is a unit too many</source>
        <translation>il y a une unité de trop</translation>
    </message>
    <message>
        <source>%1 is taken of a number without a unit, not of one in %2</source>
        <translation>%1 se prend d&apos;un nombre sans unité, non d&apos;un nombre en %2</translation>
    </message>
    <message>
        <source>it is in %1; %2 is right here</source>
        <translation>c&apos;est en %1&#xa0;; ici il faut %2</translation>
    </message>
</context>
<context>
    <name>FileIo</name>
    <message>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <source>your share of the disk is full</source>
        <translation>votre quota de disque est atteint</translation>
    </message>
    <message>
        <source>a file may not be so large here</source>
        <translation>un fichier ne peut pas être aussi grand ici</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>le disque est en lecture seule</translation>
    </message>
    <message>
        <source>you may not write here</source>
        <translation>vous n&apos;avez pas le droit d&apos;écrire ici</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>ce dossier n&apos;existe pas</translation>
    </message>
    <message>
        <source>a file is where a folder should be</source>
        <translation>il y a un fichier là où il faudrait un dossier</translation>
    </message>
    <message>
        <source>this is a folder; the name of a file is right</source>
        <translation>c&apos;est un dossier&#xa0;; il faut le nom d&apos;un fichier</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>le nom est trop long</translation>
    </message>
    <message>
        <source>it is closed</source>
        <translation>il est fermé</translation>
    </message>
    <message>
        <source>the disk has a fault</source>
        <translation>le disque est défectueux</translation>
    </message>
</context>
<context>
    <name>Findings</name>
    <message>
        <source> or </source>
        <translation> ou </translation>
    </message>
    <message>
        <source>Rims touch where the centres are r₁ + r₂ apart, here %1 m.</source>
        <translation>Les bords se touchent quand la distance des centres vaut r₁ + r₂, ici %1 m.</translation>
    </message>
    <message>
        <source>Only half of r₁ + r₂ counts in the test of contact</source>
        <translation>Seule la moitié de r₁ + r₂ compte dans le test de contact</translation>
    </message>
    <message>
        <source>The circles answer only when their centres have met</source>
        <translation>Les cercles ne réagissent que lorsque leurs centres se sont rencontrés</translation>
    </message>
    <message>
        <source>Boxes are compared, not circles</source>
        <translation>Ce sont des boîtes qui sont comparées, pas des cercles</translation>
    </message>
    <message>
        <source>Side by side they answer in time, but on a diagonal when their centres are still %2 m apart: x and y each on its own ask for squares. Make one distance out of the two differences.</source>
        <translation>Côte à côte, ils réagissent à temps, mais en diagonale alors que leurs centres sont encore à %2 m l&apos;un de l&apos;autre&#xa0;: x et y examinés séparément décrivent des carrés. Faites des deux différences une seule distance.</translation>
    </message>
    <message>
        <source>|Δx| + |Δy| is not the distance</source>
        <translation>|Δx| + |Δy| n&apos;est pas la distance</translation>
    </message>
    <message>
        <source>Side by side they answer in time, but on a diagonal only when their centres are %2 m apart. A distance is the root of the sum of the squares.</source>
        <translation>Côte à côte, ils réagissent à temps, mais en diagonale seulement quand leurs centres sont à %2 m l&apos;un de l&apos;autre. Une distance est la racine de la somme des carrés.</translation>
    </message>
    <message>
        <source>A squared distance is compared with a length</source>
        <translation>Le carré d&apos;une distance est comparé à une longueur</translation>
    </message>
    <message>
        <source>Contact is tested at %1, not at r₁ + r₂</source>
        <translation>Le contact est testé avec %1, pas avec r₁ + r₂</translation>
    </message>
    <message>
        <source>the larger radius</source>
        <translation>le plus grand rayon</translation>
    </message>
    <message>
        <source>the smaller radius</source>
        <translation>le plus petit rayon</translation>
    </message>
    <message>
        <source>the difference of the radii</source>
        <translation>la différence des rayons</translation>
    </message>
    <message>
        <source>twice the larger radius</source>
        <translation>le double du plus grand rayon</translation>
    </message>
    <message>
        <source>the sum of the diameters</source>
        <translation>la somme des diamètres</translation>
    </message>
    <message>
        <source>The circles are held and keep their velocities</source>
        <translation>Les cercles sont retenus et gardent leurs vitesses</translation>
    </message>
    <message>
        <source>The circles run through each other</source>
        <translation>Les cercles se traversent</translation>
    </message>
    <message>
        <source>The circles act on each other</source>
        <translation>Les cercles agissent l&apos;un sur l&apos;autre</translation>
    </message>
    <message>
        <source>In this step they should still pass through each other.</source>
        <translation>À cette étape, ils doivent encore se traverser.</translation>
    </message>
    <message>
        <source>Where they overlapped, your program put circle %1 elsewhere than its velocity takes it. In this step they should still pass through each other.</source>
        <translation>Là où ils se chevauchaient, votre programme a mis le cercle %1 ailleurs que là où sa vitesse le mène. Dans cette étape, ils doivent encore se traverser.</translation>
    </message>
    <message>
        <source>The circles are answered long after they meet</source>
        <translation>Les cercles réagissent longtemps après leur rencontre</translation>
    </message>
    <message>
        <source>Circles that overlap at the start of a run and move apart are not answered at once. Look at what is asked before they answer, and at what your program counts, or keeps from one step to the next.</source>
        <translation>Des cercles qui se chevauchent au début d&apos;une exécution et s&apos;éloignent l&apos;un de l&apos;autre ne réagissent pas aussitôt. Regardez ce qui est demandé avant qu&apos;ils réagissent, et ce que votre programme compte ou conserve d&apos;un pas à l&apos;autre.</translation>
    </message>
    <message>
        <source>The circles answer when they part, not when they meet</source>
        <translation>Les cercles réagissent quand ils se séparent, pas quand ils se rencontrent</translation>
    </message>
    <message>
        <source>They ran into each other until their centres were %1 m apart, and were answered in the step in which these passed each other; circles that overlap and move apart are not answered. Rims touch where the centres are r₁ + r₂ apart: look at what their distance is compared with.</source>
        <translation>Ils sont entrés l&apos;un dans l&apos;autre jusqu&apos;à ce que leurs centres soient à %1 m l&apos;un de l&apos;autre, et ont eu leur réponse au pas où ceux-ci se sont croisés&#xa0;; des cercles qui se recouvrent et s&apos;éloignent n&apos;en ont pas. Les bords se touchent quand les centres sont à r₁ + r₂&#xa0;: regardez à quoi leur distance est comparée.</translation>
    </message>
    <message>
        <source>The circles answer where their centres meet</source>
        <translation>Les cercles réagissent là où leurs centres se rencontrent</translation>
    </message>
    <message>
        <source>With r₁ = %1 m and r₂ = %2 m, met at %3°, they answered when their centres were between %4 and %5 m apart.</source>
        <translation>Avec r₁ = %1 m et r₂ = %2 m, en se rencontrant sous un angle de %3°, ils ont réagi quand leurs centres étaient entre %4 et %5 m l&apos;un de l&apos;autre.</translation>
    </message>
    <message>
        <source>The test of contact acts as if a number stood for r₁ + r₂</source>
        <translation>Le test de contact agit comme si un nombre tenait lieu de r₁ + r₂</translation>
    </message>
    <message>
        <source>The circles answer before they touch</source>
        <translation>Les cercles réagissent avant de se toucher</translation>
    </message>
    <message>
        <source>The circles answer too late</source>
        <translation>Les cercles réagissent trop tard</translation>
    </message>
    <message>
        <source>A hit puts circle %1 somewhere else

When they touched it was put to %2 m, far from where it came from. Each circle goes back to its *own* old place: look at which one it gets.</source>
        <translation>Un choc déplace le cercle %1

Au contact, il a été mis en %2 m, loin d&apos;où il venait. Chaque cercle retourne à sa *propre* ancienne position&#xa0;: regardez laquelle il reçoit.</translation>
    </message>
    <message>
        <source>Nothing happens when it is circle 2 that comes nearer</source>
        <translation>Rien ne se passe quand c&apos;est le cercle 2 qui se rapproche</translation>
    </message>
    <message>
        <source>Along the line of centres circle 1 had %1 m/s and circle 2 %2 m/s, so they came nearer with %3 m/s, and ran into each other; other meetings are answered. What counts is the velocity of one relative to the other.</source>
        <translation>Suivant la ligne des centres, le cercle 1 avait %1 m/s et le cercle 2 %2 m/s&#xa0;; ils se rapprochaient donc à %3 m/s, et sont entrés l&apos;un dans l&apos;autre&#xa0;; d&apos;autres rencontres provoquent une réaction. Ce qui compte est la vitesse de l&apos;un par rapport à l&apos;autre.</translation>
    </message>
    <message>
        <source>Circles that already part are hit again</source>
        <translation>Des cercles qui se séparent déjà subissent un nouveau choc</translation>
    </message>
    <message>
        <source>They overlapped and moved apart with %1 m/s; the next step turned them to %2 and %3 m/s.</source>
        <translation>Ils se chevauchaient et s&apos;éloignaient l&apos;un de l&apos;autre à %1 m/s&#xa0;; le pas suivant a donné %2 et %3 m/s.</translation>
    </message>
    <message>
        <source>They moved apart with %1 m/s, with %4 m between their rims; the next step turned them to %2 and %3 m/s.</source>
        <translation>Ils s&apos;éloignaient l&apos;un de l&apos;autre à %1 m/s, avec %4 m entre leurs bords&#xa0;; le pas suivant a donné %2 et %3 m/s.</translation>
    </message>
    <message>
        <source>Circles that move apart have had their hit: ask whether they come nearer.</source>
        <translation>Des cercles qui s&apos;éloignent ont déjà eu leur choc&#xa0;: demandez s&apos;ils se rapprochent.</translation>
    </message>
    <message>
        <source>A run that begins so leaves them alone: look at what your program keeps from one step to the next.</source>
        <translation>Une exécution qui commence ainsi les laisse en paix&#xa0;: regardez ce que votre programme garde d&apos;un pas au suivant.</translation>
    </message>
    <message>
        <source>circle %1</source>
        <translation>le cercle %1</translation>
    </message>
    <message>
        <source>both circles</source>
        <translation>les deux cercles</translation>
    </message>
    <message>
        <source>all circles</source>
        <translation>tous les cercles</translation>
    </message>
    <message>
        <source>the circles %1</source>
        <translation>les cercles %1</translation>
    </message>
    <message>
        <source>The velocity of %who changes although no force acts</source>
        <translation>La vitesse change alors qu’aucune force n’agit : %who</translation>
    </message>
    <message>
        <source>Without a force a velocity stays as it is: look for the line that changes it in free flight.</source>
        <translation>Sans force, une vitesse reste telle quelle : cherchez la ligne qui la modifie en vol libre.</translation>
    </message>
    <message>
        <source>The same fault shows in this, too: %1.</source>
        <translation>La même faute se voit aussi en ceci : %1.</translation>
    </message>
    <message>
        <source>Line %1 sets a field `%2` of your own, which nothing reads: a circle has a `%3`.</source>
        <translation>La ligne %1 fixe un champ `%2` à vous, que rien ne lit&#xa0;: un cercle a `%3`.</translation>
    </message>
    <message>
        <source>The whole velocities change hands and are turned round as well</source>
        <translation>Les vitesses entières sont échangées et, de plus, inversées</translation>
    </message>
    <message>
        <source>Both circles get their new part along the normal besides the old</source>
        <translation>Les deux cercles reçoivent leur nouvelle part normale en plus de l’ancienne</translation>
    </message>
    <message>
        <source>Circle 1 gets its new part along the normal besides the old</source>
        <translation>Le cercle 1 reçoit sa nouvelle part normale en plus de l’ancienne</translation>
    </message>
    <message>
        <source>Circle 2 gets its new part along the normal besides the old</source>
        <translation>Le cercle 2 reçoit sa nouvelle part normale en plus de l’ancienne</translation>
    </message>
    <message>
        <source>A hit gives a new part along the line of centres in place of the old one: look at what the new part is added to.</source>
        <translation>Un choc donne une nouvelle part le long de la ligne des centres à la place de l’ancienne : regardez à quoi la nouvelle part est ajoutée.</translation>
    </message>
    <message>
        <source>The circles answer each other although they are far apart</source>
        <translation>Les cercles réagissent l’un à l’autre alors qu’ils sont éloignés</translation>
    </message>
    <message>
        <source>Started with %1 and %2 m/s, far from each other, they have %3 and %4 m/s one step of %5 s later; where circle %6 starts at %7 m, circle %8 keeps its velocity. Look at how your program tests whether they touch.</source>
        <translation>Lancés à %1 et %2 m/s, loin l’un de l’autre, ils ont %3 et %4 m/s un pas de %5 s plus tard ; là où le cercle %6 part de %7 m, le cercle %8 garde sa vitesse. Regardez comment votre programme vérifie s’ils se touchent.</translation>
    </message>
    <message>
        <source>Started with %1 and %2 m/s, far from each other, they have %3 and %4 m/s one step of %5 s later: the velocities change against each other, as in a hit. Look at how your program tests whether they touch.</source>
        <translation>Lancés à %1 et %2 m/s, loin l’un de l’autre, ils ont %3 et %4 m/s un pas de %5 s plus tard : les vitesses changent en sens opposés, comme dans un choc. Regardez comment votre programme vérifie s’ils se touchent.</translation>
    </message>
    <message>
        <source>A number stands for gravity in the motion of %who</source>
        <translation>Un nombre tient lieu de pesanteur dans le mouvement, pour %who</translation>
    </message>
    <message>
        <source>Gravity pulls %who in a wrong direction</source>
        <translation>La pesanteur tire dans une mauvaise direction, pour %who</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² the velocity changes by %2 m/s in a step of %3 s; it should change by %4 m/s.</source>
        <translation>Sous la pesanteur %1 m/s², la vitesse change de %2 m/s en un pas de %3 s&#xa0;; elle doit changer de %4 m/s.</translation>
    </message>
    <message>
        <source>Gravity moves %who at once and changes no velocity</source>
        <translation>La pesanteur agit directement sur la position et ne change aucune vitesse, pour %who</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² a circle at rest is %2 m away after a step of %3 s, and its velocity is still 0. Gravity is an acceleration: it changes the velocity, and that moves the circle.</source>
        <translation>Sous la pesanteur %1 m/s², un cercle au repos se retrouve à %2 m de là après un pas de %3 s, et sa vitesse est toujours 0. La pesanteur est une accélération&#xa0;: elle change la vitesse, et c&apos;est la vitesse qui change la position.</translation>
    </message>
    <message>
        <source>Gravity acts on %who for a whole second in every step</source>
        <translation>À chaque pas, la pesanteur agit une seconde entière sur %who</translation>
    </message>
    <message>
        <source>An acceleration says what a second changes; a step lasts only Δt. Compare the units on both sides.</source>
        <translation>Une accélération dit ce que change une seconde&#xa0;; un pas ne dure que Δt. Comparez les unités des deux côtés.</translation>
    </message>
    <message>
        <source>Gravity on %who is multiplied by the timestep twice</source>
        <translation>La pesanteur est multipliée deux fois par le pas de temps, pour %who</translation>
    </message>
    <message>
        <source>Count how often the timestep stands in the line that changes the velocity.</source>
        <translation>Comptez combien de fois le pas de temps figure dans la ligne qui change la vitesse.</translation>
    </message>
    <message>
        <source>A fixed number stands for the timestep in the fall of %who</source>
        <translation>Un nombre fixe tient lieu de pas de temps dans la chute, pour %who</translation>
    </message>
    <message>
        <source>Look at the signs.</source>
        <translation>Regardez les signes.</translation>
    </message>
    <message>
        <source>Gravity acts on %who twice as strongly</source>
        <translation>La pesanteur agit deux fois trop fort sur %who</translation>
    </message>
    <message>
        <source>Count the lines of a step that change the velocity, and look at their factors.</source>
        <translation>Comptez les lignes d&apos;un pas qui changent la vitesse, et regardez leurs facteurs.</translation>
    </message>
    <message>
        <source>The velocity of %who gets only half of gravity</source>
        <translation>La vitesse ne reçoit que la moitié de la pesanteur, pour %who</translation>
    </message>
    <message>
        <source>Look at the factors in the line that changes the velocity.</source>
        <translation>Regardez les facteurs de la ligne qui change la vitesse.</translation>
    </message>
    <message>
        <source>The fall of %who is not that of the gravity in the scene</source>
        <translation>La chute n&apos;est pas celle de la pesanteur de la scène, pour %who</translation>
    </message>
    <message>
        <source>In your own scene gravity is %1 m/s², and the velocity changes by %2 m/s in a second. A copy of gravity keeps the value of the moment when it was made: before or after `on_load` has set it?</source>
        <translation>Dans votre propre scène, la pesanteur vaut %1 m/s², et la vitesse change de %2 m/s en une seconde. Une copie de la pesanteur garde la valeur de l&apos;instant où elle a été faite&#xa0;: avant ou après que `on_load` l&apos;a fixée&#xa0;?</translation>
    </message>
    <message>
        <source>In your own scene the first step changes the velocity of %who</source>
        <translation>Dans votre propre scène, le premier pas change la vitesse, pour %who</translation>
    </message>
    <message>
        <source>The motion of %who is no known method</source>
        <translation>Le mouvement ne suit aucune méthode connue, pour %who</translation>
    </message>
    <message>
        <source>The motion of %who is %1, not %2</source>
        <translation>La méthode n&apos;est pas la bonne pour %who&#xa0;: %1, pas %2</translation>
    </message>
    <message>
        <source>The motion of %who is no known method; %1 is asked for</source>
        <translation>Le mouvement ne suit aucune méthode connue, pour %who&#xa0;; demandé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Every step puts %who where circle %1 is</source>
        <translation>Chaque pas met %who là où est le cercle %1</translation>
    </message>
    <message>
        <source>The velocity of %who is set anew in every step</source>
        <translation>À chaque pas, la vitesse est redéfinie pour %who</translation>
    </message>
    <message>
        <source>The x of the velocity of %who is 0 after every step</source>
        <translation>Après chaque pas, le x de la vitesse est 0 pour %who</translation>
    </message>
    <message>
        <source>The x of the velocity of %who is set anew in every step</source>
        <translation>À chaque pas, le x de la vitesse est redéfini pour %who</translation>
    </message>
    <message>
        <source>The y of the velocity of %who is 0 after every step</source>
        <translation>Après chaque pas, le y de la vitesse est 0 pour %who</translation>
    </message>
    <message>
        <source>The y of the velocity of %who is set anew in every step</source>
        <translation>À chaque pas, le y de la vitesse est redéfini pour %who</translation>
    </message>
    <message>
        <source>The velocity of circle %1 moves %who</source>
        <translation>La vitesse du cercle %1 déplace %who</translation>
    </message>
    <message>
        <source>The velocity of %who at the start is not taken over</source>
        <translation>La vitesse au départ n&apos;est pas reprise, pour %who</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later, and so it has from every other start tried; later steps go on from that.</source>
        <translation>Parti avec %1 m/s, il a %2 m/s un pas plus tard, et de même pour tout autre départ essayé ; les pas suivants continuent de là.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later; one part is the same from every other start tried, and later steps go on from that.</source>
        <translation>Parti avec %1 m/s, il a %2 m/s un pas plus tard ; une composante est la même pour tout autre départ essayé, et les pas suivants continuent de là.</translation>
    </message>
    <message>
        <source>A run begins with the velocity that the circle has then: look at which one your program begins with instead.</source>
        <translation>Une exécution commence avec la vitesse que le cercle a alors : regardez avec laquelle votre programme commence à la place.</translation>
    </message>
    <message>
        <source>The place of %who at the start is not taken over</source>
        <translation>La position au départ n&apos;est pas reprise, pour %who</translation>
    </message>
    <message>
        <source>Started at rest at two places, it is at one and the same place two steps later; the second step goes on from where the first one ends. A run begins where the circle is then: look at which place your program begins with instead.</source>
        <translation>Parti au repos de deux endroits, il est deux pas plus tard à un seul et même endroit ; le second pas continue là où finit le premier. Une exécution commence là où est alors le cercle : regardez avec quelle position votre programme commence à la place.</translation>
    </message>
    <message>
        <source>A step of %who does %1 times what it should</source>
        <translation>Un pas fait %1 fois ce qu&apos;il doit, pour %who</translation>
    </message>
    <message>
        <source>x and y of the velocity of %who are exchanged</source>
        <translation>x et y de la vitesse sont échangés, pour %who</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it goes %2 m in the first step of %3 s and has %4 m/s after it. Each part of the velocity goes on from itself: look at the line that writes it down.</source>
        <translation>Parti avec %1 m/s, il parcourt %2 m dans le premier pas de %3 s et a ensuite %4 m/s. Chaque composante de la vitesse continue d&apos;elle-même : regardez la ligne qui l&apos;écrit.</translation>
    </message>
    <message>
        <source>The velocity of %who at the start is not taken over whole</source>
        <translation>La vitesse au départ n&apos;est pas entièrement reprise, pour %who</translation>
    </message>
    <message>
        <source>The new place of %who does not depend on the old one</source>
        <translation>La nouvelle position ne dépend pas de l&apos;ancienne, pour %who</translation>
    </message>
    <message>
        <source>The old place of %who is multiplied, too</source>
        <translation>L&apos;ancienne position est multipliée elle aussi, pour %who</translation>
    </message>
    <message>
        <source>Two that start 1 m apart, at rest, are %1 m apart one step of %2 s later. The old position is kept as it is; the way v Δt is added to it: look at the brackets.</source>
        <translation>Deux cercles partis à 1 m l&apos;un de l&apos;autre, au repos, sont à %1 m l&apos;un de l&apos;autre un pas de %2 s plus tard. L&apos;ancienne position se garde telle quelle&#xa0;; on lui ajoute le chemin v Δt&#xa0;: regardez les parenthèses.</translation>
    </message>
    <message>
        <source> Both parts of the position must change, each by its own part of the velocity.</source>
        <translation> Les deux coordonnées de la position doivent changer, chacune avec sa propre composante de la vitesse.</translation>
    </message>
    <message>
        <source>Each part of the position changes by its own part of the velocity.</source>
        <translation>Chaque coordonnée de la position change avec sa propre composante de la vitesse.</translation>
    </message>
    <message>
        <source>The x part of the velocity moves %who in y</source>
        <translation>La composante x de la vitesse déplace %who en y</translation>
    </message>
    <message>
        <source>The y part of the velocity moves %who in x</source>
        <translation>La composante y de la vitesse déplace %who en x</translation>
    </message>
    <message>
        <source>x and y of the velocity are exchanged in the way of %who</source>
        <translation>x et y de la vitesse sont échangés dans le déplacement, pour %who</translation>
    </message>
    <message>
        <source>The way of %who in a step is not v Δt</source>
        <translation>Le chemin d&apos;un pas n&apos;est pas v Δt pour %who</translation>
    </message>
    <message>
        <source>The way of %who is not multiplied by the timestep</source>
        <translation>Le chemin n&apos;est pas multiplié par le pas de temps, pour %who</translation>
    </message>
    <message>
        <source>A velocity says how far it gets in a whole second; a step lasts only Δt.</source>
        <translation>Une vitesse dit le chemin d&apos;une seconde entière&#xa0;; un pas ne dure que Δt.</translation>
    </message>
    <message>
        <source>The way of %who is multiplied by the timestep twice</source>
        <translation>Le chemin est multiplié deux fois par le pas de temps, pour %who</translation>
    </message>
    <message>
        <source>Count how often the timestep stands in the line that moves it.</source>
        <translation>Comptez combien de fois le pas de temps figure dans la ligne du déplacement.</translation>
    </message>
    <message>
        <source>A fixed number stands for the timestep in the way of %who</source>
        <translation>Un nombre fixe tient lieu de pas de temps dans le chemin, pour %who</translation>
    </message>
    <message>
        <source>Look at the line that changes the position.</source>
        <translation>Regardez la ligne qui change la position.</translation>
    </message>
    <message>
        <source>The way of %who is subtracted instead of added</source>
        <translation>Le chemin est soustrait au lieu d&apos;être ajouté, pour %who</translation>
    </message>
    <message>
        <source>Look at the sign in the line that moves it.</source>
        <translation>Regardez le signe dans la ligne du déplacement.</translation>
    </message>
    <message>
        <source>Every step moves %who twice as far</source>
        <translation>Chaque pas déplace %who deux fois trop loin</translation>
    </message>
    <message>
        <source>Look at what your program keeps from one step to the next, and at what it has of that before the first.</source>
        <translation>Regardez ce que votre programme garde d&apos;un pas au suivant, et ce qu&apos;il en a avant le premier.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it goes %2 m in the first step of %3 s; made as the second is, that step goes %4 m.</source>
        <translation>Lancé à %1 m/s, il avance de %2 m au premier pas de %3 s&#xa0;; fait comme le deuxième, ce pas avance de %4 m.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s after the first step of %3 s; made as the second is, that step gives it %4 m/s.</source>
        <translation>Lancé à %1 m/s, il a %2 m/s après le premier pas de %3 s&#xa0;; fait comme le deuxième, ce pas lui donne %4 m/s.</translation>
    </message>
    <message>
        <source>The first step of %who is made in another way</source>
        <translation>Le premier pas de %who est fait d&apos;une autre façon</translation>
    </message>
    <message>
        <source>Count the lines that change the position in a step without a hit, and look at their factors.</source>
        <translation>Comptez les lignes qui changent la position dans un pas sans choc, et regardez leurs facteurs.</translation>
    </message>
    <message>
        <source>The way of %who in a step is %1 times v Δt</source>
        <translation>Le chemin d&apos;un pas vaut %1 fois v Δt pour %who</translation>
    </message>
    <message>
        <source>Look at the factors in the line that moves it.</source>
        <translation>Regardez les facteurs dans la ligne du déplacement.</translation>
    </message>
    <message>
        <source>The place of %who acts on its velocity otherwise than asked</source>
        <translation>La position agit sur la vitesse autrement que demandé, pour %who</translation>
    </message>
    <message>
        <source>Something slows %who down on the way</source>
        <translation>Quelque chose freine %who en chemin</translation>
    </message>
    <message>
        <source>Something makes %who faster on the way</source>
        <translation>Quelque chose accélère %who en chemin</translation>
    </message>
    <message>
        <source>Nothing slows %who down on the way</source>
        <translation>Rien ne freine %who en chemin</translation>
    </message>
    <message>
        <source>Nothing makes %who faster on the way</source>
        <translation>Rien n&apos;accélère %who en chemin</translation>
    </message>
    <message>
        <source>What should slow %who down makes it faster</source>
        <translation>Ce qui devrait freiner accélère, pour %who</translation>
    </message>
    <message>
        <source>What should make %who faster slows it down</source>
        <translation>Ce qui devrait accélérer freine, pour %who</translation>
    </message>
    <message>
        <source>What acts on the velocity of %who is %1 times as strong as it should be</source>
        <translation>Ce qui agit sur la vitesse vaut %1 fois ce qu&apos;il faudrait, pour %who</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7), the change of v₁ was %5 times that of v₂; m₂/m₁ = %6 is right.</source>
        <translation>Avec r₁ = %1 et r₂ = %2 m, ρ₁ = %3 et ρ₂ = %4 (e = %7), le changement de v₁ valait %5 fois celui de v₂&#xa0;; il faut m₂/m₁ = %6.</translation>
    </message>
    <message>
        <source>Where the masses differ, only circle %1 leaves as it should</source>
        <translation>Quand les masses diffèrent, seul le cercle %1 repart comme il faut</translation>
    </message>
    <message>
        <source>The two masses are not worked out in the same way</source>
        <translation>Les deux masses ne sont pas calculées de la même façon</translation>
    </message>
    <message>
        <source>Two circles of the same radius and density answer as if circle 2 were %1 times as heavy as circle 1, and with another density that both have %2 times. Compare the lines for the two masses.</source>
        <translation>Deux cercles de même rayon et de même masse volumique réagissent comme si le cercle 2 était %1 fois aussi lourd que le cercle 1, et avec une autre masse volumique commune, %2 fois. Comparez les lignes des deux masses.</translation>
    </message>
    <message>
        <source>Here two circles of the same mass meet. </source>
        <translation>Ici, deux cercles de même masse se rencontrent. </translation>
    </message>
    <message>
        <source>Here two circles of the same mass meet, with e = %1. </source>
        <translation>Ici, deux cercles de même masse se rencontrent, avec e = %1. </translation>
    </message>
    <message>
        <source>Both velocities change equally much, whatever the masses are</source>
        <translation>Les deux vitesses changent autant l&apos;une que l&apos;autre, quelles que soient les masses</translation>
    </message>
    <message>
        <source>The heavier of two circles changes its velocity less. Look at where the masses of both enter your answer.</source>
        <translation>Le plus lourd de deux cercles change moins de vitesse. Regardez où les masses des deux entrent dans votre réponse.</translation>
    </message>
    <message>
        <source>The heavier circle is pushed away faster</source>
        <translation>Le cercle le plus lourd est repoussé plus vite</translation>
    </message>
    <message>
        <source>The masses do not only change places. Look at every place where one enters your answer.</source>
        <translation>Les masses ne sont pas seulement échangées. Regardez chaque endroit où l&apos;une d&apos;elles entre dans votre réponse.</translation>
    </message>
    <message>
        <source>The hits do not depend on the radii</source>
        <translation>Les chocs ne dépendent pas des rayons</translation>
    </message>
    <message>
        <source>The mass grows with r to the power of %1, not %2</source>
        <translation>La masse croît comme r à la puissance %1, pas %2</translation>
    </message>
    <message>
        <source>The masses do not follow the radii as those of balls do</source>
        <translation>Les masses ne suivent pas les rayons comme celles de boules</translation>
    </message>
    <message>
        <source>A ball that is twice as wide is also twice as high and as deep: its mass grows with r³.</source>
        <translation>Une boule deux fois plus large est aussi deux fois plus haute et deux fois plus profonde&#xa0;: sa masse croît comme r³.</translation>
    </message>
    <message>
        <source>The hits do not depend on the densities</source>
        <translation>Les chocs ne dépendent pas des masses volumiques</translation>
    </message>
    <message>
        <source>The mass grows with the density to the power of %1, not %2</source>
        <translation>La masse croît comme la masse volumique à la puissance %1, pas %2</translation>
    </message>
    <message>
        <source>The masses do not follow the densities</source>
        <translation>Les masses ne suivent pas les masses volumiques</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %5) they came nearer with u = %6 m/s along the line of centres.</source>
        <translation>Avec r₁ = %1 et r₂ = %2 m, ρ₁ = %3 et ρ₂ = %4 (e = %5), ils se rapprochaient avec u = %6 m/s suivant la ligne des centres.</translation>
    </message>
    <message>
        <source>Circle 1 changed its velocity by %1 m/s and circle 2 by %2, together %3 m/s; (1 + e) u = %4 m/s is right. However heavy they are, the share of circle 1 is m₂/(m₁ + m₂) and that of circle 2 m₁/(m₁ + m₂).</source>
        <translation>Le cercle 1 a changé sa vitesse de %1 m/s et le cercle 2 de %2, ensemble %3 m/s&#xa0;; (1 + e) u = %4 m/s est juste. Quelles que soient leurs masses, la part du cercle 1 est m₂/(m₁ + m₂) et celle du cercle 2 m₁/(m₁ + m₂).</translation>
    </message>
    <message>
        <source>Some hits drive the circles towards each other</source>
        <translation>Certains chocs poussent les cercles l&apos;un vers l&apos;autre</translation>
    </message>
    <message>
        <source>Along it, from 1 to 2, the velocity of circle 1 changed by %1 m/s and that of circle 2 by %2 m/s, so that they come nearer still faster. A hit takes (1 + e) u = %3 m/s of that, and each circle changes by its share: circle 1 by m₂/(m₁ + m₂) and circle 2 by m₁/(m₁ + m₂) of it.</source>
        <translation>Suivant cette ligne, de 1 vers 2, la vitesse du cercle 1 a changé de %1 m/s et celle du cercle 2 de %2 m/s, de sorte qu&apos;ils se rapprochent encore plus vite. Un choc en retire (1 + e) u = %3 m/s, et chaque cercle en change de sa part&#xa0;: le cercle 1 de m₂/(m₁ + m₂) et le cercle 2 de m₁/(m₁ + m₂).</translation>
    </message>
    <message>
        <source>The shares of the two circles do not add up to 1</source>
        <translation>Les parts des deux cercles n&apos;ont pas 1 pour somme</translation>
    </message>
    <message>
        <source>Mass is density times volume, for each circle its own.</source>
        <translation>La masse est le produit de la masse volumique par le volume, pour chaque cercle les siens.</translation>
    </message>
    <message>
        <source>With e = %1: </source>
        <translation>Avec e = %1&#xa0;: </translation>
    </message>
    <message>
        <source>e also shortens the part of circle %1 across the line of centres</source>
        <translation>e réduit aussi la composante du cercle %1 perpendiculaire à la ligne des centres</translation>
    </message>
    <message>
        <source>Nothing pushes there: it stays as it was.</source>
        <translation>Rien ne pousse dans cette direction&#xa0;: elle reste comme elle était.</translation>
    </message>
    <message>
        <source>e multiplies the whole velocities after the hit</source>
        <translation>e multiplie les vitesses entières après le choc</translation>
    </message>
    <message>
        <source>e belongs to the rebound along the line of centres alone; the total momentum stays.</source>
        <translation>e ne concerne que le rebond suivant la ligne des centres&#xa0;; la quantité de mouvement totale se conserve.</translation>
    </message>
    <message>
        <source>e also shortens the parts across the line of centres</source>
        <translation>e réduit aussi les composantes perpendiculaires à la ligne des centres</translation>
    </message>
    <message>
        <source>Nothing pushes there: they stay as they were.</source>
        <translation>Rien ne pousse dans cette direction&#xa0;: elles restent comme elles étaient.</translation>
    </message>
    <message>
        <source>e changes nothing in the hits tried</source>
        <translation>e ne change rien dans les chocs essayés</translation>
    </message>
    <message>
        <source>e is squared in the hit of two circles</source>
        <translation>e est élevé au carré dans le choc de deux cercles</translation>
    </message>
    <message>
        <source>The root of e is used in the hit of two circles</source>
        <translation>La racine de e est utilisée dans le choc de deux cercles</translation>
    </message>
    <message>
        <source>e works the wrong way round: the factor is 2 − e, not 1 + e</source>
        <translation>e agit à l&apos;envers&#xa0;: le facteur est 2 − e, pas 1 + e</translation>
    </message>
    <message>
        <source>The push is multiplied by 2 e instead of 1 + e</source>
        <translation>La poussée est multipliée par 2 e au lieu de 1 + e</translation>
    </message>
    <message>
        <source>The push is multiplied by e instead of 1 + e</source>
        <translation>La poussée est multipliée par e au lieu de 1 + e</translation>
    </message>
    <message>
        <source>The push is multiplied by e (1 + e) instead of 1 + e</source>
        <translation>La poussée est multipliée par e (1 + e) au lieu de 1 + e</translation>
    </message>
    <message>
        <source>The rebound is divided by e</source>
        <translation>Le rebond est divisé par e</translation>
    </message>
    <message>
        <source>The sign of e is wrong in the hit of two circles</source>
        <translation>Le signe de e est faux dans le choc de deux cercles</translation>
    </message>
    <message>
        <source>Of two equal circles only circle %1 leaves as it should</source>
        <translation>De deux cercles égaux, seul le cercle %1 repart comme il faut</translation>
    </message>
    <message>
        <source>e does not act on the rebound as it should</source>
        <translation>e n&apos;agit pas sur le rebond comme il le devrait</translation>
    </message>
    <message>
        <source>A number stands for e in the hit of two circles</source>
        <translation>Un nombre tient lieu de e dans le choc de deux cercles</translation>
    </message>
    <message>
        <source>Numbers stand for e in the hit of two circles</source>
        <translation>Des nombres tiennent lieu de e dans le choc de deux cercles</translation>
    </message>
    <message>
        <source>A hit acts on both circles.</source>
        <translation>Un choc agit sur les deux cercles.</translation>
    </message>
    <message>
        <source>Nobody holds the other circle as a wall is held: look at what each circle gets of the other.</source>
        <translation>Personne ne tient l&apos;autre cercle comme on tient une paroi&#xa0;: regardez ce que chaque cercle reçoit de l&apos;autre.</translation>
    </message>
    <message>
        <source>A hit leaves circle 2 as it was</source>
        <translation>Un choc laisse le cercle 2 comme il était</translation>
    </message>
    <message>
        <source>A hit leaves circle 1 as it was</source>
        <translation>Un choc laisse le cercle 1 comme il était</translation>
    </message>
    <message>
        <source>A hit stops both circles</source>
        <translation>Un choc arrête les deux cercles</translation>
    </message>
    <message>
        <source>That was right in the step that only looked for the contact.</source>
        <translation>C&apos;était juste à l&apos;étape qui ne cherchait que le contact.</translation>
    </message>
    <message>
        <source>A hit stops circle 1 and leaves circle 2 as it was</source>
        <translation>Un choc arrête le cercle 1 et laisse le cercle 2 comme il était</translation>
    </message>
    <message>
        <source>A hit stops circle 2 and leaves circle 1 as it was</source>
        <translation>Un choc arrête le cercle 2 et laisse le cercle 1 comme il était</translation>
    </message>
    <message>
        <source>Each circle is turned back on its own way</source>
        <translation>Chaque cercle est renvoyé sur son propre chemin</translation>
    </message>
    <message>
        <source>Each circle bounces as off a wall</source>
        <translation>Chaque cercle rebondit comme sur une paroi</translation>
    </message>
    <message>
        <source>Circle 1 bounces as off a wall</source>
        <translation>Le cercle 1 rebondit comme sur une paroi</translation>
    </message>
    <message>
        <source>Circle 2 bounces as off a wall</source>
        <translation>Le cercle 2 rebondit comme sur une paroi</translation>
    </message>
    <message>
        <source>Circle 1 bounces as off a wall, and circle 2 stays as it was</source>
        <translation>Le cercle 1 rebondit comme sur une paroi, et le cercle 2 reste comme il était</translation>
    </message>
    <message>
        <source>Circle 2 bounces as off a wall, and circle 1 stays as it was</source>
        <translation>Le cercle 2 rebondit comme sur une paroi, et le cercle 1 reste comme il était</translation>
    </message>
    <message>
        <source>The parts across the line of centres turn round, not those along it</source>
        <translation>Ce sont les composantes perpendiculaires à la ligne des centres qui s&apos;inversent, pas celles suivant cette ligne</translation>
    </message>
    <message>
        <source>The push acts along the line of centres.</source>
        <translation>La poussée agit suivant la ligne des centres.</translation>
    </message>
    <message>
        <source>A smooth circle pushes along the line of centres only; each keeps its own part across.</source>
        <translation>Un cercle lisse ne pousse que suivant la ligne des centres&#xa0;; chacun garde sa propre composante perpendiculaire.</translation>
    </message>
    <message>
        <source>Both new velocities come from those *before* the hit: look at which lines read a velocity that has been written.</source>
        <translation>Les deux nouvelles vitesses se calculent à partir de celles d&apos;*avant* le choc&#xa0;: regardez quelles lignes lisent une vitesse déjà modifiée.</translation>
    </message>
    <message>
        <source>The parts across change hands, and those along the normal stay</source>
        <translation>Les composantes perpendiculaires à la normale s&apos;échangent, et les composantes normales restent</translation>
    </message>
    <message>
        <source>The parts across the normal are lost</source>
        <translation>Les composantes perpendiculaires à la normale sont perdues</translation>
    </message>
    <message>
        <source>Both circles leave with the velocity of circle 2</source>
        <translation>Les deux cercles repartent avec la vitesse du cercle 2</translation>
    </message>
    <message>
        <source>Both circles leave with the velocity of circle 1</source>
        <translation>Les deux cercles repartent avec la vitesse du cercle 1</translation>
    </message>
    <message>
        <source>The velocity of circle 2 is worked out from what circle 1 has become</source>
        <translation>La vitesse du cercle 2 est calculée à partir de ce qu&apos;est devenu le cercle 1</translation>
    </message>
    <message>
        <source>The velocity of circle 1 is worked out from what circle 2 has become</source>
        <translation>La vitesse du cercle 1 est calculée à partir de ce qu&apos;est devenu le cercle 2</translation>
    </message>
    <message>
        <source>After a hit both circles have the same velocity</source>
        <translation>Après un choc, les deux cercles ont la même vitesse</translation>
    </message>
    <message>
        <source>The part of circle 2 along the normal is forgotten</source>
        <translation>La composante normale du cercle 2 est oubliée</translation>
    </message>
    <message>
        <source>Circle 1 gives its part away and gets nothing for it.</source>
        <translation>Le cercle 1 cède sa composante et ne reçoit rien en échange.</translation>
    </message>
    <message>
        <source>The part of circle 1 along the normal is forgotten</source>
        <translation>La composante normale du cercle 1 est oubliée</translation>
    </message>
    <message>
        <source>Circle 2 gives its part away and gets nothing for it.</source>
        <translation>Le cercle 2 cède sa composante et ne reçoit rien en échange.</translation>
    </message>
    <message>
        <source>Circle 1 keeps the part that it hands over</source>
        <translation>Le cercle 1 garde la composante qu&apos;il transmet</translation>
    </message>
    <message>
        <source>What circle 2 gets, circle 1 must lose.</source>
        <translation>Ce que reçoit le cercle 2, le cercle 1 doit le perdre.</translation>
    </message>
    <message>
        <source>The parts along the normal change hands and are turned round as well</source>
        <translation>Les composantes normales s&apos;échangent et sont en plus inversées</translation>
    </message>
    <message>
        <source>The exchange alone is the whole answer.</source>
        <translation>L&apos;échange seul est toute la réponse.</translation>
    </message>
    <message>
        <source>The push on circle 1 has the wrong sign</source>
        <translation>La poussée sur le cercle 1 a le mauvais signe</translation>
    </message>
    <message>
        <source>It gains the part that it should lose.</source>
        <translation>Il gagne la composante qu&apos;il devrait perdre.</translation>
    </message>
    <message>
        <source>The push on circle 2 has the wrong sign</source>
        <translation>La poussée sur le cercle 2 a le mauvais signe</translation>
    </message>
    <message>
        <source>It loses the part that it should gain.</source>
        <translation>Il perd la composante qu&apos;il devrait gagner.</translation>
    </message>
    <message>
        <source>Both pushes have the wrong sign</source>
        <translation>Les deux poussées ont le mauvais signe</translation>
    </message>
    <message>
        <source>The circles are drawn into each other.</source>
        <translation>Les cercles sont attirés l&apos;un dans l&apos;autre.</translation>
    </message>
    <message>
        <source>A direction has length 1: divide it by its own length, else its length comes into the push, and twice.</source>
        <translation>Une direction a la longueur 1&#xa0;: divisez-la par sa propre longueur, sinon cette longueur entre dans la poussée, et deux fois.</translation>
    </message>
    <message>
        <source>The push acts along the line from centre to centre.</source>
        <translation>La poussée agit suivant la ligne qui va de centre à centre.</translation>
    </message>
    <message>
        <source>The normal does not have length 1</source>
        <translation>La normale n&apos;a pas la longueur 1</translation>
    </message>
    <message>
        <source>The perpendicular of the line of centres is taken for the normal</source>
        <translation>La perpendiculaire à la ligne des centres est prise pour la normale</translation>
    </message>
    <message>
        <source>The parts x and y of the normal are exchanged</source>
        <translation>Les composantes x et y de la normale sont échangées</translation>
    </message>
    <message>
        <source>The normal is mirrored: the sign of its y is wrong</source>
        <translation>La normale est reflétée comme dans un miroir&#xa0;: le signe de son y est faux</translation>
    </message>
    <message>
        <source>The push acts along the velocity of circle 1</source>
        <translation>La poussée agit suivant la vitesse du cercle 1</translation>
    </message>
    <message>
        <source>The x parts change hands, not those along the line of centres</source>
        <translation>Ce sont les composantes x qui s&apos;échangent, pas celles suivant la ligne des centres</translation>
    </message>
    <message>
        <source>The y parts change hands, not those along the line of centres</source>
        <translation>Ce sont les composantes y qui s&apos;échangent, pas celles suivant la ligne des centres</translation>
    </message>
    <message>
        <source>The new velocities are turned back by the wrong angle</source>
        <translation>Les nouvelles vitesses sont ramenées avec le mauvais angle</translation>
    </message>
    <message>
        <source>Who turns by −φ before must turn by +φ afterwards.</source>
        <translation>Qui tourne de −φ avant doit tourner de +φ après.</translation>
    </message>
    <message>
        <source>The new velocities are not turned back</source>
        <translation>Les nouvelles vitesses ne sont pas ramenées dans le repère de départ</translation>
    </message>
    <message>
        <source>They are still taken apart along the line of centres: put them together again.</source>
        <translation>Elles sont encore décomposées suivant la ligne des centres&#xa0;: recomposez-les.</translation>
    </message>
    <message>
        <source>The parts across the line of centres are changed</source>
        <translation>Les composantes perpendiculaires à la ligne des centres sont changées</translation>
    </message>
    <message>
        <source>A smooth circle pushes along the line of centres only.</source>
        <translation>Un cercle lisse ne pousse que suivant la ligne des centres.</translation>
    </message>
    <message>
        <source>The two pushes are not equal and opposite</source>
        <translation>Les deux poussées ne sont pas égales et opposées</translation>
    </message>
    <message>
        <source>What one circle of the same mass gains, the other loses: else the total momentum changes.</source>
        <translation>À masse égale, ce que gagne un cercle, l&apos;autre le perd&#xa0;: sinon la quantité de mouvement totale change.</translation>
    </message>
    <message>
        <source>The push is not along the line of centres</source>
        <translation>La poussée n&apos;est pas suivant la ligne des centres</translation>
    </message>
    <message>
        <source>The parts across it must stay as they were.</source>
        <translation>Les composantes perpendiculaires à celle-ci doivent rester comme elles étaient.</translation>
    </message>
    <message>
        <source>The push has the wrong size</source>
        <translation>La poussée n&apos;a pas la bonne grandeur</translation>
    </message>
    <message>
        <source>In meetings with a timestep of %1 s it was between %2 and %3 times as large as it should be.</source>
        <translation>Dans des rencontres avec un pas de temps de %1 s, elle valait entre %2 et %3 fois ce qu&apos;elle devrait.</translation>
    </message>
    <message>
        <source>In your own scene the circles answer as if they had other masses</source>
        <translation>Dans votre propre scène, les cercles réagissent comme s&apos;ils avaient d&apos;autres masses</translation>
    </message>
    <message>
        <source>There circle 2 answers as if it were %1 times as heavy as circle 1; with its radii %2 and %3 m and densities %4 and %5 it is %6 times. In other scenes the masses come out right.</source>
        <translation>Là, le cercle 2 réagit comme s&apos;il était %1 fois aussi lourd que le cercle 1&#xa0;; avec ses rayons %2 et %3 m et ses masses volumiques %4 et %5, c&apos;est %6 fois. Dans d&apos;autres scènes, les masses sont justes.</translation>
    </message>
    <message>
        <source>So it is with radii or densities from before `on_load`: a mass that is worked out before they are set keeps the old value. Look at the order there, and at what is asked before the answer.</source>
        <translation>C&apos;est ce que donnent des rayons ou des masses volumiques d&apos;avant `on_load`&#xa0;: une masse calculée avant qu&apos;ils soient fixés garde l&apos;ancienne valeur. Regardez l&apos;ordre là, et ce qui est demandé avant la réponse.</translation>
    </message>
    <message>
        <source>Look at what the answer takes for the masses there, and at what is asked before it.</source>
        <translation>Regardez ce que la réponse prend là pour les masses, et ce qui est demandé avant.</translation>
    </message>
    <message>
        <source>In your own scene the hit does not use the e that it has</source>
        <translation>Dans votre propre scène, le choc n&apos;utilise pas le e qu&apos;elle a</translation>
    </message>
    <message>
        <source>With e = %1 a hit does not come out right</source>
        <translation>Avec e = %1, un choc ne donne pas le bon résultat</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4, e = %5: </source>
        <translation>Avec r₁ = %1 et r₂ = %2 m, ρ₁ = %3 et ρ₂ = %4, e = %5&#xa0;: </translation>
    </message>
    <message>
        <source>e = %1 is not the value that is asked for</source>
        <translation>e = %1 n&apos;est pas la valeur demandée</translation>
    </message>
    <message>
        <source>Circle %5 came to the %1 with %2 m/s and left it with %3 m/s; %4 m/s is right.</source>
        <translation>Le cercle %5 est arrivé contre %1 à %2 m/s et en est reparti à %3 m/s&#xa0;; il faut %4 m/s.</translation>
    </message>
    <message>
        <source>The normal of the side walls points along x, that of floor and ceiling along y.</source>
        <translation>La normale des parois latérales est dirigée suivant x, celle du sol et du plafond suivant y.</translation>
    </message>
    <message>
        <source>Its velocity still points into the wall: look at the sign.</source>
        <translation>La vitesse pointe toujours vers la paroi&#xa0;: regardez le signe.</translation>
    </message>
    <message>
        <source>Heights go with e², speeds with e.</source>
        <translation>Les hauteurs varient comme e², les vitesses comme e.</translation>
    </message>
    <message>
        <source>1 − e is what is lost; e is what is left.</source>
        <translation>1 − e est ce qui est perdu&#xa0;; e est ce qui reste.</translation>
    </message>
    <message>
        <source>1 + e is the whole change of the velocity, e what comes back.</source>
        <translation>1 + e est tout le changement de la vitesse, e ce qui revient.</translation>
    </message>
    <message>
        <source>In a corner only one part of the velocity of %who turns round</source>
        <translation>Dans un coin, une seule composante de la vitesse s&apos;inverse, pour %who</translation>
    </message>
    <message>
        <source>A hit soon after another is not answered</source>
        <translation>Un choc peu après un autre reste sans réaction</translation>
    </message>
    <message>
        <source>A later hit is not answered</source>
        <translation>Un choc ultérieur reste sans réaction</translation>
    </message>
    <message>
        <source>Look for a factor ½, or for a second half that is missing.</source>
        <translation>Cherchez un facteur ½, ou une seconde moitié qui manque.</translation>
    </message>
    <message>
        <source>In your own scene gravity is %1 m/s²; the velocity changes by %2 m/s in the first step and by %3 m/s in the second. Look at what else changes the velocity, away from any hit.</source>
        <translation>Dans votre propre scène, la pesanteur vaut %1 m/s²&#xa0;; la vitesse change de %2 m/s au premier pas et de %3 m/s au deuxième. Regardez ce qui change encore la vitesse, loin de tout choc.</translation>
    </message>
    <message>
        <source>After a hit the circles still run into each other</source>
        <translation>Après un choc, les cercles continuent de se rapprocher l&apos;un de l&apos;autre</translation>
    </message>
    <message>
        <source>After a hit the circles part faster than they met</source>
        <translation>Après un choc, les cercles se séparent plus vite qu&apos;ils ne se sont rencontrés</translation>
    </message>
    <message>
        <source>Something away from every wall changes the velocity of %who</source>
        <translation>Loin de toute paroi, quelque chose change la vitesse, pour %who</translation>
    </message>
    <message>
        <source>The velocity of %who is taken from circle %1</source>
        <translation>La vitesse vient du cercle %1, pour %who</translation>
    </message>
    <message>
        <source>Away from every wall a low speed of %who is taken away</source>
        <translation>Loin de toute paroi, une faible vitesse est supprimée, pour %who</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later, far from every wall and every other circle; a faster one goes on. Look at the conditions in front of the lines that change the velocity.</source>
        <translation>De %1 m/s au départ, la vitesse passe à %2 m/s un pas plus tard, loin de toute paroi et de tout autre cercle&#xa0;; un cercle plus rapide continue. Regardez les conditions devant les lignes qui changent la vitesse.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: half of that. From the centre to the rim it is the whole radius.</source>
        <translation>Le rayon du cercle %3 est de %1 m, et le demi-tour a lieu quand le centre est à %2 m de la paroi&#xa0;: la moitié. Du centre au bord, c&apos;est le rayon entier.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: twice the radius. From the centre to the rim it is one.</source>
        <translation>Le rayon du cercle %3 est de %1 m, et le demi-tour a lieu quand le centre est à %2 m de la paroi&#xa0;: le double du rayon. Du centre au bord, c&apos;est une fois le rayon.</translation>
    </message>
    <message>
        <source>Circle %3 turns when its centre is one radius, %1 m, past the wall. Of its two ends the near one touches first: look at the sign in front of the radius.</source>
        <translation>Le cercle %3 fait demi-tour quand son centre a dépassé la paroi d&apos;un rayon, %1 m. Des deux extrémités, c&apos;est la plus proche qui touche la première&#xa0;: regardez le signe devant le rayon.</translation>
    </message>
    <message>
        <source>Thrown towards the %1, circle %6 changed its velocity from %2 to %3 m/s in the first step, with its centre still %4 m from that wall; its radius is %5 m. Look at the conditions: which of them is true away from every wall?</source>
        <translation>Lancé vers %1, le cercle %6 a vu sa vitesse passer de %2 à %3 m/s au premier pas, alors que son centre était encore à %4 m de cette paroi&#xa0;; son rayon est de %5 m. Regardez les conditions&#xa0;: laquelle est vraie loin de toute paroi&#xa0;?</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it goes %2 m in the second step of a run and %3 m where it starts alike %4 s later, with the same Δt.</source>
        <translation>Lancé à %1 m/s, il avance de %2 m au deuxième pas d&apos;une exécution, et de %3 m s&apos;il part de la même façon %4 s plus tard, avec le même Δt.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s after the first step of a run and %3 m/s where it starts alike %4 s later.</source>
        <translation>Lancé à %1 m/s, il a %2 m/s après le premier pas d&apos;une exécution, et %3 m/s s&apos;il part de la même façon %4 s plus tard.</translation>
    </message>
    <message>
        <source>The step of %who depends on how long the run has lasted</source>
        <translation>Le pas dépend du temps écoulé depuis le début de l&apos;exécution, pour %who</translation>
    </message>
    <message>
        <source>How long a step lasts is the parameter of `on_update`; `time` is the time since the start, and `step` counts.</source>
        <translation>La durée d&apos;un pas est le paramètre de `on_update`&#xa0;; `time` est le temps depuis le départ, et `step` compte les pas.</translation>
    </message>
    <message>
        <source>Two circles of the same radius and density answer as if circle 2 were %1 times as heavy as circle 1, and with r₁ = %2 and r₂ = %3 m as if it were %4 times. Compare the lines for the two masses.</source>
        <translation>Deux cercles de même rayon et de même masse volumique réagissent comme si le cercle 2 était %1 fois aussi lourd que le cercle 1, et avec r₁ = %2 et r₂ = %3 m comme s&apos;il l&apos;était %4 fois. Comparez les lignes des deux masses.</translation>
    </message>
    <message>
        <source>The hits hardly depend on the radii</source>
        <translation>Les chocs ne dépendent guère des rayons</translation>
    </message>
    <message>
        <source>e acts on more than the rebound</source>
        <translation>e n&apos;agit pas seulement sur le rebond</translation>
    </message>
    <message>
        <source>The circles part e times as fast as they met, as they should; but what both have together, their momentum, changes, too.</source>
        <translation>Les cercles se séparent e fois aussi vite qu&apos;ils se sont rencontrés, comme il se doit&#xa0;; mais ce qu&apos;ils ont ensemble, leur quantité de mouvement, change aussi.</translation>
    </message>
    <message>
        <source>A hit changes the places of the circles, not their velocities</source>
        <translation>Un choc change les places des cercles, pas leurs vitesses</translation>
    </message>
    <message>
        <source>When they touched, circle %1 was put to %2 m, far from where it came from, and both kept their velocities. A hit changes velocities; each circle stays near its own way.</source>
        <translation>Quand ils se sont touchés, le cercle %1 a été mis en %2 m, loin d&apos;où il venait, et tous deux ont gardé leur vitesse. Un choc change les vitesses&#xa0;; chaque cercle reste près de son propre chemin.</translation>
    </message>
    <message>
        <source>Circles that come nearer slowly are not answered</source>
        <translation>Les cercles qui se rapprochent lentement restent sans réaction</translation>
    </message>
    <message>
        <source>With ρ₁ = %1 and ρ₂ = %2, e = %3: </source>
        <translation>Avec ρ₁ = %1 et ρ₂ = %2, e = %3&#xa0;: </translation>
    </message>
    <message>
        <source>What both have in common comes out right. Of the rebound, the part with e, circle 1 gets the share m₁/(m₁ + m₂) and circle 2 the share m₂/(m₁ + m₂): the lighter one should get more.</source>
        <translation>Ce qu&apos;ils ont en commun est juste. Du rebond, la partie avec e, le cercle 1 reçoit la part m₁/(m₁ + m₂) et le cercle 2 la part m₂/(m₁ + m₂)&#xa0;: le plus léger devrait recevoir davantage.</translation>
    </message>
    <message>
        <source>The other one leaves as it should. Look at what is worked out for this one.</source>
        <translation>L&apos;autre repart comme il le doit. Regardez ce qui est calculé pour celui-ci.</translation>
    </message>
    <message>
        <source>Of two equal circles circle 2 leaves a hit as it came</source>
        <translation>De deux cercles égaux, le cercle 2 repart du choc comme il est venu</translation>
    </message>
    <message>
        <source>Of two equal circles circle 1 leaves a hit as it came</source>
        <translation>De deux cercles égaux, le cercle 1 repart du choc comme il est venu</translation>
    </message>
    <message>
        <source>There circle 2 answers as if it were %1 times as heavy as circle 1; as your program does in other scenes, it would be %2 times.</source>
        <translation>Là, le cercle 2 réagit comme s&apos;il était %1 fois aussi lourd que le cercle 1&#xa0;; comme votre programme le fait dans d&apos;autres scènes, ce serait %2 fois.</translation>
    </message>
    <message>
        <source>They met with %1 m/s and parted with %2 m/s, which is e = %3, and `restitution` is %4. In %5 hits tried in other scenes they part with e times the speed.</source>
        <translation>Ils se sont rencontrés à %1 m/s et séparés à %2 m/s, soit e = %3, et `restitution` vaut %4. Dans %5 chocs essayés dans d&apos;autres scènes, ils se séparent avec e fois la vitesse.</translation>
    </message>
    <message>
        <source>A copy of e that is made before e is set keeps the old value.</source>
        <translation>Une copie de e faite avant que e soit fixé garde l&apos;ancienne valeur.</translation>
    </message>
    <message>
        <source>A later hit is answered along the line of an earlier one</source>
        <translation>Un choc ultérieur agit suivant la ligne d&apos;un choc antérieur</translation>
    </message>
    <message>
        <source>Two circles met with their line of centres at %1°, and again, back from a wall, with it at %2°. Both times they were pushed along %3°. Every hit has a normal of its own: work it out anew.</source>
        <translation>Deux cercles se sont rencontrés avec leur ligne des centres à %1° et, au retour d&apos;une paroi, de nouveau avec celle-ci à %2°. Les deux fois ils ont été poussés suivant %3°. Chaque choc a sa propre normale&#xa0;: recalculez-la.</translation>
    </message>
    <message>
        <source>A later hit is answered with another e</source>
        <translation>Un choc ultérieur agit avec un autre e</translation>
    </message>
    <message>
        <source>With e = %1 two circles parted with %2 times the speed that they met with; in their second hit, back from a wall, it was %3 times. Look at what your program keeps from one hit to the next.</source>
        <translation>Avec e = %1, deux cercles se sont séparés avec %2 fois la vitesse de leur rencontre&#xa0;; lors de leur second choc, au retour d&apos;une paroi, c&apos;était %3 fois. Regardez ce que votre programme garde d&apos;un choc au suivant.</translation>
    </message>
    <message>
        <source>Circles that meet slowly are answered in another way</source>
        <translation>Les cercles qui se rencontrent lentement réagissent autrement</translation>
    </message>
    <message>
        <source>Where they meet with %1 m/s, it comes out right. The law is the same for every speed.</source>
        <translation>Quand ils se rencontrent à %1 m/s, le résultat est bon. La loi est la même pour toute vitesse.</translation>
    </message>
    <message>
        <source>twice the smaller radius</source>
        <translation>le double du plus petit rayon</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and went on past it; with %4 m/s it is turned round. How fast it comes does not matter: what counts is whether its rim is past the wall, and which way it moves.</source>
        <translation>Le cercle %1 est arrivé contre %2 à %3 m/s et a continué au-delà&#xa0;; à %4 m/s il fait demi-tour. Peu importe à quelle vitesse il vient&#xa0;: ce qui compte, c&apos;est que son bord ait dépassé la paroi, et dans quel sens il va.</translation>
    </message>
    <message>
        <source>Here the line of centres was at %1°; with %2° the hits come out right.</source>
        <translation>Ici, la ligne des centres était à %1°&#xa0;; à %2°, les chocs donnent le bon résultat.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, one step later it is %2 m from where it was at the start of a run, and %3 m where it starts alike %4 s later. A step *adds* a way to the old position.</source>
        <translation>Parti à %1 m/s, il est un pas plus tard à %2 m de sa place au début d&apos;une exécution, et à %3 m quand il part de même %4 s plus tard. Un pas *ajoute* un chemin à l&apos;ancienne position.</translation>
    </message>
    <message>
        <source> (only in y)</source>
        <translation> (seulement en y)</translation>
    </message>
    <message>
        <source> (only in x)</source>
        <translation> (seulement en x)</translation>
    </message>
    <message>
        <source>Where the masses differ, the total momentum is not kept</source>
        <translation>Quand les masses diffèrent, la quantité de mouvement totale n&apos;est pas conservée</translation>
    </message>
    <message>
        <source>With ρ₁ = %1 and ρ₂ = %2 the change of v₁ was %3 times that of v₂ where e is %4, and %5 times where it is %6; m₂/m₁ = %7 is right, whatever e is. One push changes both: look at what the two formulas have in common.</source>
        <translation>Avec ρ₁ = %1 et ρ₂ = %2, le changement de v₁ valait %3 fois celui de v₂ pour e = %4, et %5 fois pour e = %6&#xa0;; il faut m₂/m₁ = %7, quel que soit e. Une seule poussée change les deux&#xa0;: regardez ce que les deux formules ont en commun.</translation>
    </message>
    <message>
        <source>e acts only after the first hit</source>
        <translation>e n&apos;agit qu&apos;après le premier choc</translation>
    </message>
    <message>
        <source>With e = %1 two circles parted with %2 times the speed that they met with; in their second hit, back from a wall, it was %3 times. Look at when your answer learns what e is: that comes too late.</source>
        <translation>Avec e = %1, deux cercles se sont séparés avec %2 fois la vitesse de leur rencontre&#xa0;; lors de leur second choc, au retour d&apos;une paroi, c&apos;était %3 fois. Regardez quand votre réponse apprend ce que vaut e&#xa0;: cela vient trop tard.</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and turned when its rim was between %4 and %5 m from it; with %6 m/s between %7 and %8 m. That is the way of a second: a step takes it v Δt further, not v.</source>
        <translation>Le cercle %1 est arrivé contre %2 à %3 m/s et a fait demi-tour quand son bord en était distant de %4 à %5 m&#xa0;; à %6 m/s, de %7 à %8 m. C&apos;est le chemin d&apos;une seconde&#xa0;: un pas le fait avancer de v Δt, pas de v.</translation>
    </message>
    <message>
        <source>Beside a wall the velocity of both circles changes at once</source>
        <translation>Près d&apos;une paroi, la vitesse des deux cercles change en même temps</translation>
    </message>
    <message>
        <source>At %1 s of its run they met at %2 m, with %3 m/s, and ran into each other.</source>
        <translation>À %1 s de son exécution, ils se sont rencontrés à %2 m, à %3 m/s, et sont entrés l&apos;un dans l&apos;autre.</translation>
    </message>
    <message>
        <source>At %1 s of its run they met at %2 m, with %3 m/s and e = %4.</source>
        <translation>À %1 s de son exécution, ils se sont rencontrés à %2 m, à %3 m/s et avec e = %4.</translation>
    </message>
    <message>
        <source>At %1 s of its run they met at %2 m, with %3 m/s.</source>
        <translation>À %1 s de son exécution, ils se sont rencontrés à %2 m, à %3 m/s.</translation>
    </message>
    <message>
        <source>At %1 s of its run they met at %2 m, with %3 m/s, and were answered before they touched.</source>
        <translation>À %1 s de son exécution, ils se sont rencontrés à %2 m, à %3 m/s, et ont réagi avant de se toucher.</translation>
    </message>
    <message>
        <source>It was meeting number %1 of that run, %2 s after the one before.</source>
        <translation>C&apos;était la rencontre numéro %1 de cette exécution, %2 s après la précédente.</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2 came to the %3 at %4 m with %5 m/s and left it with %6 m/s; %7 m/s is right.</source>
        <translation>À %1 s de son exécution, le cercle %2 est arrivé contre %3 à %4 m, avec %5 m/s, et en est reparti avec %6 m/s&#xa0;; il faut %7 m/s.</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2 came to the %3 at %4 m with %5 m/s and went on past it.</source>
        <translation>À %1 s de son exécution, le cercle %2 est arrivé contre %3 à %4 m, à %5 m/s, et a continué au-delà.</translation>
    </message>
    <message>
        <source>In a scene in which circle %1 alone has a velocity, %who goes on by that times Δt. Each circle moves with its own velocity: look at the names in the line that moves it.</source>
        <translation>Dans une scène où seul le cercle %1 a une vitesse, voici ce qui avance de cette vitesse fois Δt&#xa0;: %who. Chaque cercle se déplace avec sa propre vitesse&#xa0;: regardez les noms dans la ligne qui le déplace.</translation>
    </message>
    <message>
        <source>Its velocity still points into the wall: look at what it is worked out from.</source>
        <translation>La vitesse pointe toujours vers la paroi&#xa0;: regardez à partir de quoi elle est calculée.</translation>
    </message>
    <message>
        <source>The flight of %who depends on another circle</source>
        <translation>Le vol dépend d&apos;un autre cercle, pour %who</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it goes %2 m in the second step of %3 s; with every other circle at rest and elsewhere %4 m.</source>
        <translation>Parti à %1 m/s, il avance de %2 m au deuxième pas de %3 s&#xa0;; si tous les autres cercles sont ailleurs et au repos, de %4 m.</translation>
    </message>
    <message>
        <source>They are far from each other. Look at what the lines that move one circle take from another, and at what is asked before them.</source>
        <translation>Ils sont loin l&apos;un de l&apos;autre. Regardez ce que les lignes qui déplacent un cercle prennent d&apos;un autre, et ce qui est demandé avant elles.</translation>
    </message>
    <message>
        <source>What gravity adds to the way of %who goes with Δt, not with Δt²</source>
        <translation>Ce que la pesanteur ajoute au chemin varie comme Δt, et non comme Δt², pour %who</translation>
    </message>
    <message>
        <source>A way is a length, as g Δt² is; g Δt is a velocity and g an acceleration.</source>
        <translation>Un chemin est une longueur, comme g Δt²&#xa0;; g Δt est une vitesse et g une accélération.</translation>
    </message>
    <message>
        <source>Every step moves %who by a fixed way besides v Δt</source>
        <translation>Chaque pas ajoute à v Δt un chemin fixe, pour %who</translation>
    </message>
    <message>
        <source>Something besides its own velocity moves %who</source>
        <translation>Outre la vitesse propre, quelque chose déplace %who</translation>
    </message>
    <message>
        <source>What a step adds to the way of %who besides v Δt is no method&apos;s</source>
        <translation>Ce qu&apos;un pas ajoute à v Δt n&apos;est d&apos;aucune méthode, pour %who</translation>
    </message>
    <message>
        <source>Besides v Δt it goes %1 m in a step of %2 s under gravity %3 m/s², and %4 m in one of %5 s. Euler adds nothing to v Δt, symplectic Euler g Δt², the exact methods ½ g Δt².</source>
        <translation>Outre v Δt, il avance de %1 m en un pas de %2 s sous la pesanteur %3 m/s², et de %4 m en un pas de %5 s. Euler n&apos;ajoute rien à v Δt, Euler symplectique g Δt², les méthodes exactes ½ g Δt².</translation>
    </message>
    <message>
        <source>The name `gravity` holds the value of the scene; look where your program has one of its own.</source>
        <translation>Le nom `gravity` contient la valeur de la scène&#xa0;; cherchez où votre programme a la sienne.</translation>
    </message>
    <message>
        <source>Something besides gravity accelerates %who</source>
        <translation>Outre la pesanteur, quelque chose accélère %who</translation>
    </message>
    <message>
        <source>Each time that is %1 m/s² more than gravity gives.</source>
        <translation>C&apos;est à chaque fois %1 m/s² de plus que n&apos;en donne la pesanteur.</translation>
    </message>
    <message>
        <source>The acceleration of %who is not that of gravity</source>
        <translation>L&apos;accélération n&apos;est pas celle de la pesanteur, pour %who</translation>
    </message>
    <message>
        <source>In one of %1 s it changes by %2 m/s, and should by %3 m/s.</source>
        <translation>En un pas de %1 s, elle change de %2 m/s&#xa0;; il faut %3 m/s.</translation>
    </message>
    <message>
        <source>How gravity acts on %who depends on the timestep</source>
        <translation>L&apos;effet de la pesanteur sur %who dépend du pas de temps</translation>
    </message>
    <message>
        <source>In every step gravity must change its velocity: look for the line that does it, and at what is asked before it.</source>
        <translation>À chaque pas, la pesanteur doit changer la vitesse&#xa0;: cherchez la ligne qui le fait, et ce qui est demandé avant elle.</translation>
    </message>
    <message>
        <source>The velocity of %who changes far from everything</source>
        <translation>Loin de tout, la vitesse change pour %who</translation>
    </message>
    <message>
        <source>Thrown with %1 m/s, it has %2 m/s one step of %3 s later, far from every wall and every other circle; gravity gives it %4 m/s in a step. Look at which lines change its velocity there, and at what is asked before them.</source>
        <translation>Lancé à %1 m/s, il a %2 m/s un pas de %3 s plus tard, loin de toute paroi et de tout autre cercle&#xa0;; la pesanteur lui donne %4 m/s par pas. Regardez quelles lignes y changent sa vitesse, et ce qui est demandé avant elles.</translation>
    </message>
    <message>
        <source>A slower one goes on as it should.</source>
        <translation>Un cercle plus lent continue comme il faut.</translation>
    </message>
    <message>
        <source>A faster one goes on as it should.</source>
        <translation>Un cercle plus rapide continue comme il faut.</translation>
    </message>
    <message>
        <source>Look at what the lines that change the velocity take, and at what is asked before them.</source>
        <translation>Regardez ce que prennent les lignes qui changent la vitesse, et ce qui est demandé avant elles.</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² and with the velocity %2 m/s it changes by %3 m/s in a step of %4 s, with %5 m/s by %6 m/s; %7 and %8 m/s are right. Look at what the lines that change the velocity take, and at what is asked before them.</source>
        <translation>Sous la pesanteur %1 m/s² et avec la vitesse %2 m/s, elle change de %3 m/s en un pas de %4 s, avec %5 m/s de %6 m/s&#xa0;; il faut %7 et %8 m/s. Regardez ce que prennent les lignes qui changent la vitesse, et ce qui est demandé avant elles.</translation>
    </message>
    <message>
        <source>The acceleration of %who depends on the place</source>
        <translation>L&apos;accélération dépend de la position, pour %who</translation>
    </message>
    <message>
        <source>At rest under gravity %1 m/s² it is accelerated by %2 m/s² at %3 m and by %4 m/s² at %5 m; %6 and %7 m/s² are right.</source>
        <translation>Au repos sous la pesanteur %1 m/s², l&apos;accélération est de %2 m/s² à %3 m et de %4 m/s² à %5 m&#xa0;; il faut %6 et %7 m/s².</translation>
    </message>
    <message>
        <source>The velocity of %who changes by itself otherwise than asked</source>
        <translation>La vitesse agit sur elle-même autrement que demandé, pour %who</translation>
    </message>
    <message>
        <source>It had %1 m/s, and %2 m/s one step of %3 s later, with nothing near that it could hit. Look at the lines that turn it, and at what is asked before them: is it true although nothing touches?</source>
        <translation>Il avait %1 m/s, et %2 m/s un pas de %3 s plus tard&#xa0;; rien à heurter n&apos;était proche. Regardez les lignes qui le retournent, et ce qui est demandé avant elles&#xa0;: est-ce vrai bien que rien ne se touche&#xa0;?</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is accelerated by %2 m/s² for every m/s of its velocity; %3 is right.</source>
        <translation>Avec Δt = %1 s, l&apos;accélération est de %2 m/s² pour chaque m/s de vitesse&#xa0;; il faut %3.</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is accelerated in x by %2 m/s² for every m/s of its velocity in x; %3 is right.</source>
        <translation>Avec Δt = %1 s, l&apos;accélération en x est de %2 m/s² pour chaque m/s de vitesse en x&#xa0;; il faut %3.</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is accelerated in y by %2 m/s² for every m/s of its velocity in y; %3 is right.</source>
        <translation>Avec Δt = %1 s, l&apos;accélération en y est de %2 m/s² pour chaque m/s de vitesse en y&#xa0;; il faut %3.</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is accelerated by %2 m/s² for every m/s of its velocity in x, and by %3 m/s² for every m/s in y; %4 and %5 are right.</source>
        <translation>Avec Δt = %1 s, l&apos;accélération est de %2 m/s² pour chaque m/s de vitesse en x, et de %3 m/s² pour chaque m/s en y&#xa0;; il faut %4 et %5.</translation>
    </message>
    <message>
        <source>With Δt = %1 s it is %2 m/s².</source>
        <translation>Avec Δt = %1 s, c&apos;est %2 m/s².</translation>
    </message>
    <message>
        <source>It starts with %1 m/s, and has %2 m/s one step later; nothing that it could hit is near. Look at which lines change its velocity there, and at what is asked before them.</source>
        <translation>Au départ elle vaut %1 m/s, et un pas plus tard %2 m/s&#xa0;; rien à heurter n&apos;est proche. Regardez quelles lignes y changent la vitesse, et ce qui est demandé avant elles.</translation>
    </message>
    <message>
        <source>It is the value that the scene has.</source>
        <translation>C&apos;est la valeur que la scène a.</translation>
    </message>
    <message>
        <source>Look at what your program assigns to %1 before the first step.</source>
        <translation>Regardez ce que votre programme affecte à %1 avant le premier pas.</translation>
    </message>
    <message>
        <source>Behind `local`, %1 is the name of another variable: the scene keeps its own value.</source>
        <translation>Après `local`, %1 est le nom d&apos;une autre variable&#xa0;: la scène garde sa propre valeur.</translation>
    </message>
    <message>
        <source>Nothing in your program assigns to %1 before the first step: it is the value that the scene has.</source>
        <translation>Rien dans votre programme n&apos;affecte %1 avant le premier pas&#xa0;: c&apos;est la valeur que la scène a.</translation>
    </message>
    <message>
        <source>Gravity is %1 m/s², not %2

So it is when the run begins.</source>
        <translation>La pesanteur vaut %1 m/s², pas %2

C&apos;est ainsi au début de l&apos;exécution.</translation>
    </message>
    <message>
        <source>So it is when the run begins; in this step your own scene should have e = %1.</source>
        <translation>C&apos;est ainsi quand l&apos;exécution commence&#xa0;; à cette étape, votre propre scène doit avoir e = %1.</translation>
    </message>
    <message>
        <source>What gravity adds to the way of %who does not depend on Δt</source>
        <translation>Ce que la pesanteur ajoute au chemin ne dépend pas de Δt, pour %who</translation>
    </message>
    <message>
        <source>In a step of %1 s it keeps as much of it, %2 times: so what happens in a second depends on Δt.</source>
        <translation>En un pas de %1 s, il en garde autant, %2 fois&#xa0;: ce qui se passe en une seconde dépend donc de Δt.</translation>
    </message>
    <message>
        <source>Every step moves %who on from where circle %1 is</source>
        <translation>Chaque pas part de la position du cercle %1, pour %who</translation>
    </message>
    <message>
        <source>Started with %1 m/s, its velocity changes by %2 m/s in the second step of %3 s; with every other circle at rest and elsewhere by %4 m/s.</source>
        <translation>Parti à %1 m/s, il change sa vitesse de %2 m/s au deuxième pas de %3 s&#xa0;; si tous les autres cercles sont ailleurs et au repos, de %4 m/s.</translation>
    </message>
    <message>
        <source>The acceleration of %who is opposite to gravity</source>
        <translation>L&apos;accélération est opposée à la pesanteur, pour %who</translation>
    </message>
    <message>
        <source>Nothing changes the velocity of circle %1

In your own scene it has %2 m/s from the start to the end of %3 s, though it comes to a wall and to another circle. Both must give it a new velocity: look for where that is assigned.</source>
        <translation>Rien ne change la vitesse du cercle %1

Dans votre propre scène il a %2 m/s du départ à la fin de %3 s, bien qu&apos;il arrive à une paroi et à un autre cercle. Les deux doivent lui donner une nouvelle vitesse&#xa0;: cherchez où elle est affectée.</translation>
    </message>
    <message>
        <source>Circle %1 does not move as its velocity says

At %2 s of your own scene it moves by %3 m in a step of %4 s; its velocity is still the %5 m/s of the start. A program that keeps velocities in variables of its own must also assign them to the circles, as to `circle%1.velocity`.

Until this is right, no more can be said of walls and hits.</source>
        <translation>Le cercle %1 ne bouge pas comme le dit sa vitesse

À %2 s de votre propre scène, il se déplace de %3 m en un pas de %4 s ; sa vitesse est encore celle du départ, %5 m/s. Un programme qui garde des vitesses dans ses propres variables doit aussi les donner aux cercles, par exemple à `circle%1.velocity`.

De ce fait, les murs et les chocs ne peuvent pas encore être jugés.</translation>
    </message>
    <message>
        <source>Circle %1 does not move as its velocity says

At %2 s of your own scene it moves by %3 m in a step of %4 s; its velocity is %5 m/s, of which the %6 is still that of the start. A program that keeps velocities in variables of its own must assign both parts of them to the circles, as to `circle%1.velocity`.

Until this is right, no more can be said of walls and hits.</source>
        <translation>Le cercle %1 ne bouge pas comme le dit sa vitesse

À %2 s de votre propre scène, il se déplace de %3 m en un pas de %4 s ; sa vitesse est %5 m/s, dont le %6 est encore celui du départ. Un programme qui garde des vitesses dans ses propres variables doit en donner les deux composantes aux cercles, par exemple à `circle%1.velocity`.

De ce fait, les murs et les chocs ne peuvent pas encore être jugés.</translation>
    </message>
    <message>
        <source>Look at what the line that changes the position takes, and at what is asked before it.</source>
        <translation>Regardez ce que prend la ligne qui change la position, et ce qui est demandé avant elle.</translation>
    </message>
    <message>
        <source>The method that moves %who depends on the velocity</source>
        <translation>La méthode qui déplace %who dépend de la vitesse</translation>
    </message>
    <message>
        <source>Where nothing rubs, a push points along the normal only.</source>
        <translation>Là où rien ne frotte, une poussée n&apos;agit que le long de la normale.</translation>
    </message>
    <message>
        <source>Hits at the %walls hold %who and turn no velocity round</source>
        <translation>Les chocs contre %walls retiennent %who et n&apos;inversent aucune vitesse</translation>
    </message>
    <message>
        <source>At the %walls the way of %who turns round, not its velocity</source>
        <translation>Près de %walls, le chemin de %who fait demi-tour, pas sa vitesse</translation>
    </message>
    <message>
        <source>Hits at the %walls turn the velocity of %who round too late</source>
        <translation>Les chocs contre %walls inversent trop tard la vitesse, pour %who</translation>
    </message>
    <message>
        <source>It is put back at once, and its velocity points away from the wall only %1 s later.</source>
        <translation>Le cercle est remis en place aussitôt, et sa vitesse ne s&apos;éloigne de la paroi que %1 s plus tard.</translation>
    </message>
    <message>
        <source>In every step it is kept from going on, and its velocity still points into it.</source>
        <translation>À chaque pas, le cercle est empêché d&apos;avancer, et sa vitesse pointe toujours dans la paroi.</translation>
    </message>
    <message>
        <source>It is kept from going on, and its velocity stays as it was.</source>
        <translation>Le cercle est empêché d&apos;avancer, et sa vitesse reste ce qu&apos;elle était.</translation>
    </message>
    <message>
        <source>It goes back from the wall while its velocity still points into it: look at what is assigned to that.</source>
        <translation>Il s&apos;éloigne de la paroi alors que sa vitesse pointe encore vers elle&#xa0;: regardez ce qui lui est affecté.</translation>
    </message>
    <message>
        <source>At the %walls %who gets the velocity of the other circle</source>
        <translation>Contre %walls, la vitesse de l&apos;autre cercle est donnée à celui-ci&#xa0;: %who</translation>
    </message>
    <message>
        <source>The other circle had %1 m/s. Look at whose velocity the line takes.</source>
        <translation>L&apos;autre cercle avait %1 m/s. Regardez de quel cercle la ligne prend la vitesse.</translation>
    </message>
    <message>
        <source>Hits at the %walls turn the wrong part of the velocity of %who</source>
        <translation>Les chocs contre %walls inversent la mauvaise composante de la vitesse, pour %who</translation>
    </message>
    <message>
        <source>Hits at the %walls turn the whole velocity of %who round</source>
        <translation>Les chocs contre %walls inversent toute la vitesse, pour %who</translation>
    </message>
    <message>
        <source>At the %walls e also shortens the part of %who along the wall</source>
        <translation>Contre %walls, e réduit aussi la composante le long de la paroi, pour %who</translation>
    </message>
    <message>
        <source>At the %walls e acts on the wrong part of the velocity of %who</source>
        <translation>Contre %walls, e agit sur la mauvaise composante de la vitesse, pour %who</translation>
    </message>
    <message>
        <source>Hits at the %walls turn the part of %who along the wall round, too</source>
        <translation>Les chocs contre %walls inversent aussi la composante le long de la paroi, pour %who</translation>
    </message>
    <message>
        <source>Hits at the %walls take the part of %who along the wall away</source>
        <translation>Les chocs contre %walls suppriment la composante le long de la paroi, pour %who</translation>
    </message>
    <message>
        <source>Hits at the %walls change the part of %who along the wall</source>
        <translation>Les chocs contre %walls changent la composante le long de la paroi, pour %who</translation>
    </message>
    <message>
        <source>At the %walls a number stands for e, for %who</source>
        <translation>Contre %walls, un nombre tient lieu de e, pour %who</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who %1 e of the speed back, not e</source>
        <translation>Les chocs contre %walls rendent %1 e fois la vitesse, pas e fois, pour %who</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who a speed of their own</source>
        <translation>Les chocs contre %walls imposent une vitesse fixe, pour %who</translation>
    </message>
    <message>
        <source>With e = %1 a hit with %2 m/s into the wall gives %3 times the speed back, one with %4 m/s %5 times: the share should be the same for every speed.</source>
        <translation>Avec e = %1, un choc à %2 m/s vers le mur rend %3 fois la vitesse, un autre à %4 m/s, %5 fois&#xa0;: cette part doit être la même pour toute vitesse.</translation>
    </message>
    <message>
        <source>With e = %1 it is %2 times the speed, with e = %3 %4 times.</source>
        <translation>Avec e = %1, c&apos;est %2 fois la vitesse, avec e = %3, %4 fois.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who between %1 and %2 times the speed back</source>
        <translation>Les chocs contre %walls rendent entre %1 et %2 fois la vitesse, pour %who</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who %1 times the speed back</source>
        <translation>Les chocs contre %walls rendent %1 fois la vitesse, pour %who</translation>
    </message>
    <message>
        <source>Look at what the new velocity is worked out from.</source>
        <translation>Regardez à partir de quoi la nouvelle vitesse est calculée.</translation>
    </message>
    <message>
        <source>The least came at the %1 with %2 m/s into it, the most at the %3 with %4 m/s.</source>
        <translation>Le moins est revenu contre %1 avec %2 m/s vers elle, le plus contre %3 avec %4 m/s.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who all of the speed back</source>
        <translation>Les chocs contre %walls rendent toute la vitesse, pour %who</translation>
    </message>
    <message>
        <source>At the %walls e acts on %who twice</source>
        <translation>Contre %walls, e agit deux fois sur %who</translation>
    </message>
    <message>
        <source>At the %walls the root of e acts on %who</source>
        <translation>Contre %walls, c&apos;est la racine de e qui agit sur %who</translation>
    </message>
    <message>
        <source>Of the part along the normal nothing comes back.</source>
        <translation>De la composante le long de la normale, rien ne revient.</translation>
    </message>
    <message>
        <source>At the %walls 1 − e stands where e belongs, for %who</source>
        <translation>Contre %walls, 1 − e est là où il faut e, pour %who</translation>
    </message>
    <message>
        <source>At the %walls 1 + e stands where e belongs, for %who</source>
        <translation>Contre %walls, 1 + e est là où il faut e, pour %who</translation>
    </message>
    <message>
        <source>Hits at the %walls slow %who and turn nothing round</source>
        <translation>Les chocs contre %walls freinent %who et n&apos;inversent rien</translation>
    </message>
    <message>
        <source>Here e is %1. </source>
        <translation>Ici, e vaut %1. </translation>
    </message>
    <message>
        <source>walls</source>
        <comment>behind: at the</comment>
        <translation>les parois</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <comment>walls</comment>
        <extracomment>&quot;left wall, floor&quot; and &quot;ceiling&quot;</extracomment>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2 came to the %3 at %4 m with %5 m/s and went on past it at first.</source>
        <translation>Après %1 s de son exécution, le cercle %2 est arrivé contre %3 à %4 m, à %5 m/s, et a d&apos;abord continué au-delà.</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s, circle %3 went on past it. Look at what your program asks for it, and whether the answer is ever yes.</source>
        <translation>Lancé vers %1 à %2 m/s, le cercle %3 a continué au-delà. Regardez ce que votre programme demande pour elle, et si la réponse est parfois oui.</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round too early</source>
        <translation>Les chocs contre %walls renvoient %who trop tôt</translation>
    </message>
    <message>
        <source>At the %walls the centre of %who is asked for, not the rim</source>
        <translation>Contre %walls, c&apos;est le centre qui est comparé, pas le bord, pour %who</translation>
    </message>
    <message>
        <source>At the %walls the radius of another circle stands for that of %who</source>
        <translation>Contre %walls, le rayon d&apos;un autre cercle tient lieu du bon, pour %who</translation>
    </message>
    <message>
        <source>At the %walls the larger radius stands for that of %who</source>
        <translation>Contre %walls, le plus grand rayon tient lieu du bon, pour %who</translation>
    </message>
    <message>
        <source>At the %walls the smaller radius stands for that of %who</source>
        <translation>Contre %walls, le plus petit rayon tient lieu du bon, pour %who</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round too late</source>
        <translation>Les chocs contre %walls renvoient %who trop tard</translation>
    </message>
    <message>
        <source>At the %walls a number stands for the radius of %who</source>
        <translation>Contre %walls, un nombre tient lieu de rayon, pour %who</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round at the far side of the rim</source>
        <translation>Les chocs contre %walls renvoient %who au bord opposé</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round a whole second too early</source>
        <translation>Les chocs contre %walls renvoient %who une seconde entière trop tôt</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round at the wrong place</source>
        <translation>Les chocs contre %walls renvoient %who au mauvais endroit</translation>
    </message>
    <message>
        <source>Slow hits at the %walls give %who another share of the speed back</source>
        <translation>Les chocs lents contre %walls rendent une autre part de la vitesse, pour %who</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and left it with %4 times that speed; %5 times is right, however slow it is.</source>
        <translation>Le cercle %1 est arrivé contre %2 à %3 m/s et l&apos;a quittée avec %4 fois cette vitesse&#xa0;; %5 fois est juste, si lent qu&apos;il soit.</translation>
    </message>
    <message>
        <source>Hits at the %walls put %who somewhere else</source>
        <translation>Les chocs contre %walls placent %who ailleurs</translation>
    </message>
    <message>
        <source>At the %1 circle %4 was put %2 m away from its own path, at %3 m.</source>
        <translation>Contre %1, le cercle %4 a été mis à %2 m de sa propre trajectoire, en %3 m.</translation>
    </message>
    <message>
        <source>There the other circle was: each circle goes back to its *own* place.</source>
        <translation>L&apos;autre cercle était là&#xa0;: chaque cercle retourne à sa *propre* position.</translation>
    </message>
    <message>
        <source>It belongs where its rim is at the wall, or back where it was before that step.</source>
        <translation>Sa place est là où son bord touche la paroi, ou là où il était avant ce pas.</translation>
    </message>
    <message>
        <source>Hits at the %walls put %who further out</source>
        <translation>Les chocs contre %walls placent %who plus à l&apos;extérieur</translation>
    </message>
    <message>
        <source>At the %1 the centre of circle %5 would have come to %2 m from the wall and was put %3 m from it; its radius is %4 m. Put it where its rim is at the wall, or back where it came from.</source>
        <translation>Contre %1, le centre du cercle %5 serait arrivé à %2 m de la paroi et a été placé à %3 m d&apos;elle&#xa0;; son rayon est de %4 m. Placez-le là où son bord touche la paroi, ou là d&apos;où il venait.</translation>
    </message>
    <message>
        <source>When circle %1 was %2 m from the %3 its velocity changed, and in the same step that of the other, far from it and from every wall. A wall turns the circle that touches it, and no other.</source>
        <translation>Quand le cercle %1 était à %2 m de ceci&#xa0;: %3, sa vitesse a changé, et dans le même pas celle de l&apos;autre, loin de lui et de toute paroi. Une paroi renvoie le cercle qui la touche, et aucun autre.</translation>
    </message>
    <message>
        <source>Hits at the %walls leave %who outside</source>
        <translation>Les chocs contre %walls laissent %who dehors</translation>
    </message>
    <message>
        <source>After the hit the rim of circle %1 is %2 m past the %3, and its velocity takes it back by %4 m a step: slower than it came, it is still outside after the next one. Put it where its rim is at the wall, or back where it came from.</source>
        <translation>Après le choc, le bord du cercle %1 est à %2 m au-delà de ceci&#xa0;: %3, et sa vitesse le ramène de %4 m par pas&#xa0;: plus lent qu&apos;à l&apos;arrivée, il est encore dehors après le suivant. Placez-le là où son bord touche la paroi, ou là d&apos;où il venait.</translation>
    </message>
    <message>
        <source>Hits at the %walls put %who too far in</source>
        <translation>Les chocs contre %walls placent %who trop à l&apos;intérieur</translation>
    </message>
    <message>
        <source>At the %1 the centre of circle %5 was %2 m from the wall before that step and was put %3 m from it; its radius is %4 m, so that there is a gap. Put it where its rim is at the wall, or back where it came from.</source>
        <translation>Contre %1, le centre du cercle %5 était à %2 m de la paroi avant ce pas et a été placé à %3 m d&apos;elle&#xa0;; son rayon est de %4 m, il y a donc un vide. Placez-le là où son bord touche la paroi, ou là d&apos;où il venait.</translation>
    </message>
    <message>
        <source>In the step in which circle %1 was answered by the %2, the other circle, far from every wall, did not go on freely: its place is %3 m and its velocity %4 m/s off. A wall acts on the circle that touches it, and on no other.</source>
        <translation>Dans le pas où le cercle %1 a réagi contre %2, l&apos;autre cercle, loin de toute paroi, n&apos;a pas continué librement&#xa0;: sa position est décalée de %3 m et sa vitesse de %4 m/s. Une paroi agit sur le cercle qui la touche, et sur aucun autre.</translation>
    </message>
    <message>
        <source>Circle %3 came with %1 m/s and left with %2 m/s. Both walls are hit in the same step, and each must turn its own part, whichever comes first.</source>
        <translation>Le cercle %3 est arrivé à %1 m/s et est reparti à %2 m/s. Les deux parois sont touchées dans le même pas, et chacune doit inverser sa composante, quelle que soit la première.</translation>
    </message>
    <message>
        <source>circle 1 came with %1 m/s, circle 2 with %2 m/s</source>
        <translation>le cercle 1 arrivait à %1 m/s, le cercle 2 à %2 m/s</translation>
    </message>
    <message>
        <source>near %1 m</source>
        <translation>près de %1 m</translation>
    </message>
    <message>
        <source>They touched, their places were changed and their velocities kept, until they moved apart.</source>
        <translation>Ils se sont touchés, leurs positions ont été changées et leurs vitesses gardées, jusqu&apos;à ce qu&apos;ils s&apos;éloignent l&apos;un de l&apos;autre.</translation>
    </message>
    <message>
        <source>They ran into each other until their centres were %1 m apart, and were answered when that grew again.</source>
        <translation>Ils sont entrés l&apos;un dans l&apos;autre jusqu&apos;à ce que leurs centres soient à %1 m, et la réponse est venue quand cette distance a recommencé à croître.</translation>
    </message>
    <message>
        <source>Circles that come nearer have a positive closing speed (v₁ − v₂)·n, with n from 1 to 2: look at the comparison, and at which way your normal points.</source>
        <translation>Des cercles qui se rapprochent ont une vitesse de rapprochement (v₁ − v₂)·n positive, avec n de 1 vers 2&#xa0;: regardez la comparaison, et dans quel sens pointe votre normale.</translation>
    </message>
    <message>
        <source>circle 2 is to the right of circle 1</source>
        <translation>le cercle 2 est à droite du cercle 1</translation>
    </message>
    <message>
        <source>circle 2 is to the left of circle 1</source>
        <translation>le cercle 2 est à gauche du cercle 1</translation>
    </message>
    <message>
        <source>circle 2 is above circle 1</source>
        <translation>le cercle 2 est au-dessus du cercle 1</translation>
    </message>
    <message>
        <source>circle 2 is below circle 1</source>
        <translation>le cercle 2 est au-dessous du cercle 1</translation>
    </message>
    <message>
        <source>circle %1 is at rest</source>
        <translation>le cercle %1 est au repos</translation>
    </message>
    <message>
        <source>circle %1 comes towards circle %2</source>
        <translation>le cercle %1 vient vers le cercle %2</translation>
    </message>
    <message>
        <source>circle %1 moves away from circle %2</source>
        <translation>le cercle %1 s&apos;éloigne du cercle %2</translation>
    </message>
    <message>
        <source>circle %1 is the faster one along the line of centres</source>
        <translation>le cercle %1 est le plus rapide le long de la ligne des centres</translation>
    </message>
    <message>
        <source>circle %1 is the faster one</source>
        <translation>le cercle %1 est le plus rapide</translation>
    </message>
    <message>
        <source>both move the same way along the line of centres</source>
        <translation>les deux vont dans le même sens le long de la ligne des centres</translation>
    </message>
    <message>
        <source>both come towards each other</source>
        <translation>les deux viennent l&apos;un vers l&apos;autre</translation>
    </message>
    <message>
        <source>one of them is at rest</source>
        <translation>l&apos;un des deux est au repos</translation>
    </message>
    <message>
        <source>both are equally fast along the line of centres</source>
        <translation>les deux sont également rapides le long de la ligne des centres</translation>
    </message>
    <message>
        <source>both are equally fast</source>
        <translation>les deux sont également rapides</translation>
    </message>
    <message>
        <source>circle %1 moves to the right</source>
        <translation>le cercle %1 va vers la droite</translation>
    </message>
    <message>
        <source>circle %1 moves to the left</source>
        <translation>le cercle %1 va vers la gauche</translation>
    </message>
    <message>
        <source>circle %1 moves upward</source>
        <translation>le cercle %1 monte</translation>
    </message>
    <message>
        <source>circle %1 moves downward</source>
        <translation>le cercle %1 descend</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves to the right</source>
        <translation>le cercle 1, vu du cercle 2, va vers la droite</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves to the left</source>
        <translation>le cercle 1, vu du cercle 2, va vers la gauche</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves upward</source>
        <translation>le cercle 1, vu du cercle 2, monte</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves downward</source>
        <translation>le cercle 1, vu du cercle 2, descend</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves away from (0, 0)</source>
        <translation>le cercle 1, vu du cercle 2, s&apos;éloigne de (0, 0)</translation>
    </message>
    <message>
        <source>circle 1, seen from circle 2, moves towards (0, 0)</source>
        <translation>le cercle 1, vu du cercle 2, va vers (0, 0)</translation>
    </message>
    <message>
        <source>circle %1 is the larger one</source>
        <translation>le cercle %1 est le plus grand</translation>
    </message>
    <message>
        <source>circle %1 is the heavier one</source>
        <translation>le cercle %1 est le plus lourd</translation>
    </message>
    <message>
        <source>circle %1 is the denser one</source>
        <translation>le cercle %1 est le plus dense</translation>
    </message>
    <message>
        <source>both are equally large</source>
        <translation>les deux sont de même taille</translation>
    </message>
    <message>
        <source>both are equally heavy</source>
        <translation>les deux ont la même masse</translation>
    </message>
    <message>
        <source>both are equally dense</source>
        <translation>les deux ont la même masse volumique</translation>
    </message>
    <message>
        <source>Circle 2 was hit, was back from the wall close behind it within a few steps and ran into circle 1 without an answer; from a wall farther off it gets one. What counts is whether they overlap and come nearer, not when the last hit was, nor whether a wall is near.</source>
        <translation>Le cercle 2 a été heurté, est revenu en quelques pas de la paroi toute proche derrière lui et est entré dans le cercle 1 sans réponse&#xa0;; depuis une paroi plus éloignée il en a une. Ce qui compte, c&apos;est s&apos;ils se chevauchent et se rapprochent, non quand le dernier choc a eu lieu ni si une paroi est proche.</translation>
    </message>
    <message>
        <source>Circle 2 was hit, came back from the wall behind it and ran through circle 1. What counts is whether they overlap and come nearer: look at what else is asked, and at what your program keeps of a hit.</source>
        <translation>Le cercle 2 a été heurté, est revenu de la paroi derrière lui et a traversé le cercle 1. Ce qui compte, c&apos;est s&apos;ils se chevauchent et se rapprochent&#xa0;: regardez ce qui est demandé en plus, et ce que votre programme garde d&apos;un choc.</translation>
    </message>
    <message>
        <source>In all these hits the new part of circle %1 along that line was %2 times that of circle 1 before the hit and %3 times that of circle 2; right is %4 and %5 times.</source>
        <translation>Dans tous ces chocs, la nouvelle composante du cercle %1 le long de cette ligne valait %2 fois celle du cercle 1 avant le choc et %3 fois celle du cercle 2&#xa0;; il faut %4 et %5 fois.</translation>
    </message>
    <message>
        <source>The push has a wrong size that depends on the radius</source>
        <translation>La poussée a une valeur fausse qui dépend du rayon</translation>
    </message>
    <message>
        <source>With r = %1 m for both the push is %2 times as large as it should be, with r = %3 m it is %4 times.</source>
        <translation>Avec r = %1 m pour les deux, la poussée vaut %2 fois ce qu&apos;elle devrait, avec r = %3 m %4 fois.</translation>
    </message>
    <message>
        <source>The push has a wrong size that depends on the circles</source>
        <translation>La poussée a une valeur fausse qui dépend des cercles</translation>
    </message>
    <message>
        <source>With r = %1 m and ρ = %2 for both the push is %3 times as large as it should be, with r = %4 m and ρ = %5 it is %6 times.</source>
        <translation>Avec r = %1 m et ρ = %2 pour les deux, la poussée vaut %3 fois ce qu&apos;elle devrait, avec r = %4 m et ρ = %5 %6 fois.</translation>
    </message>
    <message>
        <source>The push has a wrong size that depends on the timestep</source>
        <translation>La poussée a une valeur fausse qui dépend du pas de temps</translation>
    </message>
    <message>
        <source>With a timestep of %1 s the push is %2 times as large as it should be, and with %3 s about %4 times.</source>
        <translation>Avec un pas de temps de %1 s, la poussée vaut %2 fois ce qu&apos;elle devrait, et avec %3 s environ %4 fois.</translation>
    </message>
    <message>
        <source>Only circle %1 leaves a hit as it should</source>
        <translation>Seul le cercle %1 repart d&apos;un choc comme il faut</translation>
    </message>
    <message>
        <source>Hits at the %walls take the part of %who along the normal away</source>
        <translation>Les chocs contre %walls suppriment la composante le long de la normale, pour %who</translation>
    </message>
    <message>
        <source>Some meetings are answered before they touch</source>
        <translation>Certaines rencontres reçoivent une réponse avant le contact</translation>
    </message>
    <message>
        <source>Some meetings are answered too late</source>
        <translation>Certaines rencontres reçoivent une réponse trop tard</translation>
    </message>
    <message>
        <source>Circle %1 does not keep its part across in a hit</source>
        <translation>Le cercle %1 ne garde pas sa composante perpendiculaire</translation>
    </message>
    <message>
        <source>From every start tried the two are at the same place one step later. Each circle has a place and a velocity of its own and goes on from those: look at what the lines for one take from the other.</source>
        <translation>Depuis chaque départ essayé, les deux sont au même endroit un pas plus tard. Chaque cercle a sa propre position et sa propre vitesse et continue à partir d&apos;elles&#xa0;: regardez ce que les lignes de l&apos;un prennent à l&apos;autre.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later, and so it has from every other start tried. A step works the new velocity out from the one that the circle has, which a hit may have changed; a start is set once, in `on_load`.</source>
        <translation>Partie de %1 m/s, la vitesse vaut %2 m/s un pas plus tard, et autant pour tout autre départ essayé. Un pas calcule la nouvelle vitesse à partir de celle du cercle, qu&apos;un choc a pu changer&#xa0;; le départ se fixe une fois, dans `on_load`.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s one step later, and that part is the same from every other start tried. A step works each part out from the one that the circle has, and keeps it for the next.</source>
        <translation>Partie de %1 m/s, la vitesse vaut %2 m/s un pas plus tard, et cette composante est la même pour tout autre départ essayé. Un pas calcule chaque composante à partir de celle du cercle, et la garde pour le suivant.</translation>
    </message>
    <message>
        <source>From every start tried the two are near each other one step later. Each circle goes on from its own place: look at the names in the line that moves it.</source>
        <translation>Depuis chaque départ essayé, les deux sont un pas plus tard l&apos;un près de l&apos;autre. Chaque cercle continue depuis sa propre position&#xa0;: regardez les noms dans la ligne qui le déplace.</translation>
    </message>
    <message>
        <source>Look at what your program asks there, and at what it keeps from one step to the next.</source>
        <translation>Regardez ce que votre programme demande à cet endroit, et ce qu&apos;il garde d&apos;un pas à l&apos;autre.</translation>
    </message>
    <message>
        <source>With all radii tried they answer at the same distance, between %1 and %2 m.</source>
        <translation>Avec tous les rayons essayés, ils réagissent à la même distance, entre %1 et %2 m.</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered in time.</source>
        <translation>
            <numerusform>Sur %1 essais de rencontre, %n a reçu une réponse à temps.</numerusform>
            <numerusform>Sur %1 essais de rencontre, %n ont reçu une réponse à temps.</numerusform>
        </translation>
    </message>
    <message>
        <source>This one came out wrong: %1.</source>
        <translation>Cette rencontre s&apos;est mal passée&#xa0;: %1.</translation>
    </message>
    <message>
        <source>This one was answered in time: %1.</source>
        <translation>Cette rencontre a reçu sa réponse à temps&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Look at what changes from one side to the other: the sign of a difference, or an angle.</source>
        <translation>Regardez ce qui change d&apos;un côté à l&apos;autre&#xa0;: le signe d&apos;une différence, ou un angle.</translation>
    </message>
    <message>
        <source>A hit is due where they overlap and come nearer along the line of centres, and nowhere else.</source>
        <translation>Un choc a lieu là où ils se chevauchent et se rapprochent le long de la ligne des centres, et nulle part ailleurs.</translation>
    </message>
    <message>
        <source>Some hits do not act along the line of centres</source>
        <translation>Certains chocs n&apos;agissent pas le long de la ligne des centres</translation>
    </message>
    <message>
        <source>Some hits of the two circles are answered too late</source>
        <translation>Certains chocs des deux cercles reçoivent une réponse trop tard</translation>
    </message>
    <message>
        <source>Some hits of the two circles are not answered</source>
        <translation>Certains chocs des deux cercles restent sans réponse</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered in time and along the line of centres: %2.</source>
        <translation>
            <numerusform>Sur %1 essais de rencontre, %n a reçu une réponse à temps et le long de la ligne des centres&#xa0;: %2.</numerusform>
            <numerusform>Sur %1 essais de rencontre, %n ont reçu une réponse à temps et le long de la ligne des centres&#xa0;: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered in time: %2.</source>
        <translation>
            <numerusform>Sur %1 essais de rencontre, %n a reçu une réponse à temps&#xa0;: %2.</numerusform>
            <numerusform>Sur %1 essais de rencontre, %n ont reçu une réponse à temps&#xa0;: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>their line of centres at %1°</source>
        <translation>la ligne de leurs centres à %1°</translation>
    </message>
    <message>
        <source>At every timestep, gravity and velocity tried it goes on by %1 m besides. Look at what is added to the position.</source>
        <translation>Avec chaque Δt, chaque pesanteur et chaque vitesse essayés, %1 m s&apos;y ajoutent. Regardez ce qui est ajouté à la position.</translation>
    </message>
    <message>
        <source>At every gravity and velocity tried it goes on by %1 m/s times Δt besides. Look at what is added to the position.</source>
        <translation>Avec chaque pesanteur et chaque vitesse essayées, %1 m/s fois Δt s&apos;y ajoutent. Regardez ce qui est ajouté à la position.</translation>
    </message>
    <message>
        <source>At every timestep tried gravity acts for %1 s. Take the parameter of `on_update`.</source>
        <translation>À chaque pas de temps essayé, la pesanteur agit pendant %1 s. Prenez le paramètre de `on_update`.</translation>
    </message>
    <message>
        <source>At times gravity acts wrongly on %who</source>
        <translation>Parfois la pesanteur agit mal (%who)</translation>
    </message>
    <message>
        <source>At times the velocity of %who changes wrongly</source>
        <translation>Parfois la vitesse change mal (%who)</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2, at %3 m and touching nothing, changed its velocity by %4 m/s in a step of %5 s; %6 m/s is right.</source>
        <translation>À %1 s de son exécution, le cercle %2, à %3 m et sans rien toucher, a changé sa vitesse de %4 m/s en un pas de %5 s&#xa0;; il faut %6 m/s.</translation>
    </message>
    <message>
        <source>At times the way of %who in a step is not v Δt</source>
        <translation>Parfois le chemin d&apos;un pas n&apos;est pas v Δt (%who)</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2, at %3 m and touching nothing, went %4 m in a step of %5 s; %6 m is right.</source>
        <translation>À %1 s de son exécution, le cercle %2, à %3 m et sans rien toucher, a avancé de %4 m en un pas de %5 s&#xa0;; il faut %6 m.</translation>
    </message>
    <message>
        <source>At times the motion of %who is not %1</source>
        <translation>Parfois le mouvement n&apos;est pas %1 (%who)</translation>
    </message>
    <message>
        <source>At %1 s of its run circle %2, at %3 m and touching nothing, went %4 m in a step of %5 s; by that method it is %6 m.</source>
        <translation>À %1 s de son exécution, le cercle %2, à %3 m et sans rien toucher, a avancé de %4 m en un pas de %5 s&#xa0;; par cette méthode, c&apos;est %6 m.</translation>
    </message>
    <message>
        <source>the exact parabola</source>
        <translation>la parabole exacte</translation>
    </message>
    <message>
        <source>The acceleration of %who depends wrongly on the velocity</source>
        <translation>L&apos;accélération dépend mal de la vitesse (%who)</translation>
    </message>
    <message>
        <source>Far from everything the velocity of %who turns round</source>
        <translation>Loin de tout, la vitesse se retourne (%who)</translation>
    </message>
    <message>
        <source>%1, where circle %2 was</source>
        <translation>%1, là où était le cercle %2</translation>
    </message>
    <message>
        <source>Some hits of the two circles come out wrong</source>
        <translation>Certains chocs des deux cercles se passent mal</translation>
    </message>
    <message>
        <source>%1, for circle %2 alone</source>
        <translation>%1, pour le seul cercle %2</translation>
    </message>
    <message>
        <source>With every e tried the rebound is that of e = %1.</source>
        <translation>Avec chaque e essayé, le rebond est celui de e = %1.</translation>
    </message>
    <message>
        <source>With every e tried circle 1 answers as with e = %1 and circle 2 as with e = %2.</source>
        <translation>Avec chaque e essayé, le cercle 1 répond comme avec e = %1 et le cercle 2 comme avec e = %2.</translation>
    </message>
    <message>
        <source>Two equal circles exchange their whole velocities</source>
        <translation>Deux cercles égaux échangent leurs vitesses entières</translation>
    </message>
    <message>
        <source>After an elastic hit the circles do not part</source>
        <translation>Après un choc élastique, les cercles ne se séparent pas</translation>
    </message>
    <message>
        <source>Along the line of centres, from 1 to 2, circle 1 came with %1 m/s and circle 2 with %2 m/s; they left with %3 and %4; %5 and %6 are right.</source>
        <translation>Le long de la ligne des centres, de 1 vers 2, le cercle 1 arrivait à %1 m/s et le cercle 2 à %2 m/s&#xa0;; ils sont repartis à %3 et %4&#xa0;; il faut %5 et %6.</translation>
    </message>
    <message>
        <source>Across the line of centres circle 1 came with %1 m/s and circle 2 with %2 m/s; they left with %3 and %4; %5 and %6 are right.</source>
        <translation>Perpendiculairement à la ligne des centres, le cercle 1 arrivait à %1 m/s et le cercle 2 à %2 m/s&#xa0;; ils sont repartis à %3 et %4&#xa0;; il faut %5 et %6.</translation>
    </message>
    <message>
        <source>of each circle in a run</source>
        <translation>de chaque cercle d&apos;une exécution</translation>
    </message>
    <message>
        <source>of each circle at each wall in a run</source>
        <translation>de chaque cercle contre chaque paroi d&apos;une exécution</translation>
    </message>
    <message>
        <source>in a run</source>
        <translation>d&apos;une exécution</translation>
    </message>
    <message>
        <source>all that came %1 s or more after the one before, none that came within %2 s</source>
        <translation>tous ceux venus %1 s ou plus après le précédent, aucun venu dans les %2 s</translation>
    </message>
    <message>
        <source>all up to %1 s of a run, none from %2 s on</source>
        <translation>tous jusqu&apos;à %1 s d&apos;une exécution, aucun à partir de %2 s</translation>
    </message>
    <message>
        <source>all from %1 s of a run on, none up to %2 s</source>
        <translation>tous à partir de %1 s d&apos;une exécution, aucun jusqu&apos;à %2 s</translation>
    </message>
    <message>
        <source>all at y = %1 m and above, none at y = %2 m and below</source>
        <translation>tous à y = %1 m et au-dessus, aucun à y = %2 m et en dessous</translation>
    </message>
    <message>
        <source>all at y = %1 m and below, none at y = %2 m and above</source>
        <translation>tous à y = %1 m et en dessous, aucun à y = %2 m et au-dessus</translation>
    </message>
    <message>
        <source>all at x = %1 m and left of it, none at x = %2 m and right of it</source>
        <translation>tous à x = %1 m et à gauche, aucun à x = %2 m et à droite</translation>
    </message>
    <message>
        <source>all at x = %1 m and right of it, none at x = %2 m and left of it</source>
        <translation>tous à x = %1 m et à droite, aucun à x = %2 m et à gauche</translation>
    </message>
    <message>
        <source>all with up to %1 m/s, none with %2 m/s or more</source>
        <translation>tous à %1 m/s au plus, aucun à %2 m/s ou plus</translation>
    </message>
    <message>
        <source>all with %1 m/s or more, none with up to %2 m/s</source>
        <translation>tous à %1 m/s ou plus, aucun à %2 m/s au plus</translation>
    </message>
    <message>
        <source>all with up to %1 m/s into the wall, none with %2 m/s or more</source>
        <translation>tous à %1 m/s au plus vers la paroi, aucun à %2 m/s ou plus</translation>
    </message>
    <message>
        <source>all with %1 m/s or more into the wall, none with up to %2 m/s</source>
        <translation>tous à %1 m/s ou plus vers la paroi, aucun à %2 m/s au plus</translation>
    </message>
    <message>
        <source>all with up to %1 m/s along the wall, none with %2 m/s or more</source>
        <translation>tous à %1 m/s au plus le long de la paroi, aucun à %2 m/s ou plus</translation>
    </message>
    <message>
        <source>all with %1 m/s or more along the wall, none with up to %2 m/s</source>
        <translation>tous à %1 m/s ou plus le long de la paroi, aucun à %2 m/s au plus</translation>
    </message>
    <message>
        <source>the first %1, none of the later ones</source>
        <translation>le premier %1, aucun des suivants</translation>
    </message>
    <message>
        <source>all but the first %1</source>
        <translation>tous sauf le premier %1</translation>
    </message>
    <message>
        <source>all up to number %1, none from number %2 on, counted %3</source>
        <translation>tous jusqu&apos;au numéro %1, aucun à partir du numéro %2, en comptant ceux %3</translation>
    </message>
    <message>
        <source>all from number %1 on, none up to number %2, counted %3</source>
        <translation>tous à partir du numéro %1, aucun jusqu&apos;au numéro %2, en comptant ceux %3</translation>
    </message>
    <message>
        <source>the first, the third and so on %1, none between them</source>
        <translation>le premier, le troisième et ainsi de suite %1, aucun entre eux</translation>
    </message>
    <message>
        <source>the second, the fourth and so on %1, none between them</source>
        <translation>le deuxième, le quatrième et ainsi de suite %1, aucun entre eux</translation>
    </message>
    <message>
        <source>all before the two circles had hit each other, none after it</source>
        <translation>tous avant que les deux cercles se soient heurtés, aucun après</translation>
    </message>
    <message>
        <source>all before the circles had hit a wall, none after it</source>
        <translation>tous avant que les cercles aient heurté une paroi, aucun après</translation>
    </message>
    <message>
        <source>all after the circles had hit a wall, none before it</source>
        <translation>tous après que les cercles ont heurté une paroi, aucun avant</translation>
    </message>
    <message>
        <source>all that moved to the right, no others</source>
        <translation>tous ceux qui allaient vers la droite, pas d&apos;autres</translation>
    </message>
    <message>
        <source>all that moved to the left, no others</source>
        <translation>tous ceux qui allaient vers la gauche, pas d&apos;autres</translation>
    </message>
    <message>
        <source>all that moved upward, no others</source>
        <translation>tous ceux qui montaient, pas d&apos;autres</translation>
    </message>
    <message>
        <source>all that moved downward, no others</source>
        <translation>tous ceux qui descendaient, pas d&apos;autres</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n came out right.</source>
        <translation>
            <numerusform>Sur %1 essais, tôt et tard, ici et là, %n s&apos;est bien passé.</numerusform>
            <numerusform>Sur %1 essais, tôt et tard, ici et là, %n se sont bien passés.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n came out right: %2.</source>
        <translation>
            <numerusform>Sur %1 essais, tôt et tard, ici et là, %n s&apos;est bien passé&#xa0;: %2.</numerusform>
            <numerusform>Sur %1 essais, tôt et tard, ici et là, %n se sont bien passés&#xa0;: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Which of these counts, the tries do not show.</source>
        <translation>Ce qui compte parmi cela, les essais ne le montrent pas.</translation>
    </message>
    <message>
        <source>With every e tried %1 of the speed comes back.</source>
        <translation>Avec chaque e essayé, %1 de la vitesse revient.</translation>
    </message>
    <message>
        <source>Hits at the %walls leave %who moving outward</source>
        <translation>Après les chocs contre %walls, on va encore vers l&apos;extérieur (%who)</translation>
    </message>
    <message>
        <source>With every e tried nothing of it is lost.</source>
        <translation>Avec chaque e essayé, rien n&apos;en est perdu.</translation>
    </message>
    <message>
        <source>Some hits of %who at the %walls are not answered</source>
        <translation>Certains chocs contre %walls restent sans réponse (%who)</translation>
    </message>
    <message>
        <source>Some hits of %who at the %walls come out wrong</source>
        <translation>Certains chocs contre %walls se passent mal (%who)</translation>
    </message>
    <message>
        <source>Some hits of %who at the %walls are answered too late</source>
        <translation>Certains chocs contre %walls reçoivent une réponse trop tard (%who)</translation>
    </message>
    <message>
        <source>This one came out right: circle %1 at %2 s, at the %3 at %4 m with %5 m/s.</source>
        <translation>Celui-ci s&apos;est bien passé&#xa0;: le cercle %1 à %2 s, contre %3 à %4 m, à %5 m/s.</translation>
    </message>
    <message>
        <source>At every wall %who went out</source>
        <translation>Sortie par toutes les parois (%who)</translation>
    </message>
    <message>
        <source>At the %walls %who went out</source>
        <translation>Sortie par %walls (%who)</translation>
    </message>
    <message>
        <source>Slow hits at the %walls leave %who moving outward</source>
        <translation>Après les chocs lents contre %walls, on va encore vers l&apos;extérieur (%who)</translation>
    </message>
    <message>
        <source>The x of %who does not change</source>
        <translation>x ne change pas (%who)</translation>
    </message>
    <message>
        <source>The x of %who changes without its velocity</source>
        <translation>x change sans la vitesse (%who)</translation>
    </message>
    <message>
        <source>The y of %who does not change</source>
        <translation>y ne change pas (%who)</translation>
    </message>
    <message>
        <source>The y of %who changes without its velocity</source>
        <translation>y change sans la vitesse (%who)</translation>
    </message>
    <message>
        <source>At every timestep tried it goes as far as in %1 s. Take the parameter of `on_update`.</source>
        <translation>À chaque pas de temps essayé, il va aussi loin qu&apos;en %1 s. Prenez le paramètre de `on_update`.</translation>
    </message>
    <message>
        <source>The velocity has no part in the way of %who</source>
        <translation>La vitesse n&apos;entre pas dans le chemin (%who)</translation>
    </message>
    <message>
        <source>Along the normal only circle 1 feels e</source>
        <translation>Suivant la normale, e n&apos;agit que sur le cercle 1</translation>
    </message>
    <message>
        <source>Along the normal only circle 2 feels e</source>
        <translation>Suivant la normale, e n&apos;agit que sur le cercle 2</translation>
    </message>
    <message>
        <source>Not every hit stops both circles</source>
        <translation>Certains chocs n&apos;arrêtent pas les deux cercles</translation>
    </message>
    <message>
        <source>Equal circles answer rightly, not all unequal ones do</source>
        <translation>Des cercles égaux réagissent bien, mais pas tous les cercles inégaux</translation>
    </message>
    <message>
        <source>Equal circles answer rightly, no unequal ones tried do</source>
        <translation>Des cercles égaux réagissent bien, aucun des cercles inégaux essayés</translation>
    </message>
    <message>
        <source>all while another circle moved to the right, no others</source>
        <translation>tous ceux pendant lesquels un autre cercle allait vers la droite, aucun autre</translation>
    </message>
    <message>
        <source>all while another circle moved to the left, no others</source>
        <translation>tous ceux pendant lesquels un autre cercle allait vers la gauche, aucun autre</translation>
    </message>
    <message>
        <source>all while another circle moved upward, no others</source>
        <translation>tous ceux pendant lesquels un autre cercle allait vers le haut, aucun autre</translation>
    </message>
    <message>
        <source>all while another circle moved downward, no others</source>
        <translation>tous ceux pendant lesquels un autre cercle allait vers le bas, aucun autre</translation>
    </message>
    <message>
        <source>In the step of a hit at the %walls gravity does not act on %who</source>
        <translation>Au pas d&apos;un choc contre %walls, la pesanteur n&apos;agit pas sur %who</translation>
    </message>
    <message>
        <source>In a step of %1 s gravity changes the velocity by %2 m/s, in the step of a hit, too. When circle %4 was turned at the %3, the part along the wall stayed as it was before the step.</source>
        <translation>Dans un pas de %1 s, la pesanteur change la vitesse de %2 m/s, au pas d&apos;un choc aussi. Quand le cercle %4 a fait demi-tour contre %3, la composante le long de la paroi est restée celle d&apos;avant le pas.</translation>
    </message>
    <message>
        <source>At the %walls the parts of the velocity of %who are mixed up</source>
        <translation>Contre %walls, les composantes de la vitesse sont confondues, pour %who</translation>
    </message>
    <message>
        <source>The part into the wall is turned round, the part along it stays: look at which part stands where.</source>
        <translation>La composante vers la paroi s&apos;inverse, celle le long de la paroi reste&#xa0;: regardez laquelle figure où.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who %1 times the whole velocity back</source>
        <translation>Les chocs contre %walls rendent %1 fois la vitesse entière, pour %who</translation>
    </message>
    <message>
        <source>At the %walls the place of circle %1 is asked for, not that of %who</source>
        <translation>Contre %walls, c&apos;est la position du cercle %1 qui est comparée, au lieu de la bonne, pour %who</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s, circle %3 went on past it. In the middle its velocity changed from %4 to %5 m/s, with circle %6 beyond that wall. Look at whose place stands in the question.</source>
        <translation>Lancé vers %1 avec %2 m/s, le cercle %3 a continué au-delà. Au milieu, sa vitesse est passée de %4 à %5 m/s, alors que le cercle %6 était derrière cette paroi. Regardez de qui la position figure dans la question.</translation>
    </message>
    <message>
        <source>Some hits at the %walls turn %who round too early</source>
        <translation>Certains chocs contre %walls renvoient %who trop tôt</translation>
    </message>
    <message>
        <source>Some hits at the %walls turn %who round too late</source>
        <translation>Certains chocs contre %walls renvoient %who trop tard</translation>
    </message>
    <message>
        <source>Of %1 hits tried there, %2 came at the rim.</source>
        <translation>Sur %1 chocs essayés là, au bord&#xa0;: %2.</translation>
    </message>
    <message>
        <source>The radius of circle %1 is %2 m, and at the %3 it turned when its centre was between %4 and %5 m from the wall. It should turn when its rim is there.</source>
        <translation>Le rayon du cercle %1 est de %2 m et, contre %3, il a fait demi-tour quand son centre était entre %4 et %5 m de la paroi. Il doit faire demi-tour quand son bord y est.</translation>
    </message>
    <message>
        <source>The radius of circle %1 is %2 m, and at the %3 it turned when its centre was between %4 m past the wall and %5 m short of it. It should turn when its rim is there.</source>
        <translation>Le rayon du cercle %1 est de %2 m et, contre %3, il a fait demi-tour quand son centre était entre %4 m derrière la paroi et %5 m devant elle. Il doit faire demi-tour quand son bord y est.</translation>
    </message>
    <message>
        <source>The radius of circle %1 is %2 m, and at the %3 it turned when its centre was between %4 and %5 m past the wall. It should turn when its rim is there.</source>
        <translation>Le rayon du cercle %1 est de %2 m et, contre %3, il a fait demi-tour quand son centre était entre %4 et %5 m derrière la paroi. Il doit faire demi-tour quand son bord y est.</translation>
    </message>
    <message>
        <source>Hits at the %walls put %who back to the start of the run</source>
        <translation>Les chocs contre %walls replacent %who là où l&apos;exécution a commencé</translation>
    </message>
    <message>
        <source>At the %1 the centre of circle %3 was put %2 m from the wall, as far as it was when the run began. The old place is that before the step: keep it anew in every step.</source>
        <translation>Contre %1, le centre du cercle %3 a été placé à %2 m de la paroi, aussi loin qu&apos;au début de l&apos;exécution. L&apos;ancienne position est celle d&apos;avant le pas&#xa0;: conservez-la de nouveau à chaque pas.</translation>
    </message>
    <message>
        <source>Of the %1 meetings that were tried %2 were answered in time; in %3 no velocity was changed.</source>
        <translation>Sur les %1 rencontres essayées, %2 ont reçu une réponse à temps&#xa0;; dans %3, aucune vitesse n&apos;a changé.</translation>
    </message>
    <message>
        <source>Some meetings are answered before they touch, others too late</source>
        <translation>Certaines rencontres reçoivent une réponse avant le contact, d&apos;autres trop tard</translation>
    </message>
    <message>
        <source>A distance is the root of the sum of the squares of both differences.</source>
        <translation>Une distance est la racine de la somme des carrés des deux différences.</translation>
    </message>
    <message>
        <source>The circles are compared in x alone</source>
        <translation>Les cercles sont comparés en x seulement</translation>
    </message>
    <message>
        <source>The circles are compared in y alone</source>
        <translation>Les cercles sont comparés en y seulement</translation>
    </message>
    <message>
        <source>|Δx + Δy| is not the distance</source>
        <translation>|Δx + Δy| n&apos;est pas la distance</translation>
    </message>
    <message>
        <source>In your own scene the circles answer before they touch</source>
        <translation>Dans votre propre scène, les cercles répondent avant de se toucher</translation>
    </message>
    <message>
        <source>In your own scene the circles answer too late</source>
        <translation>Dans votre propre scène, les cercles répondent trop tard</translation>
    </message>
    <message>
        <source>The distance of the centres comes into the push</source>
        <translation>La distance des centres entre dans la poussée</translation>
    </message>
    <message>
        <source>Where an angle is used: x is its cosine and y its sine, and `math.atan` takes y first, then x.</source>
        <translation>Là où un angle sert&#xa0;: x est son cosinus et y son sinus, et `math.atan` prend d&apos;abord y, puis x.</translation>
    </message>
    <message>
        <source>e is less than 1</source>
        <translation>e est inférieur à 1</translation>
    </message>
    <message>
        <source>e is 1</source>
        <translation>e vaut 1</translation>
    </message>
    <message>
        <source>all with circle %1 at up to %2 m/s, none with it at %3 m/s or more</source>
        <translation>tous ceux où le cercle %1 avait au plus %2 m/s, aucun où il en avait %3 m/s ou plus</translation>
    </message>
    <message>
        <source>all with circle %1 at %2 m/s or more, none with it at up to %3 m/s</source>
        <translation>tous ceux où le cercle %1 avait %2 m/s ou plus, aucun où il en avait au plus %3 m/s</translation>
    </message>
    <message>
        <source>all up to %1 m from (0, 0), none from %2 m on</source>
        <translation>tous jusqu&apos;à %1 m de (0, 0), aucun à partir de %2 m</translation>
    </message>
    <message>
        <source>all from %1 m from (0, 0) on, none up to %2 m</source>
        <translation>tous à partir de %1 m de (0, 0), aucun jusqu&apos;à %2 m</translation>
    </message>
    <message>
        <source>Circles that come nearer fast are not answered</source>
        <translation>Les cercles qui se rapprochent vite ne reçoivent pas de réponse</translation>
    </message>
    <message>
        <source>Not every meeting is answered</source>
        <translation>Toutes les rencontres ne reçoivent pas de réponse</translation>
    </message>
    <message>
        <source>Near %1 m circle 1 came with %2 m/s and circle 2 with %3 m/s, and they ran into each other; elsewhere others are answered. What counts is whether they overlap and come nearer.</source>
        <translation>Près de %1 m, le cercle 1 est arrivé avec %2 m/s et le cercle 2 avec %3 m/s, et ils sont entrés l&apos;un dans l&apos;autre&#xa0;; ailleurs, d&apos;autres rencontres reçoivent une réponse. Ce qui compte est s&apos;ils se chevauchent et se rapprochent.</translation>
    </message>
    <message>
        <source>Look at which masses and which signs stand in what is worked out for the other one.</source>
        <translation>Regardez quelles masses et quels signes figurent dans ce qui est calculé pour l&apos;autre.</translation>
    </message>
    <message>
        <source>No hit that was tried comes out right</source>
        <translation>Aucun des chocs essayés ne donne le bon résultat</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried, %n came out right: %2.</source>
        <translation>
            <numerusform>Sur %1 chocs essayés, %n a donné le bon résultat&#xa0;: %2.</numerusform>
            <numerusform>Sur %1 chocs essayés, %n ont donné le bon résultat&#xa0;: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried, %n came out right.</source>
        <translation>
            <numerusform>Sur %1 chocs essayés, %n a donné le bon résultat.</numerusform>
            <numerusform>Sur %1 chocs essayés, %n ont donné le bon résultat.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried with e = %2, %n came out right: %3.</source>
        <translation>
            <numerusform>Sur %1 chocs essayés avec e = %2, %n a donné le bon résultat&#xa0;: %3.</numerusform>
            <numerusform>Sur %1 chocs essayés avec e = %2, %n ont donné le bon résultat&#xa0;: %3.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits tried with e = %2, %n came out right.</source>
        <translation>
            <numerusform>Sur %1 chocs essayés avec e = %2, %n a donné le bon résultat.</numerusform>
            <numerusform>Sur %1 chocs essayés avec e = %2, %n ont donné le bon résultat.</numerusform>
        </translation>
    </message>
    <message>
        <source>In your own scene the first hit comes out right.</source>
        <translation>Dans votre propre scène, le premier choc donne le bon résultat.</translation>
    </message>
    <message>
        <source>In all hits that were tried circle 2 was at rest.</source>
        <translation>Dans tous les chocs essayés, le cercle 2 était au repos.</translation>
    </message>
    <message>
        <source>With e = %1 it comes out right.</source>
        <translation>Avec e = %1, le résultat est bon.</translation>
    </message>
    <message>
        <source>A step exchanges x and y in the place of %who</source>
        <translation>Un pas échange x et y de la position, pour %who</translation>
    </message>
    <message>
        <source>A step takes y for x in the place of %who</source>
        <translation>Un pas prend y pour x dans la position, pour %who</translation>
    </message>
    <message>
        <source>A step takes x for y in the place of %who</source>
        <translation>Un pas prend x pour y dans la position, pour %who</translation>
    </message>
    <message>
        <source>Each part of the place goes on from itself: look at which part stands where.</source>
        <translation>Chaque composante de la position part d&apos;elle-même&#xa0;: regardez laquelle se trouve où.</translation>
    </message>
    <message>
        <source>Every step puts %who at the same place</source>
        <translation>Chaque pas met %who à la même position</translation>
    </message>
    <message>
        <source>Every step puts %who at the same x</source>
        <translation>Chaque pas met %who au même x</translation>
    </message>
    <message>
        <source>Every step puts %who at the same y</source>
        <translation>Chaque pas met %who au même y</translation>
    </message>
    <message>
        <source>Started at %1 m with %2 m/s, it is at %3 m one step of %4 s later.</source>
        <translation>Parti de %1 m avec %2 m/s, le cercle est à %3 m un pas de %4 s plus tard.</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7), circle %8 leaves as if m₂/m₁ were %5; %6 is right.</source>
        <translation>Avec r₁ = %1 et r₂ = %2 m, ρ₁ = %3 et ρ₂ = %4 (e = %7), le cercle %8 repart comme si m₂/m₁ valait %5&#xa0;; il faut %6.</translation>
    </message>
    <message>
        <source>e multiplies the whole velocity of circle %1 after the hit</source>
        <translation>e multiplie la vitesse entière du cercle %1 après le choc</translation>
    </message>
    <message>
        <source>e belongs to the rebound along the line of centres alone.</source>
        <translation>e ne concerne que le rebond suivant la ligne des centres.</translation>
    </message>
    <message>
        <source>Both new velocities come from those *before* the hit: look at what each circle gets, and whether it is read before or after a velocity is written.</source>
        <translation>Les deux nouvelles vitesses se calculent à partir de celles d&apos;*avant* le choc&#xa0;: regardez ce que reçoit chaque cercle, et si c&apos;est lu avant ou après qu&apos;une vitesse est écrite.</translation>
    </message>
    <message>
        <source>So it is when the run begins. With that e a right program fails the check “%1”, too.</source>
        <translation>C&apos;est ainsi quand l&apos;exécution commence. Avec ce e, même un programme correct échoue à la vérification «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>%1 (in some hits)</source>
        <translation>%1 (dans certains chocs)</translation>
    </message>
    <message>
        <source>%1 (equal circles)</source>
        <translation>%1 (cercles égaux)</translation>
    </message>
    <message>
        <source>The distance is taken between places of two moments

Both circles flew with %1 m/s along the line of centres, the one behind %2 m/s faster: where circle 2 was ahead, they answered with the centres %3 m apart, where circle 1 was, %4 m; rims touch at %5 m. The two differ from that by what a circle flies in a step: look at whether both places are of the same moment, after both have moved.</source>
        <translation>La distance est prise entre des positions de deux instants

Les deux cercles volaient à %1 m/s suivant la ligne des centres, celui de derrière plus vite de %2 m/s&#xa0;: quand le cercle 2 était devant, ils ont réagi avec des centres à %3 m l&apos;un de l&apos;autre, quand c&apos;était le cercle 1, à %4 m&#xa0;; les bords se touchent à %5 m. Les deux s&apos;en écartent de ce qu&apos;un cercle parcourt en un pas&#xa0;: regardez si les deux positions sont du même instant, après le déplacement des deux.</translation>
    </message>
    <message>
        <source>Every step moves %who on from the place of the start</source>
        <translation>Chaque pas repart de la position de départ, pour %who</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it is %2 m from its start after the first step of %3 s, and %4 m after the second. The way of a step is added to the place before that step: is the old place kept anew in every step?</source>
        <translation>Parti à %1 m/s, il est à %2 m de son départ après le premier pas de %3 s, et à %4 m après le second. Le chemin d&apos;un pas s&apos;ajoute à la position d&apos;avant ce pas&#xa0;: l&apos;ancienne position est-elle gardée à nouveau à chaque pas&#xa0;?</translation>
    </message>
    <message>
        <source>Gravity on %who is divided by the timestep</source>
        <translation>La pesanteur est divisée par le pas de temps, pour %who</translation>
    </message>
    <message>
        <source>An acceleration times a time is a velocity. Look at what stands before the timestep in the line that changes the velocity.</source>
        <translation>Une accélération fois un temps est une vitesse. Regardez ce qui précède le pas de temps dans la ligne qui change la vitesse.</translation>
    </message>
    <message>
        <source>Not every step of %who is made alike</source>
        <translation>Les pas ne sont pas tous faits de la même façon, pour %who</translation>
    </message>
    <message>
        <source>A step or two later it is as at the start again. Look at what your program counts, or keeps from one step to the next.</source>
        <translation>Un ou deux pas plus tard, c&apos;est de nouveau comme au départ. Regardez ce que votre programme compte, ou garde d&apos;un pas au suivant.</translation>
    </message>
    <message>
        <source>Only the first step changes the velocity of %who rightly</source>
        <translation>Seul le premier pas change correctement la vitesse, pour %who</translation>
    </message>
    <message>
        <source>Thrown with %1 m/s, it has %2 m/s one step of %3 s later, which is right; in the next step that changes by %4 m/s, and gravity gives it %5 m/s. Look at which velocity the line that changes it goes on from, and at what your program keeps from one step to the next.</source>
        <translation>Lancé à %1 m/s, il a %2 m/s un pas de %3 s plus tard, et c&apos;est juste&#xa0;; au pas suivant sa vitesse change de %4 m/s, et la pesanteur lui donne %5 m/s. Regardez de quelle vitesse part la ligne qui la change, et ce que votre programme garde d&apos;un pas au suivant.</translation>
    </message>
    <message>
        <source>Let go at rest, it has %1 m/s one step of %2 s later, far from every wall and every other circle; gravity gives it %3 m/s in a step. Thrown with %4 m/s it goes on as it should.</source>
        <translation>Lâché au repos, il a %1 m/s un pas de %2 s plus tard, loin de toute paroi et de tout autre cercle&#xa0;; la pesanteur lui donne %3 m/s par pas. Lancé à %4 m/s, il continue comme il le doit.</translation>
    </message>
    <message>
        <source>e changes the velocity of %who away from any hit</source>
        <translation>Loin de tout choc, e change la vitesse, pour %who</translation>
    </message>
    <message>
        <source>Started with %1 m/s, it has %2 m/s two steps of %3 s later with e = %4, and %5 m/s with e = 1; nothing is near. e belongs to hits alone: look at what is asked before the line that takes it.</source>
        <translation>Parti à %1 m/s, il a deux pas de %3 s plus tard %2 m/s avec e = %4, et %5 m/s avec e = 1&#xa0;; rien n&apos;est proche. e ne concerne que les chocs&#xa0;: regardez ce qui est demandé avant la ligne qui s&apos;en sert.</translation>
    </message>
    <message>
        <source>With some timesteps the way of %who is not v Δt</source>
        <translation>Avec certains pas de temps, le chemin n&apos;est pas v Δt, pour %who</translation>
    </message>
    <message>
        <source>With Δt = %1 s it goes v Δt. Look at which Δt the line that changes the position takes.</source>
        <translation>Avec Δt = %1 s, le chemin est v Δt. Regardez quel Δt prend la ligne qui change la position.</translation>
    </message>
    <message>
        <source>Let go at rest, it goes as it should.</source>
        <translation>Lâché au repos, il se déplace comme il le doit.</translation>
    </message>
    <message>
        <source>The way of %who in a step is wrong</source>
        <translation>Le chemin d&apos;un pas est faux, pour %who</translation>
    </message>
    <message>
        <source>The way of %who is divided by the timestep</source>
        <translation>Le chemin est divisé par le pas de temps, pour %who</translation>
    </message>
    <message>
        <source>A velocity times a time is a length. Look at what stands before the timestep in the line that moves it.</source>
        <translation>Une vitesse fois un temps est une longueur. Regardez ce qui précède le pas de temps dans la ligne du déplacement.</translation>
    </message>
    <message>
        <source>The velocity of %who gets %1 times what gravity gives</source>
        <translation>La vitesse reçoit %1 fois ce que donne la pesanteur, pour %who</translation>
    </message>
    <message>
        <source>From every speed tried it has %1 m/s along the normal afterwards: work the new velocity out from the old one.</source>
        <translation>Quelle que soit la vitesse essayée, il a ensuite %1 m/s le long de la normale&#xa0;: calculez la nouvelle vitesse à partir de l&apos;ancienne.</translation>
    </message>
    <message>
        <source>Started at rest at two places, it is at one and the same place two steps later. A step *adds* a way to the old position.</source>
        <translation>Parti au repos de deux positions, il est deux pas plus tard à une seule et même position. Un pas *ajoute* un chemin à l&apos;ancienne position.</translation>
    </message>
    <message>
        <source>%1 (in most hits)</source>
        <translation>%1 (dans la plupart des chocs)</translation>
    </message>
    <message>
        <source>The circles do not stop in a hit</source>
        <translation>Les cercles ne s&apos;arrêtent pas dans un choc</translation>
    </message>
    <message>
        <source>Each circle keeps its direction and gets the other&apos;s speed</source>
        <translation>Chaque cercle garde sa direction et prend la vitesse de l&apos;autre en grandeur</translation>
    </message>
    <message>
        <source>A velocity has a direction, too: what changes hands is the whole part along the line of centres, not its length.</source>
        <translation>Une vitesse a aussi une direction&#xa0;: ce qui s&apos;échange est toute la composante suivant la ligne des centres, non sa longueur.</translation>
    </message>
    <message>
        <source>Thrown at each of them, %who went on through it; at the %1 with %2 m/s. Look at whether your program asks about walls for %who, and whether the answer is ever yes.</source>
        <translation>Lancé contre chacune, on passe au travers (%who)&#xa0;; contre %1, à %2 m/s. Regardez si votre programme demande ce qu&apos;il en est des parois (%who), et si la réponse est parfois oui.</translation>
    </message>
    <message>
        <source>In its first %1 s their rims come no nearer than %2 m, at %3 s. Look at the positions and velocities that they start with.</source>
        <translation>Pendant ses %1 premières secondes, leurs bords ne s&apos;approchent pas à moins de %2 m, à %3 s. Regarde avec quelles positions et quelles vitesses ils partent.</translation>
    </message>
    <message>
        <source>The circles of your scene do not meet in its first %1 s</source>
        <translation>Les cercles de ta scène ne se rencontrent pas pendant les %1 premières secondes</translation>
    </message>
    <message>
        <source>Circle %5 came to the %1 with %2 m/s and has %3 m/s after the hit, still into it; %4 m/s is right.</source>
        <translation>Le cercle %5 est arrivé contre %1 à %2 m/s et va à %3 m/s après le choc, toujours vers l&apos;extérieur&#xa0;; il faut %4 m/s.</translation>
    </message>
    <message>
        <source>However it is started, what it has one step later comes from the velocity of circle %1: started with %2 m/s, it has %3 m/s. Each circle goes on from its own velocity: look at the names in the line that changes it.</source>
        <translation>Quel que soit le départ, la vitesse un pas plus tard vient de celle du cercle %1&#xa0;: de %2 m/s au départ, elle passe à %3 m/s. Chaque cercle part de sa propre vitesse&#xa0;: regardez les noms dans la ligne qui la change.</translation>
    </message>
    <message>
        <source>A step *adds* a way to the old position: look at the lines that put it there, and at what is asked before them.</source>
        <translation>Un pas *ajoute* un chemin à l&apos;ancienne position&#xa0;: regardez les lignes qui mettent le cercle là, et ce qui est demandé avant elles.</translation>
    </message>
    <message>
        <source>No hit tried is answered but that of your own scene</source>
        <translation>Aucun choc essayé n&apos;a de réponse, hors celui de votre scène</translation>
    </message>
    <message>
        <source>The circles are answered much too late, or not at all</source>
        <translation>Les cercles reçoivent une réponse bien trop tard, ou aucune</translation>
    </message>
    <message>
        <source>A hit puts the circles too far apart</source>
        <translation>Un choc place les cercles trop loin l&apos;un de l&apos;autre</translation>
    </message>
    <message>
        <source>They came until their centres were %1 m apart, and the step with the answer put them %2 m apart; rims touch at %3 m. It is enough that they touch: look at how far each of the two is moved.</source>
        <translation>Ils sont venus jusqu&apos;à %1 m entre les centres, et le pas de la réponse les a mis à %2 m&#xa0;; les bords se touchent à %3 m. Il suffit qu&apos;ils se touchent&#xa0;: regardez de combien chacun des deux est déplacé.</translation>
    </message>
    <message>
        <source>A hit stops the x parts alone</source>
        <translation>Un choc n&apos;arrête que les composantes x</translation>
    </message>
    <message>
        <source>A hit stops the y parts alone</source>
        <translation>Un choc n&apos;arrête que les composantes y</translation>
    </message>
    <message>
        <source>The floor does not hold circle %1 up

Here e is %4. After %2 s near the floor its rim is %3 m below it, and deeper than before: the floor changes its velocity, and yet gravity pulls it on. Put the circle back where it touches.</source>
        <translation>Le sol ne retient pas le cercle %1

Ici, e vaut %4. Après %2 s près du sol, son bord est %3 m au-dessous, et plus bas qu&apos;avant&#xa0;: le sol change sa vitesse, et pourtant la pesanteur continue de l&apos;entraîner. Remettez le cercle là où il touche le sol.</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² the acceleration is %2 m/s², and %3 m/s² under %4 m/s².</source>
        <translation>Sous la pesanteur %1 m/s², l&apos;accélération est de %2 m/s², et de %3 m/s² sous %4 m/s².</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² the way of a step is %2, with v from before it.</source>
        <translation>Sous la pesanteur %1 m/s², le chemin d&apos;un pas est %2, v étant la vitesse d&apos;avant.</translation>
    </message>
    <message>
        <source>Euler adds nothing to v Δt, symplectic Euler g Δt², the exact methods (Verlet, Runge-Kutta 4) ½ g Δt²; one of these is asked for.</source>
        <translation>Euler n&apos;ajoute rien à v Δt, Euler symplectique g Δt², les méthodes exactes (Verlet, Runge-Kutta 4) ½ g Δt²&#xa0;; l&apos;un de ceux-ci est demandé.</translation>
    </message>
    <message>
        <source>Euler moves by the velocity from before the step alone.</source>
        <translation>Euler déplace avec la seule vitesse d&apos;avant le pas.</translation>
    </message>
    <message>
        <source>Symplectic Euler changes the velocity first and moves by the new one, which is v Δt + g Δt².</source>
        <translation>Euler symplectique change d&apos;abord la vitesse et déplace avec la nouvelle, ce qui fait v Δt + g Δt².</translation>
    </message>
    <message>
        <source>%1 is asked for.</source>
        <translation>Il faut %1.</translation>
    </message>
    <message>
        <source>The sign of ½ g Δt² is wrong in the motion of %who</source>
        <translation>Le signe de ½ g Δt² est faux, pour %who</translation>
    </message>
    <message>
        <source>The circles have each other&apos;s method

Under gravity the way of circle 1 in a step is %1, that of circle 2 %2; it should be the other way round. Look at which circle goes with which method.</source>
        <translation>Chaque cercle a la méthode de l&apos;autre

Sous la pesanteur, le chemin du cercle 1 en un pas est %1, celui du cercle 2 %2&#xa0;; ce devrait être l&apos;inverse. Regardez quel cercle va avec quelle méthode.</translation>
    </message>
    <message>
        <source>The circles move by different methods

Under gravity circle 1 moves by %1, with the way %2 in a step, and circle 2 by %3, with %4; both need the same. Look at which lines move which circle.</source>
        <translation>Les cercles se déplacent selon des méthodes différentes

Sous la pesanteur, le cercle 1 se déplace selon %1, avec le chemin %2 en un pas, et le cercle 2 selon %3, avec %4&#xa0;; il faut la même pour les deux. Regardez quelles lignes déplacent quel cercle.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: the radius of the other circle there. Look at whose radius stands in the questions.</source>
        <translation>Le rayon du cercle %3 est de %1 m, et le demi-tour a lieu quand le centre est à %2 m de la paroi&#xa0;: c&apos;est là le rayon de l&apos;autre cercle. Regardez le rayon de quel cercle figure dans les conditions.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: the radius of the other circle there, which is larger. Each circle has its own.</source>
        <translation>Le rayon du cercle %3 est de %1 m, et il repart quand son centre est à %2 m de la paroi&#xa0;: c&apos;est là le rayon de l&apos;autre cercle, qui est plus grand. Chaque cercle a le sien.</translation>
    </message>
    <message>
        <source>The radius of circle %3 is %1 m, and it turns when its centre is %2 m from the wall: the radius of the other circle there, which is smaller. Each circle has its own.</source>
        <translation>Le rayon du cercle %3 est de %1 m, et il repart quand son centre est à %2 m de la paroi&#xa0;: c&apos;est là le rayon de l&apos;autre cercle, qui est plus petit. Chaque cercle a le sien.</translation>
    </message>
    <message>
        <source>Here the radius of circle %3 is %1 m, and yet it turns when its centre is 0.2 m from the wall. Take the radius that the circle has.</source>
        <translation>Ici, le rayon du cercle %3 est de %1 m, et pourtant le demi-tour a lieu quand le centre est à 0.2 m de la paroi. Prenez le rayon que possède le cercle.</translation>
    </message>
    <message>
        <source>Circle %1 was turned round again while it left a wall

It was on its way back from the %2 and was turned into it once more. Put it back inside, or ask which way it moves before you turn it.</source>
        <translation>Le cercle %1 a été renvoyé une seconde fois alors qu&apos;il quittait une paroi

Il revenait de ceci&#xa0;: %2, et y a été renvoyé. Remettez-le à l&apos;intérieur, ou demandez dans quel sens il va avant de le renvoyer.</translation>
    </message>
    <message>
        <source>Circle %1 was turned round again while it left a wall

It was on its way back from the %2 and was turned into it once more; in a run that begins there it goes on. Look at what your program keeps from one step to the next.</source>
        <translation>Le cercle %1 a été renvoyé une seconde fois alors qu&apos;il quittait une paroi

Il revenait de ceci&#xa0;: %2, et y a été renvoyé&#xa0;; dans une exécution qui commence là, il continue. Regardez ce que votre programme garde d&apos;un pas au suivant.</translation>
    </message>
    <message>
        <source>With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m; v Δt is %4 m.</source>
        <translation>Avec la vitesse %1 m/s et Δt = %2 s, le chemin d&apos;un pas est de %3 m&#xa0;; v Δt vaut %4 m.</translation>
    </message>
    <message>
        <source>With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m, with %4 m/s %5 m; v Δt is %6 and %7 m.</source>
        <translation>Avec la vitesse %1 m/s et Δt = %2 s, le chemin d&apos;un pas est de %3 m&#xa0;; avec %4 m/s, de %5 m&#xa0;; v Δt vaut %6 et %7 m.</translation>
    </message>
    <message>
        <source>With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m, with %4 m/s %5 m; %6 and %7 m are right.</source>
        <translation>Avec la vitesse %1 m/s et Δt = %2 s, le chemin d&apos;un pas est de %3 m&#xa0;; avec %4 m/s, de %5 m&#xa0;; les valeurs justes sont %6 et %7 m.</translation>
    </message>
    <message>
        <source>The way of a step is %1 with the velocity %2 m/s, and %3 with %4 m/s. Euler adds nothing to v Δt, symplectic Euler g Δt², the exact methods ½ g Δt². Look at what is asked before the lines that change the position.</source>
        <translation>Le chemin d&apos;un pas est %1 avec la vitesse %2 m/s, et %3 avec %4 m/s. Euler n&apos;ajoute rien à v Δt, Euler symplectique g Δt², les méthodes exactes ½ g Δt². Regardez ce qui est demandé avant les lignes qui changent la position.</translation>
    </message>
    <message>
        <source>Every step must add v Δt to the position. Look at what the line that changes the position takes in its place.</source>
        <translation>Chaque pas doit ajouter v Δt à la position. Regardez ce que la ligne qui change la position prend à la place.</translation>
    </message>
    <message>
        <source>Every step must add v Δt to the position.</source>
        <translation>Chaque pas doit ajouter v Δt à la position.</translation>
    </message>
    <message>
        <source>Started with %1 m/s under gravity %2 m/s², away from every wall and every other circle, its velocity is 0 one step later; without gravity it keeps it.</source>
        <translation>Parti avec %1 m/s sous la pesanteur %2 m/s², loin de toute paroi et de tout autre cercle, sa vitesse est nulle un pas plus tard&#xa0;; sans pesanteur, il la garde.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, away from every wall and every other circle, its velocity is 0 one step later.</source>
        <translation>Parti avec %1 m/s, loin de toute paroi et de tout autre cercle, sa vitesse est nulle un pas plus tard.</translation>
    </message>
    <message>
        <source>Under gravity a step took the velocity of %who away</source>
        <translation>Sous la pesanteur, un pas a supprimé la vitesse, pour %who</translation>
    </message>
    <message>
        <source>Look at the lines that stop a circle, and at what is asked before they run: is it true although nothing touches?</source>
        <translation>Regardez les lignes qui arrêtent un cercle, et ce qui est demandé avant&#xa0;: est-ce vrai alors que rien ne se touche&#xa0;?</translation>
    </message>
    <message>
        <source>In free flight gravity leaves %who alone</source>
        <translation>En vol libre, la pesanteur n&apos;agit pas, pour %who</translation>
    </message>
    <message>
        <source>A fixed number stands for the timestep of %who</source>
        <translation>Un nombre fixe remplace le pas de temps, pour %who</translation>
    </message>
    <message>
        <source>At every timestep tried the whole step is made as if Δt were %1 s. Take the parameter of `on_update`.</source>
        <translation>Avec chaque pas de temps essayé, le pas entier se fait comme si Δt valait %1 s. Prenez le paramètre de `on_update`.</translation>
    </message>
    <message>
        <source>In free flight a step leaves %who as it was</source>
        <translation>En vol libre, un pas ne change rien, pour %who</translation>
    </message>
    <message>
        <source>Far from the %1 something turns %who round</source>
        <translation>Bien avant %1, quelque chose renvoie %who</translation>
    </message>
    <message>
        <source>A start towards the %1 turns %who round</source>
        <translation>Un départ vers %1 renvoie %who</translation>
    </message>
    <message>
        <source>Thrown straight towards the %1 with %2 m/s from %3 m, circle %4 has %5 m/s one step of %6 s later.</source>
        <translation>Lancé droit vers %1 avec %2 m/s depuis %3 m, le cercle %4 a %5 m/s un pas de %6 s plus tard.</translation>
    </message>
    <message>
        <source>It is at %1 m then.</source>
        <translation>Il est alors en %1 m.</translation>
    </message>
    <message>
        <source>So it is from all places tried; thrown the other way it goes on as it should.</source>
        <translation>Il en est ainsi depuis tous les endroits essayés&#xa0;; lancé dans l&apos;autre sens, il continue comme il le doit.</translation>
    </message>
    <message>
        <source>So it is where its centre comes to %1 or farther, and its rim to %2; the wall is at %3.</source>
        <translation>Il en est ainsi là où son centre arrive à %1 ou plus loin, et son bord à %2&#xa0;; la paroi est à %3.</translation>
    </message>
    <message>
        <source>Look at what your program asks for that wall, at the lengths there and at their signs.</source>
        <translation>Regardez ce que votre programme demande pour cette paroi, les longueurs qui s&apos;y trouvent et leurs signes.</translation>
    </message>
    <message>
        <source>Turned towards it by the wall opposite, it goes on. Look at what your program takes over of the velocity that a run begins with.</source>
        <translation>Tourné vers elle par la paroi d&apos;en face, il continue. Regardez ce que votre programme reprend de la vitesse avec laquelle une exécution commence.</translation>
    </message>
    <message>
        <source>The position does not change, either. Look at whether the lines that move a circle are reached in every step, and for which circle.</source>
        <translation>La position ne change pas non plus. Regardez si les lignes qui déplacent un cercle sont atteintes à chaque pas, et pour quel cercle.</translation>
    </message>
    <message>
        <source>The whole step of %who is made as with %1 Δt</source>
        <translation>Le pas entier se fait comme avec %1 Δt, pour %who</translation>
    </message>
    <message>
        <source>The way is %1 times v Δt, too: look at which Δt the lines of a step take, and at how often they run.</source>
        <translation>Le chemin, lui aussi, vaut %1 fois v Δt&#xa0;: regardez quel Δt prennent les lignes d&apos;un pas, et combien de fois elles s&apos;exécutent.</translation>
    </message>
    <message>
        <source>Circle %1 moved only in a step in which a wall was hit</source>
        <translation>Le cercle %1 n&apos;a bougé que dans un pas avec choc à une paroi</translation>
    </message>
    <message>
        <source>In the step in which circle %1 was answered by the %2 the other circle went %3 m; in no step before did it move. Look at what lets a step end before its turn, as `return` and `break` do, and at what is asked before it moves.</source>
        <translation>Dans le pas où le cercle %1 a reçu une réponse (%2), l&apos;autre cercle a avancé de %3 m&#xa0;; dans aucun pas précédent il n&apos;a bougé. Regardez ce qui fait finir un pas avant son tour, comme le font `return` et `break`, et ce qui est demandé avant qu&apos;il bouge.</translation>
    </message>
    <message>
        <source>In free flight a step moves %who nowhere</source>
        <translation>En vol libre, un pas ne déplace rien, pour %who</translation>
    </message>
    <message>
        <source>The circles are answered far apart, not where they touch</source>
        <translation>Les cercles réagissent loin l&apos;un de l&apos;autre, pas au contact</translation>
    </message>
    <message>
        <source>At %1 and %2 m, opposite each other about the middle of the square, they were answered with their centres %3 m apart.</source>
        <translation>En %1 et %2 m, opposés l&apos;un à l&apos;autre autour du milieu du carré, ils ont réagi avec leurs centres à %3 m l&apos;un de l&apos;autre.</translation>
    </message>
    <message>
        <source>Look at whether the two places are subtracted: their sum is not the way from one to the other.</source>
        <translation>Regardez si les deux positions sont soustraites&#xa0;: leur somme n&apos;est pas le chemin de l&apos;une à l&apos;autre.</translation>
    </message>
    <message>
        <source>From all %1 directions in which they were thrown at each other, with up to %2 m/s along the line of centres, neither of them changed its velocity.</source>
        <translation>Dans les %1 directions où ils ont été lancés l&apos;un contre l&apos;autre, à %2 m/s au plus suivant la ligne des centres, aucun n&apos;a changé de vitesse.</translation>
    </message>
    <message>
        <source>In your own scene, with %1 m/s, they were answered in time: look at what your program asks before they answer.</source>
        <translation>Dans votre propre scène, à %1 m/s, ils ont réagi à temps&#xa0;: regardez ce que votre programme demande avant qu’ils réagissent.</translation>
    </message>
    <message>
        <source>In your own scene their velocities changed where their centres were between %1 and %2 m apart; rims touch there at %3 m. Look at what their distance is compared with, and at what is asked besides.</source>
        <translation>Dans votre propre scène, les vitesses ont changé quand les centres étaient entre %1 et %2 m l&apos;un de l&apos;autre&#xa0;; les bords s&apos;y touchent à %3 m. Regardez à quoi leur distance est comparée, et ce qui est demandé en plus.</translation>
    </message>
    <message>
        <source>Gravity leaves %who at rest</source>
        <translation>La pesanteur laisse %who au repos</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4 (e = %7) the masses, whichever stands where, are as 1 to %5; 1 to %6 is right.</source>
        <translation>Avec r₁ = %1 et r₂ = %2 m, ρ₁ = %3 et ρ₂ = %4 (e = %7), les masses, quelle que soit la place de chacune, sont comme 1 à %5&#xa0;; 1 à %6 est juste.</translation>
    </message>
    <message>
        <source>Circle %1 answers as if it had the mass of the other</source>
        <translation>Le cercle %1 réagit comme s&apos;il avait la masse de l&apos;autre</translation>
    </message>
    <message>
        <source>Each circle answers as if it had the mass of the other</source>
        <translation>Chaque cercle réagit comme s&apos;il avait la masse de l&apos;autre</translation>
    </message>
    <message>
        <source>The heavier one is pushed away faster. Look at what each mass is made of, and at which stands where.</source>
        <translation>Le plus lourd est repoussé plus vite. Regardez de quoi chaque masse est faite, et laquelle figure où.</translation>
    </message>
    <message>
        <source>Each circle answers as if it had the other&apos;s radius</source>
        <translation>Chaque cercle réagit comme s&apos;il avait le rayon de l&apos;autre</translation>
    </message>
    <message>
        <source>Each circle answers as if it had the other&apos;s density</source>
        <translation>Chaque cercle réagit comme s&apos;il avait la masse volumique de l&apos;autre</translation>
    </message>
    <message>
        <source>Look at whose radius stands in which mass, and on which side of a division.</source>
        <translation>Regardez le rayon de quel cercle figure dans quelle masse, et de quel côté d&apos;une division.</translation>
    </message>
    <message>
        <source>Look at whose density stands in which mass, and on which side of a division.</source>
        <translation>Regardez la masse volumique de quel cercle figure dans quelle masse, et de quel côté d&apos;une division.</translation>
    </message>
    <message>
        <source>In the rebound the two shares are exchanged</source>
        <translation>Dans le rebond, les deux parts sont échangées</translation>
    </message>
    <message>
        <source>What comes back of the speed is e times it, not √e times.</source>
        <translation>De la vitesse revient e fois, et non √e fois.</translation>
    </message>
    <message>
        <source>As one circle hit a wall the way of the other changed</source>
        <translation>Quand un cercle a touché une paroi, le chemin de l&apos;autre a changé</translation>
    </message>
    <message>
        <source>They answer %2 m apart: that squared is about r₁ + r₂. A square is in m², a length in m.</source>
        <translation>Ils réagissent à %2 m l&apos;un de l&apos;autre&#xa0;: cela au carré vaut environ r₁ + r₂. Un carré est en m², une longueur en m.</translation>
    </message>
    <message>
        <source>With r₁ = %1 m and r₂ = %2 m they answered when their centres were between %3 and %4 m apart; rims touch where that is %5 m.</source>
        <translation>Avec r₁ = %1 m et r₂ = %2 m, ils ont réagi quand leurs centres étaient entre %3 et %4 m l&apos;un de l&apos;autre&#xa0;; les bords se touchent à %5 m.</translation>
    </message>
    <message>
        <source>Thrown with up to %1 m/s along the line of centres they answer in time.</source>
        <translation>Lancés à %1 m/s au plus suivant la ligne des centres, ils réagissent à temps.</translation>
    </message>
    <message>
        <source>In scenes that have their radii before your program begins they answer in time.</source>
        <translation>Dans des scènes dont les rayons sont déjà là avant le début de votre programme, ils réagissent à temps.</translation>
    </message>
    <message>
        <source>Look at when your program reads the radii: what is read before `on_load` sets them is an old value.</source>
        <translation>Regardez quand votre programme lit les rayons&#xa0;: ce qui est lu avant que `on_load` les fixe est une ancienne valeur.</translation>
    </message>
    <message>
        <source>Look at what the distance is compared with, and at what is asked besides.</source>
        <translation>Regardez à quoi la distance est comparée, et ce qui est demandé en plus.</translation>
    </message>
    <message>
        <source>A hit puts the circles into each other</source>
        <translation>Un choc met les cercles l&apos;un dans l&apos;autre</translation>
    </message>
    <message>
        <source>They came until their centres were %1 m apart, and the step with the answer put them %2 m apart; rims touch at %3 m. Look at the place that each of the two gets.</source>
        <translation>Ils sont venus jusqu&apos;à ce que leurs centres soient à %1 m l&apos;un de l&apos;autre, et le pas de la réponse les a mis à %2 m&#xa0;; les bords se touchent à %3 m. Regardez la position que reçoit chacun des deux.</translation>
    </message>
    <message>
        <source>The push is multiplied by the distance of the centres, in m. A direction has length 1: divide the way from one to the other by its length wherever it stands.</source>
        <translation>La poussée est multipliée par la distance des centres, en m. Une direction a la longueur 1&#xa0;: divisez le chemin de l&apos;un à l&apos;autre par sa longueur partout où il figure.</translation>
    </message>
    <message>
        <source>The rebound depends on how deep the circles overlap</source>
        <translation>Le rebond dépend du chevauchement des cercles</translation>
    </message>
    <message>
        <source>With a timestep of %1 s the circles parted with %2 times the speed along the push that they met with; %3 is right.</source>
        <translation>Avec un pas de temps de %1 s, les cercles se sont séparés avec %2 fois la vitesse suivant la poussée avec laquelle ils se sont rencontrés&#xa0;; %3 est juste.</translation>
    </message>
    <message>
        <source>In very short steps it comes out right: look at whether the normal has length 1 where they overlap.</source>
        <translation>Dans des pas très courts, c&apos;est juste&#xa0;: regardez si la normale a la longueur 1 là où ils se chevauchent.</translation>
    </message>
    <message>
        <source>With e = %1 and a timestep of %2 s the circles parted with %3 times the speed along the push that they met with; %4 is right.</source>
        <translation>Avec e = %1 et un pas de temps de %2 s, les cercles se sont séparés avec %3 fois la vitesse suivant la poussée avec laquelle ils se sont rencontrés&#xa0;; %4 est juste.</translation>
    </message>
    <message>
        <source>e multiplies the whole new part of circle %1</source>
        <translation>e multiplie toute la nouvelle composante du cercle %1</translation>
    </message>
    <message>
        <source>e multiplies both whole new parts</source>
        <translation>e multiplie entièrement les deux nouvelles composantes</translation>
    </message>
    <message>
        <source>The push is divided by the distance of the centres</source>
        <translation>La poussée est divisée par la distance des centres</translation>
    </message>
    <message>
        <source>The push is divided by the square of the distance of the centres, in m. A direction has length 1: look at how often the way from one to the other is divided by its length.</source>
        <translation>La poussée est divisée par le carré de la distance des centres, en m. Une direction a la longueur 1&#xa0;: regardez combien de fois le chemin de l&apos;un à l&apos;autre est divisé par sa longueur.</translation>
    </message>
    <message>
        <source>The distance, in m, must not change the size of the push. Look at how often the way from one to the other is divided by its length.</source>
        <translation>La distance, en m, ne doit pas changer la grandeur de la poussée. Regardez combien de fois le chemin de l&apos;un à l&apos;autre est divisé par sa longueur.</translation>
    </message>
    <message>
        <source>The push acts along the velocity of circle 2</source>
        <translation>La poussée agit suivant la vitesse du cercle 2</translation>
    </message>
    <message>
        <source>Each circle gets the new part of the other</source>
        <translation>Chaque cercle reçoit la nouvelle composante de l&apos;autre</translation>
    </message>
    <message>
        <source>In all hits tried both new parts along the line of centres are as they should be, but circle 1 has that of circle 2, and circle 2 that of circle 1. Look at which result goes to which circle.</source>
        <translation>Dans tous les chocs essayés, les deux nouvelles composantes suivant la ligne des centres sont comme il faut, mais le cercle 1 a celle du cercle 2, et le cercle 2 celle du cercle 1. Regardez quel résultat va à quel cercle.</translation>
    </message>
    <message>
        <source>What the two have in common does not depend on the masses</source>
        <translation>Ce que les deux ont en commun ne dépend pas des masses</translation>
    </message>
    <message>
        <source>In all hits tried what parts them again comes out right, but what both have in common is the mean of the two velocities along that line, whatever the masses are. The total momentum is not kept then, so no masses make it right. Look at where that mean is worked out.</source>
        <translation>Dans tous les chocs essayés, ce qui les sépare à nouveau est juste, mais ce qu&apos;ils ont en commun est la moyenne des deux vitesses suivant cette ligne, quelles que soient les masses. La quantité de mouvement totale n&apos;est alors pas conservée, donc aucune masse ne donne un résultat juste. Regardez où cette moyenne est calculée.</translation>
    </message>
    <message>
        <source>The rebound is shared half and half, whatever the masses are</source>
        <translation>Le rebond est partagé moitié-moitié, quelles que soient les masses</translation>
    </message>
    <message>
        <source>In all hits tried what both have in common comes out right, but of what parts them again each gets one half. The total momentum is not kept then, so no masses make it right: the lighter one should get more.</source>
        <translation>Dans tous les chocs essayés, ce qu&apos;ils ont en commun est juste, mais de ce qui les sépare à nouveau chacun reçoit la moitié. La quantité de mouvement totale n&apos;est alors pas conservée, donc aucune masse ne donne un résultat juste&#xa0;: le plus léger devrait recevoir davantage.</translation>
    </message>
    <message>
        <source>Each circle leaves with e times the momentum of the other</source>
        <translation>Chaque cercle repart avec e fois la quantité de mouvement de l&apos;autre</translation>
    </message>
    <message>
        <source>In all hits tried each circle has after the hit e times the momentum along that line that the other came with. The total momentum is not kept then: e acts on how fast they part alone.</source>
        <translation>Dans tous les chocs essayés, chaque cercle a après le choc e fois la quantité de mouvement suivant cette ligne avec laquelle l&apos;autre est venu. La quantité de mouvement totale n&apos;est alors pas conservée&#xa0;: e n&apos;agit que sur la vitesse avec laquelle ils se séparent.</translation>
    </message>
    <message>
        <source>The momenta along the line of centres change hands</source>
        <translation>Les quantités de mouvement suivant la ligne des centres sont échangées</translation>
    </message>
    <message>
        <source>In all hits tried each circle has after the hit the momentum along that line that the other came with. That keeps the total momentum, but where the masses differ they do not part as fast as they met.</source>
        <translation>Dans tous les chocs essayés, chaque cercle a après le choc la quantité de mouvement suivant cette ligne avec laquelle l&apos;autre est venu. Cela conserve la quantité de mouvement totale, mais là où les masses diffèrent, ils ne se séparent pas aussi vite qu&apos;ils se sont rencontrés.</translation>
    </message>
    <message>
        <source>The new parts along the line of centres have a wrong size</source>
        <translation>Les nouvelles composantes suivant la ligne des centres n&apos;ont pas la bonne grandeur</translation>
    </message>
    <message>
        <source>Both pushes have a wrong size</source>
        <translation>Les deux poussées n&apos;ont pas la bonne grandeur</translation>
    </message>
    <message>
        <source>Look at where the two masses are subtracted, and where they are added.</source>
        <translation>Regardez où les deux masses sont soustraites, et où elles sont additionnées.</translation>
    </message>
    <message>
        <source>In all hits tried of two masses both new parts are (m₁ + m₂) / (m₁ − m₂) times what is right.</source>
        <translation>Dans tous les chocs essayés de masses différentes, les deux nouvelles composantes valent (m₁ + m₂) / (m₁ − m₂) fois ce qui est juste.</translation>
    </message>
    <message>
        <source>In all hits tried of two masses both pushes are (m₁ + m₂) / (m₁ − m₂) times what is right.</source>
        <translation>Dans tous les chocs essayés de masses différentes, les deux poussées valent (m₁ + m₂) / (m₁ − m₂) fois ce qui est juste.</translation>
    </message>
    <message>
        <source>In all %1 meetings tried circle 2 was at rest; in your own scene it came with %2 m/s, and there they were answered in time. Look at whose velocities the answer is made of, and at what is asked before it.</source>
        <translation>Dans les %1 rencontres essayées, le cercle 2 était au repos&#xa0;; dans votre propre scène, il est venu avec %2 m/s, et là ils ont réagi à temps. Regardez de quelles vitesses la réponse est faite, et ce qui est demandé avant elle.</translation>
    </message>
    <message>
        <source>They came nearer with %1 m/s, touched and kept their velocities; with %2 m/s they are answered.</source>
        <translation>Ils se sont rapprochés à %1 m/s, se sont touchés et ont gardé leurs vitesses&#xa0;; à %2 m/s, ils réagissent.</translation>
    </message>
    <message>
        <source>They came nearer with %1 m/s and ran into each other; with %2 m/s they are answered.</source>
        <translation>Ils se sont rapprochés à %1 m/s et sont entrés l&apos;un dans l&apos;autre&#xa0;; à %2 m/s, ils réagissent.</translation>
    </message>
    <message>
        <source>How fast they come does not matter: what counts is whether they overlap and come nearer.</source>
        <translation>Peu importe leur vitesse&#xa0;: ce qui compte, c&apos;est s&apos;ils se chevauchent et se rapprochent.</translation>
    </message>
    <message>
        <source>%1 (with e = %2)</source>
        <translation>%1 (avec e = %2)</translation>
    </message>
    <message>
        <source>They go on side by side and do not part: each gets only half of the change that an elastic hit makes. Look for a factor 2 that is missing, or for a half or a mean.</source>
        <translation>Ils continuent côte à côte et ne se séparent pas&#xa0;: chacun ne reçoit que la moitié du changement que fait un choc élastique. Cherchez un facteur 2 qui manque, ou bien une moitié ou une moyenne.</translation>
    </message>
    <message>
        <source>In your own scene the walls do not use the e that it has</source>
        <translation>Dans votre propre scène, les parois n&apos;utilisent pas le e qu&apos;elle a</translation>
    </message>
    <message>
        <source>Each circle goes on with the velocity of the other</source>
        <translation>Chaque cercle continue avec la vitesse de l&apos;autre</translation>
    </message>
    <message>
        <source>However they are started, what each has one step later comes from the velocity of the other: started with %1 m/s, circle %2 has %3 m/s. Each goes on from its own velocity: look at the names in the lines that change it, and at what is asked before them.</source>
        <translation>Quel que soit le départ, la vitesse de chacun un pas plus tard vient de celle de l&apos;autre&#xa0;: parti à %1 m/s, le cercle %2 a %3 m/s. Chacun part de sa propre vitesse&#xa0;: regardez les noms dans les lignes qui la changent, et ce qui est demandé avant elles.</translation>
    </message>
    <message>
        <source>In free flight a step took the velocity of %who away</source>
        <translation>En vol libre, un pas a supprimé la vitesse, pour %who</translation>
    </message>
    <message>
        <source>What a hit makes is worked out from the velocities before it.</source>
        <translation>Ce que donne un choc se calcule à partir des vitesses d&apos;avant.</translation>
    </message>
    <message>
        <source>The velocities after a hit do not depend on those before</source>
        <translation>Les vitesses après un choc ne dépendent pas de celles d&apos;avant</translation>
    </message>
    <message>
        <source>From all hits tried circle 1 leaves with %1 m/s and circle 2 with %2 m/s.</source>
        <translation>De tous les chocs essayés, le cercle 1 repart à %1 m/s et le cercle 2 à %2 m/s.</translation>
    </message>
    <message>
        <source>The new parts along the normal do not depend on the old ones</source>
        <translation>Les nouvelles composantes suivant la normale ne dépendent pas des anciennes</translation>
    </message>
    <message>
        <source>Along the line of centres, from 1 to 2, circle 1 leaves all hits tried with %1 m/s and circle 2 with %2 m/s.</source>
        <translation>Suivant la ligne des centres, de 1 vers 2, le cercle 1 repart de tous les chocs essayés à %1 m/s et le cercle 2 à %2 m/s.</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered, in time or too early: %2.</source>
        <translation>
            <numerusform>Sur %1 essais de rencontre, %n a reçu une réponse, à temps ou trop tôt&#xa0;: %2.</numerusform>
            <numerusform>Sur %1 essais de rencontre, %n ont reçu une réponse, à temps ou trop tôt&#xa0;: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 meetings tried, %n were answered, in time or too early.</source>
        <translation>
            <numerusform>Sur %1 essais de rencontre, %n a reçu une réponse, à temps ou trop tôt.</numerusform>
            <numerusform>Sur %1 essais de rencontre, %n ont reçu une réponse, à temps ou trop tôt.</numerusform>
        </translation>
    </message>
    <message>
        <source>A hit changes velocities: look at whether the lines for that run, at what is asked before them, and at whether later lines change the velocities back.</source>
        <translation>Un choc change des vitesses&#xa0;: voyez si les lignes qui le font s&apos;exécutent, ce qui est demandé avant elles et si des lignes suivantes rétablissent les vitesses.</translation>
    </message>
    <message>
        <source>When they touched neither moved on as its velocity says, and after the step they had the velocities of before.</source>
        <translation>Quand ils se sont touchés, aucun n&apos;a avancé comme le dit sa vitesse, et après le pas ils avaient les vitesses d&apos;avant.</translation>
    </message>
    <message>
        <source>When they touched circle %1 did not move on as its velocity says, and after the step both had the velocities of before.</source>
        <translation>Quand ils se sont touchés, le cercle %1 n&apos;a pas avancé comme le dit sa vitesse, et après le pas tous deux avaient les vitesses d&apos;avant.</translation>
    </message>
    <message>
        <source>In the first hit of a run the line of centres was at %1°, in a later one at %2°. Both times the push was along the first line. Every hit has a normal of its own: work it out anew.</source>
        <translation>Au premier choc d&apos;une exécution, la ligne des centres était à %1°, à un choc ultérieur à %2°. Les deux fois, la poussée suivait la première ligne. Chaque choc a sa propre normale&#xa0;: recalculez-la.</translation>
    </message>
    <message>
        <source>The larger of two circles answers as the lighter one</source>
        <translation>Le plus grand de deux cercles réagit comme le plus léger</translation>
    </message>
    <message>
        <source>Of the same density it is the heavier one. Look at whose radius stands in which mass, and at which mass stands where.</source>
        <translation>À masse volumique égale, c&apos;est le plus lourd. Regardez le rayon de quel cercle figure dans quelle masse, et quelle masse figure où.</translation>
    </message>
    <message>
        <source>Two circles of the same radius and density answer as if circle 2 were %1 times as heavy as circle 1, and with ρ₁ = %2 and ρ₂ = %3 as if it were %4 times. Compare the lines for the two masses.</source>
        <translation>Deux cercles de même rayon et de même masse volumique réagissent comme si le cercle 2 était %1 fois aussi lourd que le cercle 1, et avec ρ₁ = %2 et ρ₂ = %3 comme s&apos;il l&apos;était %4 fois. Comparez les lignes des deux masses.</translation>
    </message>
    <message>
        <source>The two masses have the same ratio in all hits tried</source>
        <translation>Les deux masses ont le même rapport dans tous les chocs essayés</translation>
    </message>
    <message>
        <source>Of whatever size and density the two are, they answer as if circle 2 were %1 times as heavy as circle 1. Work each mass out from the `radius` and `density` of its own circle, which other scenes change.</source>
        <translation>Quelles que soient la taille et la masse volumique des deux, ils réagissent comme si le cercle 2 était %1 fois aussi lourd que le cercle 1. Calculez chaque masse à partir de `radius` et `density` de son propre cercle, que d&apos;autres scènes changent.</translation>
    </message>
    <message>
        <source>In your own scene even the first comes out wrong.</source>
        <translation>Dans votre propre scène, même le premier donne un mauvais résultat.</translation>
    </message>
    <message>
        <source>In your own scene, where circle 2 rests, the first hit comes out right.</source>
        <translation>Dans votre propre scène, où le cercle 2 est au repos, le premier choc donne le bon résultat.</translation>
    </message>
    <message>
        <source>Equal circles get %1 times the right push</source>
        <translation>Des cercles égaux reçoivent %1 fois la poussée juste</translation>
    </message>
    <message>
        <source>The push is multiplied by %1 + %2 e instead of 1 + e</source>
        <translation>La poussée est multipliée par %1 + %2 e au lieu de 1 + e</translation>
    </message>
    <message>
        <source>The push is multiplied by %1 − %2 e instead of 1 + e</source>
        <translation>La poussée est multipliée par %1 − %2 e au lieu de 1 + e</translation>
    </message>
    <message>
        <source>Both parts of a velocity have to become 0.</source>
        <translation>Les deux composantes d&apos;une vitesse doivent devenir 0.</translation>
    </message>
    <message>
        <source>A hit stops circle 1 and not circle 2</source>
        <translation>Un choc arrête le cercle 1 et non le cercle 2</translation>
    </message>
    <message>
        <source>A hit stops circle 2 and not circle 1</source>
        <translation>Un choc arrête le cercle 2 et non le cercle 1</translation>
    </message>
    <message>
        <source>A hit has to stop both.</source>
        <translation>Un choc doit arrêter les deux.</translation>
    </message>
    <message>
        <source>Circle 1 came with %1 m/s and left with %2 m/s, circle 2 came with %3 m/s and left with %4 m/s.</source>
        <translation>Le cercle 1 est venu à %1 m/s et reparti à %2 m/s, le cercle 2 est venu à %3 m/s et reparti à %4 m/s.</translation>
    </message>
    <message>
        <source>The circles exchange their whole velocities</source>
        <translation>Les cercles échangent leurs vitesses entières</translation>
    </message>
    <message>
        <source>Circle 1 loses its part across the normal</source>
        <translation>Le cercle 1 perd sa composante perpendiculaire à la normale</translation>
    </message>
    <message>
        <source>Circle 2 loses its part across the normal</source>
        <translation>Le cercle 2 perd sa composante perpendiculaire à la normale</translation>
    </message>
    <message>
        <source>Circle %3 is turned only when its centre is past the wall, with its rim one radius, %1 m, outside. A wall meets a body where the body ends.</source>
        <translation>Le cercle %3 ne fait demi-tour que lorsque son centre a passé la paroi, le bord étant dehors d&apos;un rayon, %1 m. Une paroi rencontre un corps là où le corps finit.</translation>
    </message>
    <message>
        <source>The acceleration is %1 m/s², under gravity %2 and under %3 m/s² alike.</source>
        <translation>L&apos;accélération est de %1 m/s², sous la pesanteur %2 comme sous %3 m/s².</translation>
    </message>
    <message>
        <source>The fall of %who depends on radius or density</source>
        <translation>La chute dépend du rayon ou de la masse volumique, pour %who</translation>
    </message>
    <message>
        <source>Under gravity %1 m/s² circle %4 is accelerated by %2 m/s², and by %3 m/s² when its radius is 1.25 times and its density 1.5 times as large. Gravity is an acceleration already: all bodies fall alike, whatever they weigh.</source>
        <translation>Sous la pesanteur %1 m/s², l&apos;accélération du cercle %4 est de %2 m/s², et de %3 m/s² quand le rayon est 1.25 fois et la masse volumique 1.5 fois plus grande. La pesanteur est déjà une accélération&#xa0;: tous les corps tombent de la même façon, quelle que soit leur masse.</translation>
    </message>
    <message>
        <source>So it is from every start tried.</source>
        <translation>Il en est ainsi depuis chaque départ essayé.</translation>
    </message>
    <message>
        <source>It has that x from every start tried.</source>
        <translation>Le cercle a cet x depuis chaque départ essayé.</translation>
    </message>
    <message>
        <source>It has that y from every start tried.</source>
        <translation>Le cercle a cet y depuis chaque départ essayé.</translation>
    </message>
    <message>
        <source>Thrown at each of them without gravity, %who went on through it; at the %1 with %2 m/s. Look at whether your program asks about walls for %who, and whether the answer is ever yes.</source>
        <translation>Lancé sans pesanteur contre chacune, on passe au travers (%who)&#xa0;; contre %1, à %2 m/s. Regardez si votre programme demande ce qu&apos;il en est des parois (%who), et si la réponse est parfois oui.</translation>
    </message>
    <message>
        <source>Circle %1 turned when its centre was between %2 and %3 m from the wall, with the radius %4 m as with %5 m. Take the radius that the circle has.</source>
        <translation>Le cercle %1 a fait demi-tour quand son centre était entre %2 et %3 m de la paroi, avec le rayon %4 m comme avec %5 m. Prenez le rayon que possède le cercle.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who another share of the speed than e</source>
        <translation>Les chocs contre %walls rendent une autre part de la vitesse que e, pour %who</translation>
    </message>
    <message>
        <source>At the floor, none slower than %1 m/s was tried.</source>
        <translation>Au sol, aucun n&apos;a été essayé à moins de %1 m/s.</translation>
    </message>
    <message>
        <source>With the velocity %1 m/s and Δt = %2 s the way of a step is %3 m</source>
        <translation>Avec la vitesse %1 m/s et Δt = %2 s, le chemin d&apos;un pas est de %3 m</translation>
    </message>
    <message>
        <source>; %1 m is right.</source>
        <translation>&#xa0;; la valeur juste est %1 m.</translation>
    </message>
    <message>
        <source>, of which %1 m are not of the velocity; v Δt is %2 m.</source>
        <translation>, dont %1 m ne viennent pas de la vitesse&#xa0;; v Δt vaut %2 m.</translation>
    </message>
    <message>
        <source>Only in your own scene a step moves %who</source>
        <translation>Un pas ne déplace que dans votre propre scène, pour %who</translation>
    </message>
    <message>
        <source>In the first step of your own scene it goes %1 m, as its velocity there makes it. So it should from every start: look at what is asked before the line that moves it.</source>
        <translation>Au premier pas de votre propre scène, le chemin est de %1 m, comme le veut la vitesse. Il doit en être ainsi depuis chaque départ&#xa0;: regardez ce qui est demandé avant la ligne qui déplace.</translation>
    </message>
    <message>
        <source>The circles are answered too late, or not at all</source>
        <translation>Les cercles réagissent trop tard, ou pas du tout</translation>
    </message>
    <message>
        <source>Circle 1 answers where it meets circle 2</source>
        <translation>Le cercle 1 réagit là où il rencontre le cercle 2</translation>
    </message>
    <message>
        <source>Circle 2 answers where it meets circle 1</source>
        <translation>Le cercle 2 réagit là où il rencontre le cercle 1</translation>
    </message>
    <message>
        <source>Along the line of centres and across it alike the velocities are multiplied by one number. Both directions need length 1, else their length comes in twice.</source>
        <translation>Suivant la ligne des centres comme perpendiculairement à elle, les vitesses sont multipliées par un même nombre. Les deux directions doivent avoir la longueur 1, sinon leur longueur intervient deux fois.</translation>
    </message>
    <message>
        <source>Normal and tangent are too short</source>
        <translation>La normale et la tangente sont trop courtes</translation>
    </message>
    <message>
        <source>Normal and tangent are too long</source>
        <translation>La normale et la tangente sont trop longues</translation>
    </message>
    <message>
        <source>Mass is density times volume, for each ball with its own radius: it grows with r³.</source>
        <translation>La masse est la masse volumique fois le volume, pour chaque boule avec son propre rayon&#xa0;: elle croît comme r³.</translation>
    </message>
    <message>
        <source>Two equal circles do not count as equally heavy</source>
        <translation>Deux cercles égaux ne comptent pas comme aussi lourds</translation>
    </message>
    <message>
        <source>They answer as if circle 2 were %1 times as heavy as circle 1. Compare the lines for the two masses, and those for the two pushes, number by number.</source>
        <translation>Ils réagissent comme si le cercle 2 était %1 fois aussi lourd que le cercle 1. Comparez les lignes des deux masses et celles des deux poussées, nombre par nombre.</translation>
    </message>
    <message>
        <source>With e = %1 a hit changes no velocity</source>
        <translation>Avec e = %1, un choc ne change aucune vitesse</translation>
    </message>
    <message>
        <source>They came nearer with %1 m/s along the line of centres, touched, and both kept their velocities; with e = %2 it comes out right. Look at what is asked before the lines with the answer, and at what e does there.</source>
        <translation>Ils se rapprochaient à %1 m/s suivant la ligne des centres, se sont touchés et ont tous deux gardé leur vitesse&#xa0;; avec e = %2, le résultat est bon. Regardez ce qui est demandé avant les lignes de la réponse, et ce que e y fait.</translation>
    </message>
    <message>
        <source>all but those where %1</source>
        <translation>tous sauf ceux où %1</translation>
    </message>
    <message>
        <source>those where %1, no others</source>
        <translation>ceux où %1, pas d&apos;autres</translation>
    </message>
    <message>
        <source>In one of %1 s it changes as it should. Look at which Δt the line that changes the velocity takes.</source>
        <translation>Dans un pas de %1 s, elle change comme elle le doit. Regardez quel Δt prend la ligne qui change la vitesse.</translation>
    </message>
    <message>
        <source>Let go at rest, it has %1 m/s one step of %2 s later, far from every wall and every other circle; gravity gives it %3 m/s in a step. Look at which lines change its velocity there, and at what is asked before them.</source>
        <translation>Lâché au repos, il a %1 m/s un pas de %2 s plus tard, loin de toute paroi et de tout autre cercle&#xa0;; la pesanteur lui donne %3 m/s par pas. Regardez quelles lignes y changent sa vitesse, et ce qui est demandé avant elles.</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and left it with %4 m/s, which is about %5 times as much, and `restitution` is %6.</source>
        <translation>Le cercle %1 est arrivé contre %2 à %3 m/s et en est reparti à %4 m/s, soit environ %5 fois autant, et `restitution` vaut %6.</translation>
    </message>
    <message>
        <source>Other scenes come out right. A copy of e that is made before e is set keeps the old value.</source>
        <translation>D&apos;autres scènes donnent le bon résultat. Une copie de e faite avant que e soit fixé garde l&apos;ancienne valeur.</translation>
    </message>
    <message>
        <source>In your own scene walls give another share of the speed back than e</source>
        <translation>Dans votre propre scène, des parois rendent une autre part de la vitesse que e</translation>
    </message>
    <message>
        <source>Of %1 fast hits in that run, %2 came out right. Look at what the new velocity is worked out from, and at what is asked before.</source>
        <translation>Sur %1 chocs rapides de cette simulation, se sont bien passés&#xa0;: %2. Regardez à partir de quoi la nouvelle vitesse est calculée, et ce qui est demandé avant.</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n were answered.</source>
        <translation>
            <numerusform>Sur %1 essais, tôt et tard, ici et là, %n a reçu une réponse.</numerusform>
            <numerusform>Sur %1 essais, tôt et tard, ici et là, %n ont reçu une réponse.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 tries, early and late, here and there, %n were answered: %2.</source>
        <translation>
            <numerusform>Sur %1 essais, tôt et tard, ici et là, %n a reçu une réponse&#xa0;: %2.</numerusform>
            <numerusform>Sur %1 essais, tôt et tard, ici et là, %n ont reçu une réponse&#xa0;: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Of %1 hits tried there, %2 came out right. Look at what your program asks there.</source>
        <translation>Sur %1 chocs essayés là, se sont bien passés&#xa0;: %2. Regardez ce que votre programme demande à cet endroit.</translation>
    </message>
    <message>
        <source>This one was answered: circle %1 at %2 s, at the %3 at %4 m with %5 m/s.</source>
        <translation>Celui-ci a reçu une réponse&#xa0;: le cercle %1 à %2 s, contre %3 à %4 m, à %5 m/s.</translation>
    </message>
    <message>
        <source>Look at what your program asks besides whether the rim is past the wall and the circle moves into it.</source>
        <translation>Regardez ce que votre programme demande en plus&#xa0;: il suffit que le bord soit au-delà de la paroi et que le cercle aille vers elle.</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s and e = %3, circle %4 went on past it; with %5 m/s and e = %6 it did not.</source>
        <translation>Lancé vers %1 à %2 m/s avec e = %3, le cercle %4 a continué au-delà&#xa0;; à %5 m/s avec e = %6, non.</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s from %3 m, circle %4 went on past it; with %5 m/s from %6 m it is turned round.</source>
        <translation>Lancé vers %1 à %2 m/s depuis %3 m, le cercle %4 a continué au-delà&#xa0;; à %5 m/s depuis %6 m, il est renvoyé.</translation>
    </message>
    <message>
        <source>Thrown at the %1 with %2 m/s from %3 m, circle %4 went on past it; with %5 m/s from %6 m it is held there.</source>
        <translation>Lancé vers %1 à %2 m/s depuis %3 m, le cercle %4 a continué au-delà&#xa0;; à %5 m/s depuis %6 m, il y est retenu.</translation>
    </message>
    <message>
        <source>Slow hits at the %walls turn %who round too early</source>
        <translation>Les chocs lents contre %walls renvoient %who trop tôt</translation>
    </message>
    <message>
        <source>Circle %1 came to the %2 with %3 m/s and turned when its centre was between %4 and %5 m from the wall; its radius is %6 m. With %7 m/s it turned at its rim, as far as a step of %8 m shows.</source>
        <translation>Le cercle %1 est arrivé contre %2 à %3 m/s et a fait demi-tour quand son centre était entre %4 et %5 m de la paroi&#xa0;; son rayon est de %6 m. À %7 m/s, il a fait demi-tour à son bord, autant qu&apos;un pas de %8 m le montre.</translation>
    </message>
    <message>
        <source>Hits at the %walls give %who one and the same speed</source>
        <translation>Les chocs contre %walls donnent une seule et même vitesse, pour %who</translation>
    </message>
    <message>
        <source>From every speed tried it leaves with %1 m/s: work the new velocity out from the old one.</source>
        <translation>Quelle que soit la vitesse essayée, il repart à %1 m/s&#xa0;: calculez la nouvelle vitesse à partir de l&apos;ancienne.</translation>
    </message>
    <message>
        <source>Hits at the %walls turn %who round a step too late</source>
        <translation>Les chocs contre %walls renvoient %who un pas trop tard</translation>
    </message>
    <message>
        <source>At the %1 the rim of circle %2 was %3 m past the wall before the step in which it was turned round, and %4 m after it. Turn it in the step in which its rim comes past the wall.</source>
        <translation>Contre %1, le bord du cercle %2 était à %3 m au-delà de la paroi avant le pas où il a été renvoyé, et à %4 m après. Renvoyez-le dans le pas où son bord dépasse la paroi.</translation>
    </message>
    <message>
        <source>In a corner the velocity of %who is lost</source>
        <translation>Dans un coin, la vitesse est perdue, pour %who</translation>
    </message>
    <message>
        <source>Circle %3 came with %1 m/s and has %2 m/s after it. Both walls are hit in the same step, and each must turn its own part.</source>
        <translation>Le cercle %3 est arrivé à %1 m/s et a ensuite %2 m/s. Les deux parois sont touchées dans le même pas, et chacune doit inverser sa composante.</translation>
    </message>
    <message>
        <source>When circle %1 was %2 m from the %3 its velocity stayed as it was, and that of the other changed, far from it and from every wall. A wall turns the circle that touches it, and no other.</source>
        <translation>Quand le cercle %1 était à %2 m de ceci&#xa0;: %3, sa vitesse est restée ce qu&apos;elle était, et celle de l&apos;autre a changé, loin de lui et de toute paroi. Une paroi renvoie le cercle qui la touche, et aucun autre.</translation>
    </message>
    <message>
        <source>Beside a wall the velocity of another circle changes</source>
        <translation>Près d&apos;une paroi, la vitesse d&apos;un autre cercle change</translation>
    </message>
    <message>
        <source>Until this is right, no more can be said of walls and hits.</source>
        <translation>Tant que cela n&apos;est pas juste, on ne peut rien dire de plus des parois et des chocs.</translation>
    </message>
    <message>
        <source>Until this is right, no more can be said of the walls.</source>
        <translation>Tant que cela n&apos;est pas juste, on ne peut rien dire de plus des parois.</translation>
    </message>
    <message>
        <source>Gravity leaves out steps of %who at the floor</source>
        <translation>Au sol, la pesanteur saute des pas, pour %who</translation>
    </message>
    <message>
        <source>Gravity acts twice in a step of %who at the floor</source>
        <translation>Au sol, la pesanteur agit deux fois dans un pas, pour %who</translation>
    </message>
    <message>
        <source>Thrown down with %1 m/s, circle %2 was turned by the floor in step %3. In that step its velocity went from %4 to %5 m/s; %6 m/s is right: turned round, and with g Δt once. Gravity acts once in every step, also where a circle touches the floor.</source>
        <translation>Lancé vers le bas à %1 m/s, le cercle %2 a été renvoyé par le sol au pas %3. Dans ce pas, sa vitesse est passée de %4 à %5 m/s ; %6 m/s serait juste : retournée, et une fois avec g Δt. La pesanteur agit une fois dans chaque pas, même là où un cercle touche le sol.</translation>
    </message>
    <message>
        <source>Thrown down with %1 m/s, circle %2 was turned by the floor in step %3. In step %7 its velocity went from %4 to %5 m/s; %6 m/s is right. Gravity acts once in every step, also where a circle touches the floor.</source>
        <translation>Lancé vers le bas à %1 m/s, le cercle %2 a été renvoyé par le sol au pas %3. Au pas %7, sa vitesse est passée de %4 à %5 m/s ; %6 m/s serait juste. La pesanteur agit une fois dans chaque pas, même là où un cercle touche le sol.</translation>
    </message>
    <message>
        <source>Until this is right, no more can be said of the hits of the two circles.</source>
        <translation>Tant que cela n&apos;est pas juste, on ne peut rien dire de plus des chocs des deux cercles.</translation>
    </message>
    <message>
        <source>all at the very start of a run, none later</source>
        <translation>tous au tout début d&apos;une exécution, aucun plus tard</translation>
    </message>
    <message>
        <source>all at the very start of a run, none from %1 s on</source>
        <translation>tous au tout début d&apos;une exécution, aucun à partir de %1 s</translation>
    </message>
    <message>
        <source>Seen of circles that move apart, which your program answers as if they met; right is what the answer should make of these velocities.</source>
        <translation>Vu sur des cercles qui s&apos;éloignent l&apos;un de l&apos;autre, auxquels votre programme réagit comme s&apos;ils se rencontraient&#xa0;; ce qui est juste est ce que la réponse devrait faire de ces vitesses.</translation>
    </message>
    <message>
        <source>The test of contact acts as if a number stood for %1</source>
        <translation>Le test de contact agit comme si un nombre tenait lieu de %1</translation>
    </message>
    <message>
        <source>With all radii tried they answer where the distance of the centres is between %1 + %2 m and %1 + %3 m.</source>
        <translation>Avec tous les rayons essayés, ils réagissent là où la distance des centres est entre %1 + %2 m et %1 + %3 m.</translation>
    </message>
    <message>
        <source>The whole relative velocity is turned round</source>
        <translation>La vitesse relative entière est inversée</translation>
    </message>
    <message>
        <source>What turns the parts along the line of centres round does the same to those across. A smooth circle pushes along the line of centres only; each keeps its own part across.</source>
        <translation>Ce qui inverse les composantes suivant la ligne des centres fait de même avec les composantes perpendiculaires. Un cercle lisse ne pousse que suivant la ligne des centres&#xa0;; chacun garde sa propre composante perpendiculaire.</translation>
    </message>
    <message>
        <source>With r₁ = %1 and r₂ = %2 m: </source>
        <translation>Avec r₁ = %1 et r₂ = %2 m&#xa0;: </translation>
    </message>
    <message>
        <source>Circles of different radii come out of a hit wrong</source>
        <translation>Des cercles de rayons différents sortent mal d&apos;un choc</translation>
    </message>
    <message>
        <source>Circles of the same radius come out right: look at where the radii enter what each of the two gets of the other.</source>
        <translation>Des cercles de même rayon en sortent bien&#xa0;: regardez où les rayons entrent dans ce que chacun des deux reçoit de l&apos;autre.</translation>
    </message>
    <message>
        <source>The size of the push hangs on the mass of circle %1 alone</source>
        <translation>La grandeur de la poussée dépend de la masse du cercle %1 seul</translation>
    </message>
    <message>
        <source>In all hits tried both pushes are as large as if both circles had the mass of circle %1; what each makes of its own push is right. Look at which masses stand in the size of the push.</source>
        <translation>Dans tous les chocs essayés, les deux poussées sont aussi grandes que si les deux cercles avaient la masse du cercle %1&#xa0;; ce que chacun fait de la sienne est juste. Regardez quelles masses figurent dans la grandeur de la poussée.</translation>
    </message>
    <message>
        <source>Look at whether the normal has length 1 where they overlap.</source>
        <translation>Regardez si la normale a la longueur 1 quand ils se chevauchent.</translation>
    </message>
    <message>
        <source>Look at whether the normal has length 1 where it is made, before they touch.</source>
        <translation>Regardez si la normale a la longueur 1 là où elle est formée, avant qu&apos;ils ne se touchent.</translation>
    </message>
    <message>
        <source>How deep they overlap after a step is chance: it may move their places apart, but must not come into the velocities.</source>
        <translation>La profondeur à laquelle ils se chevauchent après un pas est un hasard&#xa0;: elle peut écarter leurs positions, mais ne doit pas entrer dans les vitesses.</translation>
    </message>
    <message>
        <source>What a hit does depends on where in a step they touch</source>
        <translation>Ce que fait un choc dépend du moment du pas où ils se touchent</translation>
    </message>
    <message>
        <source>Where their rims touched after a quarter of a step of %1 s, they left with %2; where after two thirds, with %3; %4 are right.</source>
        <translation>Là où leurs bords se sont touchés après un quart d&apos;un pas de %1 s, ils sont repartis avec %2&#xa0;; là où c&apos;était après deux tiers, avec %3&#xa0;; %4 sont justes.</translation>
    </message>
    <message>
        <source>%1 and %2 m/s</source>
        <translation>%1 et %2 m/s</translation>
    </message>
    <message>
        <source>Two equal circles met head-on with %1 and %2 m/s; e was %3.</source>
        <translation>Deux cercles égaux se sont rencontrés de front avec %1 et %2 m/s&#xa0;; e valait %3.</translation>
    </message>
    <message>
        <source>Two equal circles met head-on with %1 and %2 m/s.</source>
        <translation>Deux cercles égaux se sont rencontrés de front avec %1 et %2 m/s.</translation>
    </message>
    <message>
        <source>In the step of the hit their velocities became %2 with a timestep of %1 s, and %4 with %3 s; %5 are right.</source>
        <translation>Dans le pas du choc, leurs vitesses sont devenues %2 avec un pas de temps de %1 s, et %4 avec %3 s&#xa0;; %5 sont justes.</translation>
    </message>
    <message>
        <source>A hit takes no time: look at where the timestep comes into what it does.</source>
        <translation>Un choc ne prend pas de temps&#xa0;: regardez où le pas de temps entre dans ce qu&apos;il fait.</translation>
    </message>
    <message>
        <source>What a hit does depends on the timestep</source>
        <translation>Ce que fait un choc dépend du pas de temps</translation>
    </message>
    <message>
        <source>A hit pushes circle %1 into the other one

In a step that would have brought their centres to %2 m from each other the hit put circle %1 %4 m nearer to the other one than its velocities before and after it take it; rims touch at %3 m. Each goes back to where it came from, or they are moved apart: look at the sign of the way that circle %1 is moved, and at whose velocity is in it.</source>
        <translation>Un choc enfonce le cercle %1 dans l&apos;autre

Dans un pas qui aurait amené leurs centres à %2 m l&apos;un de l&apos;autre, le choc a placé le cercle %1 de %4 m plus près de l&apos;autre que ne l&apos;amènent ses vitesses avant et après&#xa0;; les bords se touchent à %3 m. Chacun retourne d&apos;où il venait, ou on les écarte&#xa0;: regardez le signe du déplacement que reçoit le cercle %1, et la vitesse de quel cercle y figure.</translation>
    </message>
    <message>
        <source>A hit puts circle %1 too far away

In a step that would have brought their centres to %2 m from each other, where rims touch at %3 m, the hit put circle %1 %4 m farther from the other one than its velocities and twice that overlap explain. It is enough that they touch: look at how far it is moved.</source>
        <translation>Un choc place le cercle %1 trop loin

Dans un pas qui aurait amené leurs centres à %2 m l&apos;un de l&apos;autre, alors que les bords se touchent à %3 m, le choc a placé le cercle %1 de %4 m plus loin de l&apos;autre que ne l&apos;expliquent ses vitesses et le double de ce chevauchement. Il suffit qu&apos;ils se touchent&#xa0;: regardez de combien il est déplacé.</translation>
    </message>
    <message>
        <source>A hit moves circle %1 to the side

In a step that would have brought their centres to %2 m from each other, where rims touch at %3 m, the hit put circle %1 %4 m to the side of the ways that its velocities before and after it take it. A hit may move circles apart along the line of centres only: look at the direction in which it is moved, and at whose velocity is in it.</source>
        <translation>Un choc déplace le cercle %1 sur le côté

Dans un pas qui aurait amené leurs centres à %2 m l&apos;un de l&apos;autre, alors que les bords se touchent à %3 m, le choc a placé le cercle %1 à %4 m à côté des chemins où l&apos;amènent ses vitesses avant et après. Un choc ne peut écarter les cercles que le long de la ligne des centres&#xa0;: regardez la direction dans laquelle il est déplacé, et la vitesse de quel cercle y figure.</translation>
    </message>
    <message>
        <source>At the %walls the density comes into the speed of %who</source>
        <translation>Contre %walls, la densité entre dans la vitesse, pour %who</translation>
    </message>
    <message>
        <source>With ρ = %1 what comes back is %2 times the speed, with ρ = %3 it is %4 times; %5 is right.</source>
        <translation>Avec ρ = %1, il revient %2 fois la vitesse, avec ρ = %3 %4 fois&#xa0;; %5 est juste.</translation>
    </message>
    <message>
        <source>In your own scene circle %1 turns too late at the walls</source>
        <translation>Dans votre propre scène, le cercle %1 fait demi-tour trop tard aux parois</translation>
    </message>
    <message>
        <source>In your own scene circle %1 turns too early at the walls</source>
        <translation>Dans votre propre scène, le cercle %1 fait demi-tour trop tôt aux parois</translation>
    </message>
    <message>
        <source>Its radius is %1 m, and at the %2 it turned in a step that would have brought its centre from %3 to %4 m from the wall. In scenes that have their radii before your program begins it turns in time. Look at when your program reads the radii: what is read before `on_load` sets them is an old value.</source>
        <translation>Son rayon est de %1 m, et contre %2 il a fait demi-tour dans un pas qui aurait amené son centre de %3 à %4 m de la paroi. Dans des scènes dont les rayons sont déjà là avant le début de votre programme, il fait demi-tour à temps. Regardez quand votre programme lit les rayons&#xa0;: ce qui est lu avant que `on_load` les fixe est une ancienne valeur.</translation>
    </message>
    <message>
        <source>The first step of the hit, of %1 s, left them with %2, step %3 of it with %4; %5 are right, from the first on.</source>
        <translation>Le premier pas du choc, de %1 s, leur a laissé %2, son pas %3 %4&#xa0;; %5 sont justes, dès le premier.</translation>
    </message>
    <message>
        <source>A hit takes no time: all that it changes is due in the step in which they touch.</source>
        <translation>Un choc ne dure pas&#xa0;: tout ce qu&apos;il change est dû dans le pas où ils se touchent.</translation>
    </message>
    <message>
        <source>The push of a hit is spread over several steps</source>
        <translation>La poussée d&apos;un choc s&apos;étale sur plusieurs pas</translation>
    </message>
    <message>
        <source>The first step of a run is made in another way.</source>
        <translation>Le premier pas d&apos;une exécution est fait d&apos;une autre façon.</translation>
    </message>
    <message>
        <source>With its rim %1 m from the %2 and %3 m/s, circle %4 had %5 m/s one step of %6 s later; in free flight it has %7 m/s.</source>
        <translation>Quand il manquait %1 m à son bord pour atteindre %2, avec %3 m/s, le cercle %4 avait %5 m/s un pas de %6 s plus tard&#xa0;; en vol libre il a %7 m/s.</translation>
    </message>
    <message>
        <source>With its rim %1 m from the %2 and %3 m/s, circle %4 went %5 m in a step of %6 s; in free flight it goes %7 m.</source>
        <translation>Quand il manquait %1 m à son bord pour atteindre %2, avec %3 m/s, le cercle %4 a avancé de %5 m en un pas de %6 s&#xa0;; en vol libre il avance de %7 m.</translation>
    </message>
    <message>
        <source>Near the %walls the steps of %who are made in another way</source>
        <translation>Avant %walls, les pas de %who sont faits d&apos;une autre façon</translation>
    </message>
    <message>
        <source>Look at what your program asks there before its rim is at the wall.</source>
        <translation>Regardez ce que votre programme demande à cet endroit avant que le bord soit contre la paroi.</translation>
    </message>
    <message>
        <source>After hits at the %walls the way of %who is not v Δt</source>
        <translation>Après les chocs contre %walls, le mouvement de %who ne suit pas sa vitesse</translation>
    </message>
    <message>
        <source>Another circle that is near changes the velocity of %who</source>
        <translation>Un autre cercle, proche, change la vitesse de %who</translation>
    </message>
    <message>
        <source>In your own scene it starts with %1 m/s and has %2 m/s one step later; with every other circle set elsewhere it has %3 m/s then. In this step of the lab circles go through each other: look at what compares their places.</source>
        <translation>Dans votre propre scène il part avec %1 m/s et a %2 m/s un pas plus tard&#xa0;; avec tous les autres cercles ailleurs il a alors %3 m/s. Dans cette étape du TP les cercles passent les uns à travers les autres&#xa0;: regardez ce qui compare leurs positions.</translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits of unequal circles tried with e = %2, %n came out right: %3.</source>
        <translation>
            <numerusform>Sur %1 chocs essayés de cercles inégaux avec e = %2, %n a donné le bon résultat&#xa0;: %3.</numerusform>
            <numerusform>Sur %1 chocs essayés de cercles inégaux avec e = %2, %n ont donné le bon résultat&#xa0;: %3.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %1 hits of unequal circles tried, %n came out right: %2.</source>
        <translation>
            <numerusform>Sur %1 chocs essayés de cercles inégaux, %n a donné le bon résultat&#xa0;: %2.</numerusform>
            <numerusform>Sur %1 chocs essayés de cercles inégaux, %n ont donné le bon résultat&#xa0;: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Look at what the answer takes for e there, and at what is asked before it.</source>
        <translation>Regardez ce que la réponse prend là pour e, et ce qui est demandé avant.</translation>
    </message>
    <message>
        <source>In all hits of equal circles tried the velocities changed along that line by whole numbers of m/s: look for what rounds a number, such as `//` or `math.floor`.</source>
        <translation>Dans tous les chocs essayés de cercles égaux, les vitesses ont changé le long de cette ligne d&apos;un nombre entier de m/s&#xa0;: cherchez ce qui arrondit un nombre, comme `//` ou `math.floor`.</translation>
    </message>
    <message>
        <source>With r₁ = %1 m and r₂ = %2 m, met at %3°, they answered when their centres were %4 m apart.</source>
        <translation>Avec r₁ = %1 m et r₂ = %2 m, en se rencontrant sous un angle de %3°, ils ont réagi quand leurs centres étaient à %4 m l&apos;un de l&apos;autre.</translation>
    </message>
    <message>
        <source>Where their rims touched after a quarter of a step of %1 s, they were answered; where after two thirds, they ran into each other.</source>
        <translation>Là où leurs bords se sont touchés après un quart d&apos;un pas de %1 s, ils ont réagi&#xa0;; là où c&apos;était après deux tiers, ils sont entrés l&apos;un dans l&apos;autre.</translation>
    </message>
    <message>
        <source>Where their rims touched after two thirds of a step of %1 s, they were answered; where after a quarter, they ran into each other.</source>
        <translation>Là où leurs bords se sont touchés après deux tiers d&apos;un pas de %1 s, ils ont réagi&#xa0;; là où c&apos;était après un quart, ils sont entrés l&apos;un dans l&apos;autre.</translation>
    </message>
    <message>
        <source>Whether a hit is answered depends on where in a step they touch</source>
        <translation>Qu&apos;un choc ait une réponse dépend du moment du pas où ils se touchent</translation>
    </message>
    <message>
        <source>Look at how the moment of the hit is worked out, and at what is done with circles that overlap already.</source>
        <translation>Regardez comment le moment du choc est calculé, et ce qui est fait de cercles qui se chevauchent déjà.</translation>
    </message>
    <message>
        <source>On the floor the speed of %who along it changes</source>
        <translation>Sur le sol, la vitesse le long du sol change, pour %who</translation>
    </message>
    <message>
        <source>Circle %1 was let go %2 m above the floor with %3 m/s along it, and had %4 m/s along it %5 s later; %3 m/s is right. Where nothing rubs, a push points along the normal only: look at what slow hits at the floor change.</source>
        <translation>Le cercle %1 a été lâché %2 m au-dessus du sol avec %3 m/s le long du sol, et avait %4 m/s le long du sol %5 s plus tard&#xa0;; il faut %3 m/s. Là où rien ne frotte, une poussée n&apos;agit que le long de la normale&#xa0;: regardez ce que changent les chocs lents contre le sol.</translation>
    </message>
    <message>
        <source>Above the floor gravity stops moving %who</source>
        <translation>Au-dessus du sol, la pesanteur n&apos;agit plus, pour %who</translation>
    </message>
    <message>
        <source>Circle %1 was let go at rest %2 m above the floor, and from %3 s on it stood still %4 m above it, where nothing holds it. Look at what keeps a circle still, and at whether it lies on the floor then.</source>
        <translation>Le cercle %1 a été lâché au repos %2 m au-dessus du sol, et à partir de %3 s il est resté immobile %4 m au-dessus, où rien ne le retient. Regardez ce qui immobilise un cercle, et s&apos;il est alors posé sur le sol.</translation>
    </message>
    <message>
        <source>At the %walls the part along the wall comes into the rebound of %who</source>
        <translation>Contre %walls, la composante le long de la paroi entre dans le rebond, pour %who</translation>
    </message>
    <message>
        <source>With %1 m/s into the wall and %2 m/s along it, %3 times the part into it comes back; with %4 m/s along it %5 times. The part along a wall should not count there.</source>
        <translation>Avec %1 m/s vers la paroi et %2 m/s le long d&apos;elle, %3 fois la composante vers la paroi revient&#xa0;; avec %4 m/s le long d&apos;elle, %5 fois. La composante le long d&apos;une paroi ne doit pas y compter.</translation>
    </message>
    <message>
        <source>A wall turns the speed round; no fixed amount is added to it or taken from it.</source>
        <translation>Une paroi inverse la vitesse&#xa0;; elle n&apos;y ajoute ni n&apos;en retire aucune valeur fixe.</translation>
    </message>
    <message>
        <source>Hits at the %walls take a fixed amount of speed from %who</source>
        <translation>Les chocs contre %walls retirent une valeur fixe à la vitesse, pour %who</translation>
    </message>
    <message>
        <source>Hits at the %walls add a fixed amount of speed to %who</source>
        <translation>Les chocs contre %walls ajoutent une valeur fixe à la vitesse, pour %who</translation>
    </message>
    <message>
        <source>From every speed tried it leaves with about %1 m/s too little.</source>
        <translation>Quelle que soit la vitesse essayée, il repart avec environ %1 m/s de trop peu.</translation>
    </message>
    <message>
        <source>From every speed tried it leaves with about %1 m/s too much.</source>
        <translation>Quelle que soit la vitesse essayée, il repart avec environ %1 m/s de trop.</translation>
    </message>
    <message>
        <source>Its velocity points away from the wall only %1 s later, in steps of %2 s.</source>
        <translation>Sa vitesse ne s&apos;éloigne de la paroi que %1 s plus tard, par pas de %2 s.</translation>
    </message>
    <message>
        <source>In a step in which circle %1 hits a wall, circle %2 hits none</source>
        <translation>Au pas où le cercle %1 heurte une paroi, le cercle %2 n&apos;en heurte aucune</translation>
    </message>
    <message>
        <source>Thrown with %1 m/s, circle %2 came to the %3, and circle %5 with %4 m/s to the %6 in the same step: circle %2 was turned in it, and circle %5 was not. Alone it is. Look at what your program leaves out when the other circle is hit.</source>
        <translation>Lancé à %1 m/s, le cercle %2 est arrivé contre %3, et le cercle %5, à %4 m/s, contre %6 au même pas&#xa0;: le cercle %2 y a fait demi-tour, le cercle %5 non. Seul, il le fait. Regardez ce que votre programme omet quand l&apos;autre cercle est touché.</translation>
    </message>
    <message>
        <source>From every speed and with every e tried it leaves with about %1 m/s less than it came with.</source>
        <translation>Quelle que soit la vitesse et quel que soit e parmi ceux essayés, il repart avec environ %1 m/s de moins qu&apos;à l&apos;arrivée.</translation>
    </message>
    <message>
        <source>From every speed and with every e tried it leaves with about %1 m/s more than it came with.</source>
        <translation>Quelle que soit la vitesse et quel que soit e parmi ceux essayés, il repart avec environ %1 m/s de plus qu&apos;à l&apos;arrivée.</translation>
    </message>
    <message>
        <source>The distance of circles that come nearer is less than in the step before: look at what your program compares with what it keeps from there.</source>
        <translation>La distance de cercles qui se rapprochent est plus petite qu&apos;au pas précédent&#xa0;: regardez ce que votre programme compare à ce qu&apos;il en garde.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, in the first four steps of %2 s it goes %3, %4, %5 and %6 m more than is right of the velocity before each.</source>
        <translation>Lancé à %1 m/s, il avance dans les quatre premiers pas de %2 s de %3, %4, %5 et %6 m de plus que ce qui est juste selon la vitesse avant chacun.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, in the first four steps of %2 s its velocity changes by %3, %4, %5 and %6 m/s more than is right.</source>
        <translation>Lancé à %1 m/s, sa vitesse change dans les quatre premiers pas de %2 s de %3, %4, %5 et %6 m/s de plus que ce qui est juste.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, in the first four steps of %2 s it goes %3, %4, %5 and %6 m; %7 m is right in each.</source>
        <translation>Lancé à %1 m/s, il avance dans les quatre premiers pas de %2 s de %3, %4, %5 et %6 m&#xa0;; dans chacun, %7 m est juste.</translation>
    </message>
    <message>
        <source>Started with %1 m/s, in the first four steps of %2 s its velocity changes by %3, %4, %5 and %6 m/s; %7 m/s is right in each.</source>
        <translation>Lancé à %1 m/s, sa vitesse change dans les quatre premiers pas de %2 s de %3, %4, %5 et %6 m/s&#xa0;; dans chacun, %7 m/s est juste.</translation>
    </message>
    <message>
        <source>From step to step that grows by the same: look at what your program adds up, or counts, since the start.</source>
        <translation>D&apos;un pas au suivant, cela grandit d&apos;autant&#xa0;: regardez ce que votre programme additionne, ou compte, depuis le départ.</translation>
    </message>
    <message>
        <source>Look at what your program counts, or keeps from one step to the next, and at what is asked before these lines.</source>
        <translation>Regardez ce que votre programme compte, ou garde d&apos;un pas au suivant, et ce qui est demandé avant ces lignes.</translation>
    </message>
    <message>
        <source>Turned round at the %1, circle %2 has %3 m/s; in the next step of %4 s it went %5 m, and by that velocity it is %6 m.</source>
        <translation>Renvoyé par %1, le cercle %2 a %3 m/s&#xa0;; au pas suivant de %4 s il a avancé de %5 m, et selon cette vitesse c&apos;est %6 m.</translation>
    </message>
    <message>
        <source>So it goes in a run that begins there, too: look at what your program does with a circle that is at a wall and moves away from it.</source>
        <translation>Il en va de même dans une exécution qui commence là&#xa0;: regardez ce que votre programme fait d&apos;un cercle qui est contre un mur et s&apos;en éloigne.</translation>
    </message>
    <message>
        <source>A velocity or an old place that your program keeps in a variable of its own must change at a hit, too.</source>
        <translation>Une vitesse ou une ancienne position que votre programme garde dans une variable à lui doit changer au choc, elle aussi.</translation>
    </message>
    <message>
        <source>A step takes %who much farther than its velocity does</source>
        <translation>Un pas emmène %who bien plus loin que sa vitesse</translation>
    </message>
    <message>
        <source>Started with %1 m/s, away from every wall and every other circle, it goes %2 m in the first step of %3 s; v Δt is %4 m. Look at which lines change the position, and at what is asked before them.</source>
        <translation>Parti à %1 m/s, loin de toute paroi et de tout autre cercle, il parcourt %2 m au premier pas de %3 s&#xa0;; v Δt vaut %4 m. Regardez quelles lignes changent la position et ce qui est demandé avant elles.</translation>
    </message>
    <message>
        <source>Your program sets it at %1 m, and one step later it is at %2 m: that step goes on from %3 m, where the scene has it.</source>
        <translation>Votre programme le place à %1 m, et un pas plus tard il est à %2 m&#xa0;: ce pas part de %3 m, où la scène le place.</translation>
    </message>
    <message>
        <source>Your program starts it with %1 m/s, and one step later it has %2 m/s: that step goes on from %3 m/s, which the scene gives it.</source>
        <translation>Votre programme le lance à %1 m/s, et un pas plus tard il a %2 m/s&#xa0;: ce pas part de %3 m/s, que lui donne la scène.</translation>
    </message>
    <message>
        <source>Your program sets it at %1 m with %2 m/s, and one step later it is at %3 m with %4 m/s: that step goes on from %5 m and %6 m/s, which the scene gives it.</source>
        <translation>Votre programme le place à %1 m avec %2 m/s, et un pas plus tard il est à %3 m avec %4 m/s&#xa0;: ce pas part de %5 m et de %6 m/s, que lui donne la scène.</translation>
    </message>
    <message>
        <source>The start of %who in your own scene is not taken over</source>
        <translation>Le départ de %who dans votre propre scène n&apos;est pas repris</translation>
    </message>
    <message>
        <source>A copy keeps the value of the moment when it was made: is it made before the start is set?</source>
        <translation>Une copie garde la valeur du moment où elle a été faite&#xa0;: est-elle faite avant que le départ soit fixé&#xa0;?</translation>
    </message>
    <message>
        <source>In a corner one part of the velocity of %who turns round too late</source>
        <translation>Dans un coin, une composante de la vitesse de %who fait demi-tour trop tard</translation>
    </message>
    <message>
        <source>Circle %1 came with %2 m/s and has %3 m/s after the step that brought it into the corner, with its rim %4 m beyond the %5. Both walls are hit in the same step, and each must turn its own part, whichever comes first.</source>
        <translation>Le cercle %1 arrivait à %2 m/s et a %3 m/s après le pas qui l&apos;a amené dans le coin, son bord dépassant %5 de %4 m. Les deux parois sont touchées au même pas, et chacune doit retourner sa propre composante, quelle que soit la première.</translation>
    </message>
    <message>
        <source>The hit changed the velocity of circle 1 by no more than %1 m/s and that of circle 2 by %2 m/s: look at what the push is multiplied by, and what it is divided by.</source>
        <translation>Le choc n&apos;a changé la vitesse du cercle 1 que de %1 m/s et celle du cercle 2 que de %2 m/s&#xa0;: regardez par quoi l&apos;impulsion est multipliée et par quoi elle est divisée.</translation>
    </message>
</context>
<context>
    <name>FormulaWords</name>
    <message>
        <source>times</source>
        <translation>fois</translation>
    </message>
    <message>
        <source>is at most</source>
        <translation>est au plus</translation>
    </message>
    <message>
        <source>is at least</source>
        <translation>est au moins</translation>
    </message>
    <message>
        <source>is not</source>
        <translation>n&apos;est pas</translation>
    </message>
    <message>
        <source>is about</source>
        <translation>vaut environ</translation>
    </message>
    <message>
        <source>becomes</source>
        <translation>devient</translation>
    </message>
    <message>
        <source>plus or minus</source>
        <translation>plus ou moins</translation>
    </message>
    <message>
        <source>the sum of</source>
        <translation>la somme de</translation>
    </message>
    <message>
        <source>infinity</source>
        <translation>l&apos;infini</translation>
    </message>
    <message>
        <source>perpendicular</source>
        <translation>perpendiculaire</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>parallèle</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>degrés</translation>
    </message>
    <message>
        <source>prime</source>
        <translation>prime</translation>
    </message>
    <message>
        <source>equals</source>
        <translation>égale</translation>
    </message>
    <message>
        <source>plus</source>
        <translation>plus</translation>
    </message>
    <message>
        <source>minus</source>
        <translation>moins</translation>
    </message>
    <message>
        <source>over</source>
        <translation>sur</translation>
    </message>
    <message>
        <source>is less than</source>
        <translation>est inférieur à</translation>
    </message>
    <message>
        <source>is more than</source>
        <translation>est supérieur à</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>barre</translation>
    </message>
    <message>
        <source>sub %1</source>
        <translation>indice %1</translation>
    </message>
    <message>
        <source>squared</source>
        <translation>au carré</translation>
    </message>
    <message>
        <source>cubed</source>
        <translation>au cube</translation>
    </message>
    <message>
        <source>to the power of %1</source>
        <translation>à la puissance %1</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <comment>a fraction</comment>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>the square root of %1</source>
        <translation>la racine carrée de %1</translation>
    </message>
    <message>
        <source>vector %1</source>
        <translation>vecteur %1</translation>
    </message>
    <message>
        <source>unit vector %1</source>
        <translation>vecteur unitaire %1</translation>
    </message>
</context>
<context>
    <name>Ghost</name>
    <message>
        <source>exact</source>
        <translation>exact</translation>
    </message>
</context>
<context>
    <name>GlPainter</name>
    <message>
        <source>No OpenGL context can be made here</source>
        <translation>Aucun contexte OpenGL ne peut être créé ici</translation>
    </message>
    <message>
        <source>OpenGL 3.3 is needed, but %1 offers %2.%3</source>
        <translation>OpenGL 3.3 est nécessaire, mais %1 offre %2.%3</translation>
    </message>
    <message>
        <source>OpenGL 3.3 is needed</source>
        <translation>OpenGL 3.3 est nécessaire</translation>
    </message>
    <message>
        <source>The shader %1 is missing</source>
        <translation>Le shader %1 manque</translation>
    </message>
    <message>
        <source>The shader %1 does not compile: %2</source>
        <translation>Le shader %1 ne se compile pas&#xa0;: %2</translation>
    </message>
    <message>
        <source>The shaders %1 do not link: %2</source>
        <translation>L&apos;édition de liens des shaders %1 échoue&#xa0;: %2</translation>
    </message>
    <message>
        <source>OpenGL has no memory for the scene</source>
        <translation>OpenGL n&apos;a pas de mémoire pour la scène</translation>
    </message>
</context>
<context>
    <name>Grading</name>
    <message>
        <source>%1 is a link, which is not followed</source>
        <translation>%1 est un lien, qui n&apos;est pas suivi</translation>
    </message>
    <message>
        <source>%1 is neither a file nor a folder</source>
        <translation>%1 n&apos;est ni un fichier ni un dossier</translation>
    </message>
    <message>
        <source>download of %1</source>
        <translation>téléchargement de %1</translation>
    </message>
    <message>
        <source>Canvas says: late</source>
        <translation>Canvas indique&#xa0;: en retard</translation>
    </message>
    <message>
        <source>several attempts; the last one counts</source>
        <translation>plusieurs tentatives&#xa0;; la dernière compte</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>dossier</translation>
    </message>
    <message>
        <source>clone of GitHub Classroom</source>
        <translation>clone de GitHub Classroom</translation>
    </message>
    <message>
        <source>%1 is no work of a student</source>
        <translation>%1 n&apos;est pas le travail d&apos;un étudiant</translation>
    </message>
    <message>
        <source>file</source>
        <translation>fichier</translation>
    </message>
    <message>
        <source>this is the work of one student; the folder that holds those of all is right</source>
        <translation>c&apos;est le travail d&apos;un seul étudiant&#xa0;; il faut le dossier qui contient ceux de tous</translation>
    </message>
    <message>
        <source>%1 handed in no file</source>
        <translation>%1 n&apos;a rendu aucun fichier</translation>
    </message>
    <message>
        <source>the process that judges was killed %1 times without getting anything done</source>
        <translation>le processus d&apos;évaluation a été tué %1 fois sans rien avoir accompli</translation>
    </message>
    <message>
        <source>the process that judged it gave no verdict: %1</source>
        <translation>le processus d&apos;évaluation n&apos;a pas donné de verdict&#xa0;: %1</translation>
    </message>
    <message>
        <source>what judging found cannot be kept: %1</source>
        <translation>ce que l&apos;évaluation a trouvé ne peut pas être conservé&#xa0;: %1</translation>
    </message>
    <message>
        <source>this is no manifest of results of format 1</source>
        <translation>ce n&apos;est pas un manifeste de résultats au format 1</translation>
    </message>
    <message>
        <source>another process is writing results there</source>
        <translation>un autre processus écrit des résultats là</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 autres</translation>
    </message>
    <message>
        <source>%1: there are no results; its shard never began</source>
        <translation>%1&#xa0;: il n&apos;y a pas de résultats&#xa0;; son lot n&apos;a jamais commencé</translation>
    </message>
    <message>
        <source>%1: shard %2 of %3 did not come to its end</source>
        <translation>%1&#xa0;: le lot %2 sur %3 n&apos;est pas allé à son terme</translation>
    </message>
    <message>
        <source>none of these folders has results</source>
        <translation>aucun de ces dossiers n&apos;a de résultats</translation>
    </message>
    <message>
        <source>judged more than once, with the same result: %1</source>
        <translation>évalués plus d&apos;une fois, avec le même résultat&#xa0;: %1</translation>
    </message>
    <message>
        <source>missing of %1 shards: %2</source>
        <translation>manquent sur %1 lots&#xa0;: %2</translation>
    </message>
    <message>
        <source>without results: %1</source>
        <translation>sans résultats&#xa0;: %1</translation>
    </message>
    <message>
        <source>these results are of another version of the lab, of Cradle or of the secret than those before; they cannot be put together</source>
        <translation>ces résultats sont d&apos;une autre version du TP, de Cradle ou du secret que les précédents&#xa0;; on ne peut pas les réunir</translation>
    </message>
    <message>
        <source>these results are of another class, or of another number of shards, than those before</source>
        <translation>ces résultats sont d&apos;une autre classe, ou d&apos;un autre nombre de lots, que les précédents</translation>
    </message>
    <message>
        <source>%1: other isolation: %2</source>
        <translation>%1&#xa0;: autre isolation&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 is not as its manifest says, and is left out</source>
        <translation>%1 n&apos;est pas comme le dit son manifeste, et est laissé de côté</translation>
    </message>
    <message>
        <source>the results of %1 differ from those in %2</source>
        <translation>les résultats de %1 diffèrent de ceux de %2</translation>
    </message>
    <message>
        <source>handed in</source>
        <translation>ont rendu</translation>
    </message>
    <message>
        <source>handed in nothing</source>
        <translation>n&apos;ont rien rendu</translation>
    </message>
    <message>
        <source>pass every step</source>
        <translation>réussissent toutes les étapes</translation>
    </message>
    <message>
        <source>points on average</source>
        <translation>points en moyenne</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>steps not graded</source>
        <translation>étapes non notées</translation>
    </message>
    <message>
        <source>Not graded</source>
        <translation>Non noté</translation>
    </message>
    <message>
        <source>Here no verdict could be reached. These steps count neither as passed nor as failed, and the gradebooks leave the points of their students empty.</source>
        <translation>Ici, aucun verdict n&apos;a pu être rendu. Ces étapes ne comptent ni comme réussies ni comme échouées, et les carnets de notes laissent vides les points de leurs étudiants.</translation>
    </message>
    <message>
        <source>%1: the roster has %2, what was handed in has %3; judged with the values of %2.</source>
        <translation>%1&#xa0;: la liste a %2, ce qui a été rendu a %3&#xa0;; évalué avec les valeurs de %2.</translation>
    </message>
    <message>
        <source>%1 stands in what several handed in: %2.</source>
        <translation>%1 figure dans ce que plusieurs ont rendu&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Numbers that are not clear</source>
        <translation>Numéros peu clairs</translation>
    </message>
    <message>
        <source>This lab draws values by a student&apos;s number: that of the roster, where it has one, else that of what was handed in. A mistyped number is likelier than anything else.</source>
        <translation>Ce TP tire ses valeurs selon le numéro de l&apos;étudiant&#xa0;: celui de la liste si elle en a un, sinon celui de ce qui a été rendu. Un numéro mal tapé est plus probable que tout le reste.</translation>
    </message>
    <message>
        <source>And %1 more.</source>
        <translation>Et %1 autres.</translation>
    </message>
    <message>
        <source>Handed in nothing</source>
        <translation>N&apos;ont rien rendu</translation>
    </message>
    <message>
        <source>How it was judged</source>
        <translation>Comment l&apos;évaluation s&apos;est faite</translation>
    </message>
    <message>
        <source>By %1, with version %2 of the lab %3 (sha256 %4).</source>
        <translation>Par %1, avec la version %2 du TP %3 (sha256 %4).</translation>
    </message>
    <message>
        <source>Programs were kept apart by: %1.</source>
        <translation>Les programmes étaient isolés par&#xa0;: %1.</translation>
    </message>
    <message>
        <source>A step is worth what the lab says, else the points of its checks; a check that passes brings its points also where others fail. Points are rounded to the hundredth, halves up, once, after all else.</source>
        <translation>Une étape vaut ce que dit le TP, sinon les points de ses vérifications&#xa0;; une vérification réussie rapporte ses points même quand d&apos;autres échouent. Les points sont arrondis au centième, les moitiés vers le haut, une fois, après tout le reste.</translation>
    </message>
    <message>
        <source>Each day late that has begun takes %1 % of the points, at most %2 %.</source>
        <translation>Chaque jour de retard commencé retire %1&#xa0;% des points, au plus %2&#xa0;%.</translation>
    </message>
    <message>
        <source>Handing in late takes no points.</source>
        <translation>Rendre en retard ne retire pas de points.</translation>
    </message>
    <message>
        <source>For the teacher alone: this page has names. What students read of themselves is in the folder students.</source>
        <translation>Réservé à l&apos;enseignant&#xa0;: cette page contient des noms. Ce que les étudiants lisent sur eux-mêmes est dans le dossier students.</translation>
    </message>
    <message>
        <source>How it starts</source>
        <translation>Le départ</translation>
    </message>
    <message>
        <source>Free motion</source>
        <translation>Mouvement libre</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Parois</translation>
    </message>
    <message>
        <source>When two touch</source>
        <translation>Quand deux cercles se touchent</translation>
    </message>
    <message>
        <source>What a hit does</source>
        <translation>Ce que fait un choc</translation>
    </message>
    <message>
        <source>In the long run</source>
        <translation>À long terme</translation>
    </message>
    <message>
        <source>Students with a finding</source>
        <translation>Étudiants avec un constat</translation>
    </message>
    <message>
        <source>The program stops</source>
        <translation>Le programme s&apos;arrête</translation>
    </message>
    <message>
        <source>an example</source>
        <translation>un exemple</translation>
    </message>
    <message>
        <source>%1 of %2 do not pass</source>
        <translation>%1 sur %2 ne réussissent pas</translation>
    </message>
    <message>
        <source>Where the class stands</source>
        <translation>Où en est la classe</translation>
    </message>
    <message>
        <source>How many pass each step</source>
        <translation>Combien réussissent chaque étape</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>réussissent</translation>
    </message>
    <message>
        <source>do not pass yet</source>
        <translation>ne réussissent pas encore</translation>
    </message>
    <message>
        <source>not graded</source>
        <translation>non notés</translation>
    </message>
    <message>
        <source>not handed in</source>
        <translation>non rendus</translation>
    </message>
    <message>
        <source>What the class misunderstood</source>
        <translation>Ce que la classe a mal compris</translation>
    </message>
    <message>
        <source>Nothing was found.</source>
        <translation>Rien n&apos;a été trouvé.</translation>
    </message>
    <message>
        <source>How many students have a finding of that sort in that step; the stronger the colour, the larger their part of those who were judged. The examples are of one student each, without names and comments.</source>
        <translation>Combien d&apos;étudiants ont un constat de ce type à cette étape&#xa0;; plus la couleur est forte, plus grande est leur part parmi les évalués. Les exemples viennent d&apos;un étudiant chacun, sans noms ni commentaires.</translation>
    </message>
    <message>
        <source>Checks that tell nobody apart</source>
        <translation>Vérifications qui ne distinguent personne</translation>
    </message>
    <message>
        <source>In brackets: how many were judged by it.</source>
        <translation>Entre parenthèses&#xa0;: combien ont été évalués par elle.</translation>
    </message>
    <message>
        <source>Nobody passes</source>
        <translation>Personne ne réussit</translation>
    </message>
    <message>
        <source>Everybody passes</source>
        <translation>Tout le monde réussit</translation>
    </message>
    <message>
        <source>Checks and time on the way</source>
        <translation>Vérifications et temps en chemin</translation>
    </message>
    <message>
        <source>Of those who handed in a history, as it says itself. Minutes are those in which the program changed, without pauses of more than ten; who thinks on paper shows none. A history of commits alone tells no checks.</source>
        <translation>De ceux qui ont rendu un historique, d&apos;après celui-ci. Les minutes sont celles où le programme a changé, sans les pauses de plus de dix&#xa0;; qui réfléchit sur papier n&apos;en montre aucune. Un historique fait seulement de commits ne dit rien des vérifications.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Students</source>
        <translation>Étudiants</translation>
    </message>
    <message>
        <source>Checks, median</source>
        <translation>Vérifications, médiane</translation>
    </message>
    <message>
        <source>Checks, most</source>
        <translation>Vérifications, maximum</translation>
    </message>
    <message>
        <source>Minutes, median</source>
        <translation>Minutes, médiane</translation>
    </message>
    <message>
        <source>Programs that are alike</source>
        <translation>Programmes qui se ressemblent</translation>
    </message>
    <message>
        <source>Compared token by token, whatever their names, comments and order (winnowing). What the lab gives is left out, and so is what more than %1 students share. There are many good reasons for programs to be alike: working together where that is allowed, the same book, the same idea. A pair below proves nothing; read both, and ask.</source>
        <translation>Comparés mot par mot, quels que soient leurs noms, commentaires et ordre (winnowing). Ce que donne le TP est exclu, ainsi que ce que partagent plus de %1 étudiants. Il y a bien de bonnes raisons pour que des programmes se ressemblent&#xa0;: un travail en commun là où il est permis, le même livre, la même idée. Une paire citée ci-dessous ne prouve rien&#xa0;; lisez les deux, et posez la question.</translation>
    </message>
    <message>
        <source>There are none.</source>
        <translation>Il n&apos;y en a pas.</translation>
    </message>
    <message>
        <source>share %1 % of what the one with less has of their own</source>
        <translation>partagent %1&#xa0;% de ce que celui qui en a le moins a en propre</translation>
    </message>
    <message>
        <source>Who is where</source>
        <translation>Qui en est où</translation>
    </message>
    <message>
        <source>✓ passes, ○ does not pass yet, · not handed in, ? not graded</source>
        <translation>✓ réussie, ○ pas encore réussie, · non rendue, ? non notée</translation>
    </message>
    <message>
        <source>Student</source>
        <translation>Étudiant</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>réussies</translation>
    </message>
    <message>
        <source>points</source>
        <translation>points</translation>
    </message>
    <message>
        <source>this is the result of &quot;%1&quot;, whose file has another name</source>
        <translation>c&apos;est le résultat de «&#xa0;%1&#xa0;», dont le fichier porte un autre nom</translation>
    </message>
    <message>
        <source>the roster has %1 more than once</source>
        <translation>la liste contient %1 plus d&apos;une fois</translation>
    </message>
    <message>
        <source>%1 is not in the roster</source>
        <translation>%1 n&apos;est pas dans la liste</translation>
    </message>
    <message>
        <source>there are more than %1 files in it</source>
        <translation>il contient plus de %1 fichiers</translation>
    </message>
    <message>
        <source>a broken entry</source>
        <translation>une entrée corrompue</translation>
    </message>
    <message>
        <source>it holds absurdly much</source>
        <translation>le contenu est démesuré</translation>
    </message>
    <message>
        <source>this is no zip: %1</source>
        <translation>ce n&apos;est pas un zip&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 of %2 steps pass</source>
        <translation>étapes réussies&#xa0;: %1 sur %2</translation>
    </message>
    <message>
        <source>%1 not graded</source>
        <translation>%1 non notées</translation>
    </message>
    <message>
        <source>Nothing was handed in</source>
        <translation>Rien n&apos;a été rendu</translation>
    </message>
    <message>
        <source>and %1 more of that sort</source>
        <translation>et %1 autres du même genre</translation>
    </message>
    <message>
        <source>%1 was passed over for %2</source>
        <translation>%1 a été laissé de côté au profit de %2</translation>
    </message>
    <message>
        <source>nothing that was handed in is a program</source>
        <translation>rien de ce qui a été rendu n&apos;est un programme</translation>
    </message>
    <message>
        <source>%1 is not looked into; unpack it in its place</source>
        <translation>%1 n&apos;est pas examiné&#xa0;; décompressez-le à sa place</translation>
    </message>
    <message>
        <source>the history is too large to be looked at</source>
        <translation>l&apos;historique est trop grand pour être examiné</translation>
    </message>
    <message>
        <source>an object is right here</source>
        <translation>il faut ici un objet</translation>
    </message>
    <message>
        <source>%1 is right here</source>
        <translation>il faut ici %1</translation>
    </message>
    <message>
        <source>a text of at most %1 letters</source>
        <translation>un texte d&apos;au plus %1 caractères</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>un nombre de %1 à %2</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>un nombre entier de %1 à %2</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>a list of at most %1</source>
        <translation>une liste d&apos;au plus %1</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>judging took more than %1 s of processor time</source>
        <translation>l&apos;évaluation a pris plus de %1 s de temps de processeur</translation>
    </message>
    <message>
        <source>not judged: the program cannot be read</source>
        <translation>non évalué&#xa0;: le programme ne peut pas être lu</translation>
    </message>
    <message>
        <source>the lab has no step %1</source>
        <translation>le TP n&apos;a pas d&apos;étape %1</translation>
    </message>
    <message>
        <source>the file that was handed in cannot be read: %1</source>
        <translation>le fichier rendu ne peut pas être lu&#xa0;: %1</translation>
    </message>
    <message>
        <source>no %1</source>
        <translation>pas de %1</translation>
    </message>
    <message>
        <source>The program around line %1</source>
        <translation>Le programme autour de la ligne %1</translation>
    </message>
    <message>
        <source>this is no folder</source>
        <translation>ce n&apos;est pas un dossier</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>illisible&#xa0;: %1</translation>
    </message>
    <message>
        <source>this is a link that leads elsewhere; it is not followed</source>
        <translation>c&apos;est un lien qui mène ailleurs&#xa0;; il n&apos;est pas suivi</translation>
    </message>
    <message>
        <source>this is no plain file</source>
        <translation>ce n&apos;est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>this is no roster: its first line has neither a column &quot;id&quot; nor a column &quot;folder&quot;</source>
        <translation>ce n&apos;est pas une liste de classe&#xa0;: sa première ligne n&apos;a ni colonne «&#xa0;id&#xa0;» ni colonne «&#xa0;folder&#xa0;»</translation>
    </message>
    <message>
        <source>row %1 names nobody: it has neither an id nor a folder</source>
        <translation>la ligne %1 ne nomme personne&#xa0;: elle n&apos;a ni identifiant ni dossier</translation>
    </message>
    <message>
        <source>row %1: late days are a number from 0</source>
        <translation>ligne %1&#xa0;: les jours de retard sont un nombre à partir de 0</translation>
    </message>
    <message>
        <source>Judged by %1, version %2 of the lab, in scenes drawn for this student alone.</source>
        <translation>Évalué par %1, version %2 du TP, dans des scènes tirées au sort pour cet étudiant seul.</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 points sur %2</translation>
    </message>
    <message>
        <source>Steps that could not be graded: %1. There is no sum of points yet; that is not the fault of what was handed in.</source>
        <translation>Étapes qui n&apos;ont pas pu être notées&#xa0;: %1. Il n&apos;y a pas encore de total des points&#xa0;; ce n&apos;est pas la faute de ce qui a été rendu.</translation>
    </message>
    <message>
        <source>Days late, a begun one counted whole: %1. That takes %2 % of the points; the sum above has them taken off already.</source>
        <translation>Jours de retard, tout jour commencé comptant&#xa0;: %1. Cela retire %2&#xa0;% des points&#xa0;; le total ci-dessus en tient déjà compte.</translation>
    </message>
    <message>
        <source>What was handed in has the number %2, which the roster does not have for this student: it was judged with the values that are drawn by the number %1.</source>
        <translation>Ce qui a été rendu porte le numéro %2, qui n&apos;est pas celui de cet étudiant dans la liste&#xa0;: l&apos;évaluation s&apos;est faite avec les valeurs tirées du numéro %1.</translation>
    </message>
    <message>
        <source>The values of this lab were drawn by the number %1.</source>
        <translation>Les valeurs de ce TP ont été tirées du numéro %1.</translation>
    </message>
    <message>
        <source>✓ passes</source>
        <translation>✓ réussie</translation>
    </message>
    <message>
        <source>– not handed in</source>
        <translation>– non rendue</translation>
    </message>
    <message>
        <source>? not graded</source>
        <translation>? non notée</translation>
    </message>
    <message>
        <source>! stops with an error</source>
        <translation>! s&apos;arrête sur une erreur</translation>
    </message>
    <message>
        <source>○ does not pass yet</source>
        <translation>○ pas encore réussie</translation>
    </message>
    <message>
        <source>! cannot be read</source>
        <translation>! illisible</translation>
    </message>
    <message>
        <source>– of %1</source>
        <translation>– sur %1</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Nothing was handed in for this step.</source>
        <translation>Rien n&apos;a été rendu pour cette étape.</translation>
    </message>
    <message>
        <source>There is no verdict: this step counts neither as passed nor as failed.</source>
        <translation>Il n&apos;y a pas de verdict&#xa0;: cette étape ne compte ni comme réussie ni comme échouée.</translation>
    </message>
    <message numerus="yes">
        <source>Checked %n time(s) while working on it.</source>
        <translation>
            <numerusform>Vérifié %n fois pendant le travail.</numerusform>
            <numerusform>Vérifié %n fois pendant le travail.</numerusform>
        </translation>
    </message>
    <message>
        <source>The program stopped in step %1 of a scene, at %2 s.</source>
        <translation>Le programme s&apos;est arrêté au pas %1 d&apos;une scène, à %2 s.</translation>
    </message>
    <message>
        <source>The program does not load.</source>
        <translation>Le programme ne se charge pas.</translation>
    </message>
    <message>
        <source>The program stopped before its first step.</source>
        <translation>Le programme s&apos;est arrêté avant son premier pas.</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>There:</source>
        <translation>Là&#xa0;:</translation>
    </message>
    <message>
        <source>Look at line %1 of your program.</source>
        <translation>Regardez la ligne %1 de votre programme.</translation>
    </message>
    <message>
        <source>It is reached by the calls in line %1.</source>
        <translation>On y arrive par les appels de la ligne %1.</translation>
    </message>
    <message>
        <source>“%1” first goes wrong here, at %2 s.</source>
        <translation>«&#xa0;%1&#xa0;» échoue d&apos;abord ici, à %2 s.</translation>
    </message>
    <message>
        <source>“%1” goes wrong from the start.</source>
        <translation>«&#xa0;%1&#xa0;» échoue dès le début.</translation>
    </message>
    <message>
        <source>Scene: %1.</source>
        <translation>Scène&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The checks of this step</source>
        <translation>Les vérifications de cette étape</translation>
    </message>
    <message>
        <source>did not pass</source>
        <translation>pas réussie</translation>
    </message>
    <message>
        <source>there is no such aspect</source>
        <translation>cet aspect n&apos;existe pas</translation>
    </message>
    <message>
        <source>there is no such kind of error</source>
        <translation>ce type d&apos;erreur n&apos;existe pas</translation>
    </message>
    <message>
        <source>a colour like #1e90ff is right</source>
        <translation>il faut une couleur comme #1e90ff</translation>
    </message>
    <message>
        <source>there is no such status</source>
        <translation>cet état n&apos;existe pas</translation>
    </message>
    <message>
        <source>the status and the report say different things</source>
        <translation>l&apos;état et le rapport disent des choses différentes</translation>
    </message>
    <message>
        <source>the result is too large</source>
        <translation>le résultat est trop grand</translation>
    </message>
    <message>
        <source>this is no result of a student: %1</source>
        <translation>ce n&apos;est pas le résultat d&apos;un étudiant&#xa0;: %1</translation>
    </message>
    <message>
        <source>not a JSON object</source>
        <translation>pas un objet JSON</translation>
    </message>
    <message>
        <source>this is no secret: at least %1 letters are right</source>
        <translation>ce n&apos;est pas un secret&#xa0;: il faut au moins %1 caractères</translation>
    </message>
    <message>
        <source>no process to judge in can be started: %1</source>
        <translation>aucun processus d&apos;évaluation ne peut être lancé&#xa0;: %1</translation>
    </message>
    <message>
        <source>it has sent too much</source>
        <translation>il a trop envoyé</translation>
    </message>
    <message>
        <source>it has sent what it was not asked for</source>
        <translation>il a envoyé ce qu&apos;on ne lui demandait pas</translation>
    </message>
    <message>
        <source>it tried what no judgement needs, and was stopped</source>
        <translation>il a tenté ce dont aucune évaluation n&apos;a besoin, et a été arrêté</translation>
    </message>
    <message>
        <source>it was ended by signal %1</source>
        <translation>il a été terminé par le signal %1</translation>
    </message>
    <message>
        <source>it broke down</source>
        <translation>il est tombé en panne</translation>
    </message>
    <message>
        <source>of the names of Blackboard, what follows the last _ is taken for the account; a roster tells better</source>
        <translation>dans les noms de Blackboard, ce qui suit le dernier _ est pris pour le compte&#xa0;; une liste de la classe le dit mieux</translation>
    </message>
    <message>
        <source>of the names of Blackboard, what follows %1 is taken for the account; a roster tells better</source>
        <translation>dans les noms de Blackboard, ce qui suit %1 est pris pour le compte&#xa0;; une liste de la classe le dit mieux</translation>
    </message>
    <message>
        <source>%1: too large to be unpacked</source>
        <translation>%1&#xa0;: trop grand pour être décompressé</translation>
    </message>
    <message>
        <source>%1: left out %2</source>
        <translation>%1&#xa0;: laissé de côté&#xa0;: %2</translation>
    </message>
    <message>
        <source>names that are in it more than once</source>
        <translation>des noms qui s&apos;y trouvent plus d&apos;une fois</translation>
    </message>
    <message>
        <source>this is the zip of a whole class; grade the zip itself</source>
        <translation>c&apos;est le zip de toute une classe&#xa0;; évaluez le zip lui-même</translation>
    </message>
    <message>
        <source>cannot be unpacked: %1</source>
        <translation>impossible à décompresser&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>HandIn</name>
    <message>
        <source>the work cannot be put there</source>
        <translation>le travail ne peut pas être mis là</translation>
    </message>
    <message>
        <source>this is no folder with a student&apos;s work</source>
        <translation>ce n&apos;est pas un dossier avec le travail d&apos;un étudiant</translation>
    </message>
    <message>
        <source>this is no work that was handed in: there is no manifest.json of format 1 in it</source>
        <translation>ce n&apos;est pas un travail rendu&#xa0;: il n&apos;y a pas dedans de manifest.json au format 1</translation>
    </message>
    <message>
        <source>this file is not in the manifest</source>
        <translation>ce fichier n&apos;est pas dans le manifeste</translation>
    </message>
    <message>
        <source>this file was changed after it was handed in</source>
        <translation>ce fichier a été modifié après avoir été rendu</translation>
    </message>
    <message>
        <source>this file is missing</source>
        <translation>ce fichier manque</translation>
    </message>
</context>
<context>
    <name>HandleDrag</name>
    <message numerus="yes">
        <source>Move %n circles</source>
        <translation>
            <numerusform>Déplacer %n cercle</numerusform>
            <numerusform>Déplacer %n cercles</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer&#xa0;: %1</translation>
    </message>
    <message numerus="yes">
        <source>Change velocities of %n circles</source>
        <translation>
            <numerusform>Changer la vitesse de %n cercle</numerusform>
            <numerusform>Changer les vitesses de %n cercles</numerusform>
        </translation>
    </message>
    <message>
        <source>Change velocity of %1</source>
        <translation>Changer la vitesse&#xa0;: %1</translation>
    </message>
    <message>
        <source>changed by %1 m/s</source>
        <translation>changée de %1 m/s</translation>
    </message>
    <message>
        <source>%1 m/s, speed %2 m/s</source>
        <translation>%1 m/s, norme %2 m/s</translation>
    </message>
    <message>
        <source>moved by %1 m</source>
        <translation>déplacé de %1 m</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>HitNote</name>
    <message>
        <source>%1: %2</source>
        <comment>title, rows</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>before</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>after</source>
        <translation>après</translation>
    </message>
    <message>
        <source>change</source>
        <translation>changement</translation>
    </message>
    <message>
        <source>%1 before %2, after %3, change %4 %5</source>
        <comment>who, three numbers, unit</comment>
        <translation>%1&#xa0;: avant %2, après %3, changement %4 %5</translation>
    </message>
    <message>
        <source>Hit %1 · %2 s</source>
        <translation>Choc %1 · %2 s</translation>
    </message>
    <message>
        <source> · first of %1</source>
        <translation> · premier de %1</translation>
    </message>
    <message>
        <source>both</source>
        <translation>les deux</translation>
    </message>
</context>
<context>
    <name>HitParts</name>
    <message>
        <source>before %1</source>
        <translation>avant %1</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>après %1</translation>
    </message>
    <message>
        <source>n</source>
        <comment>the normal vector</comment>
        <translation>n</translation>
    </message>
    <message>
        <source>across %1</source>
        <translation>tangentielle %1</translation>
    </message>
    <message>
        <source>along %1</source>
        <translation>normale %1</translation>
    </message>
</context>
<context>
    <name>LabArchive</name>
    <message>
        <source>the lab cannot be put there</source>
        <translation>le TP ne peut pas être mis là</translation>
    </message>
    <message>
        <source>the lab cannot be packed: %1</source>
        <translation>le TP ne peut pas être archivé&#xa0;: %1</translation>
    </message>
    <message>
        <source>there is no lab.json</source>
        <translation>il n&apos;y a pas de lab.json</translation>
    </message>
    <message>
        <source>there are %1 files in it; at most %2 are right</source>
        <translation>il contient %1 fichiers&#xa0;; au plus %2 conviennent</translation>
    </message>
    <message>
        <source>the name is not in UTF-8, which would be right</source>
        <translation>le nom n&apos;est pas en UTF-8&#xa0;; il faut de l&apos;UTF-8</translation>
    </message>
    <message>
        <source>this is a link or a special file; a plain file is right</source>
        <translation>c&apos;est un lien ou un fichier spécial&#xa0;; il faut un fichier ordinaire</translation>
    </message>
    <message>
        <source>this is encrypted; a file without a password is right</source>
        <translation>c&apos;est chiffré&#xa0;; il faut un fichier sans mot de passe</translation>
    </message>
    <message>
        <source>the file is too large; at most %1 are right</source>
        <translation>le fichier est trop grand&#xa0;; au plus %1 conviennent</translation>
    </message>
    <message>
        <source>this unpacks to more than %1 times its size, as no honest file does</source>
        <translation>cela se décompresse en plus de %1 fois sa taille, comme aucun fichier honnête</translation>
    </message>
    <message>
        <source>all of it is too large; at most %1 are right</source>
        <translation>le tout est trop grand&#xa0;; au plus %1 conviennent</translation>
    </message>
    <message>
        <source>the name is there twice (but for capital letters); a name of its own is right</source>
        <translation>le nom y est deux fois (aux majuscules près)&#xa0;; il faut un autre nom</translation>
    </message>
    <message>
        <source>this unpacks to another size than it says</source>
        <translation>cela se décompresse en une autre taille qu&apos;annoncé</translation>
    </message>
    <message>
        <source>this is broken or packed in an unknown way</source>
        <translation>c&apos;est corrompu ou compressé d&apos;une façon inconnue</translation>
    </message>
    <message>
        <source>there is no %1 in it</source>
        <translation>il ne contient pas de %1</translation>
    </message>
    <message>
        <source>this is no archive: %1</source>
        <translation>ce n&apos;est pas une archive&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>LabEdits</name>
    <message>
        <source>&quot;%1&quot; cannot be the name of a step; letters, digits, dashes and underscores are right</source>
        <translation>«&#xa0;%1&#xa0;» ne peut pas être le nom d&apos;une étape&#xa0;; lettres, chiffres, traits d&apos;union et tirets bas conviennent</translation>
    </message>
    <message>
        <source>the lab has a folder %1 already</source>
        <translation>le TP a déjà un dossier %1</translation>
    </message>
    <message>
        <source>the lab has no step in the folder %1</source>
        <translation>le TP n&apos;a pas d&apos;étape dans le dossier %1</translation>
    </message>
    <message>
        <source>the lab has translations into this language; its own texts are in another</source>
        <translation>le TP a des traductions dans cette langue&#xa0;; ses propres textes sont dans une autre</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be the name of a program; letters, digits, dots, dashes and underscores are right</source>
        <translation>«&#xa0;%1&#xa0;» ne peut pas être le nom d&apos;un programme&#xa0;; lettres, chiffres, points, traits d&apos;union et tirets bas conviennent</translation>
    </message>
    <message>
        <source>the step has a program of this name already</source>
        <translation>l&apos;étape a déjà un programme de ce nom</translation>
    </message>
    <message>
        <source>there is no such program</source>
        <translation>ce programme n&apos;existe pas</translation>
    </message>
    <message>
        <source>cannot be read: there is no such file</source>
        <translation>illisible&#xa0;: ce fichier n&apos;existe pas</translation>
    </message>
</context>
<context>
    <name>LabFiles</name>
    <message>
        <source>this is a link that leads to no file of the lab; a file of its own is right</source>
        <translation>c&apos;est un lien qui ne mène à aucun fichier du TP&#xa0;; il faut un vrai fichier</translation>
    </message>
    <message>
        <source>this is a folder; a file is right</source>
        <translation>c&apos;est un dossier&#xa0;; il faut un fichier</translation>
    </message>
    <message>
        <source>folders are nested too deeply; at most %1 are right</source>
        <translation>les dossiers sont trop imbriqués&#xa0;; au plus %1 conviennent</translation>
    </message>
    <message>
        <source>this is neither a file nor a folder</source>
        <translation>ce n&apos;est ni un fichier ni un dossier</translation>
    </message>
    <message>
        <source>the file is too large; at most %1 are right</source>
        <translation>le fichier est trop grand&#xa0;; au plus %1 conviennent</translation>
    </message>
    <message>
        <source>the lab is too large from here on; at most %1 files and %2 are right</source>
        <translation>le TP est trop grand à partir d&apos;ici&#xa0;; au plus %1 fichiers et %2 conviennent</translation>
    </message>
    <message>
        <source>a path that stays in the lab is right, of names that do not begin with a dot</source>
        <translation>il faut un chemin qui reste dans le TP, fait de noms ne commençant pas par un point</translation>
    </message>
    <message>
        <source>the name is too long; at most %1 characters are right</source>
        <translation>le nom est trop long&#xa0;; au plus %1 caractères conviennent</translation>
    </message>
    <message>
        <source>a name without \ : * ? &quot; &lt; &gt; | and without control characters is right</source>
        <translation>il faut un nom sans \&#xa0;: *&#xa0;? &quot; &lt; &gt; | et sans caractères de contrôle</translation>
    </message>
    <message>
        <source>%1 names a device on some systems; another name is right</source>
        <translation>%1 désigne un périphérique sur certains systèmes&#xa0;; il faut un autre nom</translation>
    </message>
    <message>
        <source>a name that ends with a letter or a digit is right</source>
        <translation>il faut un nom qui se termine par une lettre ou un chiffre</translation>
    </message>
    <message>
        <source>cannot be read: there is no such folder</source>
        <translation>illisible&#xa0;: ce dossier n&apos;existe pas</translation>
    </message>
    <message>
        <source>cannot be read: the folder may not be opened</source>
        <translation>illisible&#xa0;: le dossier ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>cannot be read: there is no such file</source>
        <translation>illisible&#xa0;: ce fichier n&apos;existe pas</translation>
    </message>
    <message>
        <source>a link here leads out of the lab; a file or folder of its own is right</source>
        <translation>un lien mène ici hors du TP&#xa0;; il faut un vrai fichier ou dossier</translation>
    </message>
    <message>
        <source>another file has this name but for capital letters; a name of its own is right</source>
        <translation>un autre fichier a ce nom aux majuscules près&#xa0;; il faut un autre nom</translation>
    </message>
    <message>
        <source>another program changed %1 since the lab was read</source>
        <translation>un autre programme a modifié %1 depuis que le TP a été lu</translation>
    </message>
    <message>
        <source>the picture has %1 × %2 pixels; at most %3 million are right</source>
        <translation>l&apos;image a %1 × %2 pixels&#xa0;; au plus %3 millions conviennent</translation>
    </message>
</context>
<context>
    <name>LabMenu</name>
    <message>
        <source>&amp;Labs</source>
        <translation>&amp;Liste des TP</translation>
    </message>
</context>
<context>
    <name>LabReader</name>
    <message>
        <source>still the text of the template: %1</source>
        <translation>encore le texte du modèle&#xa0;: %1</translation>
    </message>
    <message>
        <source>not in this language yet: %1</source>
        <translation>pas encore dans cette langue&#xa0;: %1</translation>
    </message>
    <message>
        <source>the program is there whole, too; one of the two files is right</source>
        <translation>le programme est aussi là en entier&#xa0;; il faut un seul des deux fichiers</translation>
    </message>
    <message>
        <source>the program begins without a comment; what the student should read of it stands there</source>
        <translation>le programme commence sans commentaire&#xa0;; c&apos;est là qu&apos;est ce que l&apos;étudiant doit en lire</translation>
    </message>
    <message>
        <source>another step has the id %1 already; an id of its own is right</source>
        <translation>une autre étape a déjà l&apos;id %1&#xa0;; il faut un autre id</translation>
    </message>
    <message>
        <source>the step %1 is listed already; each step once is right</source>
        <translation>l&apos;étape %1 est déjà dans la liste&#xa0;; chaque étape doit y être une seule fois</translation>
    </message>
    <message>
        <source>the file is too large; at most %1 are right</source>
        <translation>le fichier est trop grand&#xa0;; au plus %1 conviennent</translation>
    </message>
    <message>
        <source>cannot be read: there is no such file</source>
        <translation>illisible&#xa0;: ce fichier n&apos;existe pas</translation>
    </message>
    <message>
        <source>the text is not in UTF-8, which would be right; some letters are lost</source>
        <translation>le texte n&apos;est pas en UTF-8, comme il le faudrait&#xa0;; quelques lettres sont perdues</translation>
    </message>
    <message>
        <source>the text has characters that are none (NUL); a text in UTF-8 is right</source>
        <translation>le texte a des caractères qui n&apos;en sont pas (NUL)&#xa0;; il faut un texte en UTF-8</translation>
    </message>
    <message>
        <source>a number from 1 to %1, for there are so many answers, is right</source>
        <translation>il faut un nombre de 1 à %1, car il y a autant de réponses</translation>
    </message>
    <message>
        <source>%1 answers, as many as the task.json has, are right, not %2; the question is shown untranslated</source>
        <translation>il faut %1 réponses, autant qu&apos;en a task.json, pas %2&#xa0;; la question est montrée sans traduction</translation>
    </message>
    <message>
        <source>a name of letters, digits and underscores that means nothing else is right</source>
        <translation>il faut un nom fait de lettres, de chiffres et de tirets bas, qui ne désigne rien d&apos;autre</translation>
    </message>
    <message>
        <source>a range from the least to the most, with a step that is greater than 0, is right</source>
        <translation>il faut un intervalle du minimum au maximum, avec un pas supérieur à 0</translation>
    </message>
    <message>
        <source>of what the step has not: %1</source>
        <translation>de ce que l&apos;étape n&apos;a pas&#xa0;: %1</translation>
    </message>
    <message>
        <source>not in this language yet: the starter&apos;s comments</source>
        <translation>pas encore dans cette langue&#xa0;: les commentaires du programme de départ</translation>
    </message>
    <message>
        <source>its code is not that of starter.lua; a starter in another language differs in comments alone</source>
        <translation>son code n&apos;est pas celui de starter.lua&#xa0;; un programme de départ dans une autre langue n&apos;en diffère que par les commentaires</translation>
    </message>
    <message>
        <source>there is no picture %1 in the step&apos;s folder</source>
        <translation>il n&apos;y a pas d&apos;image %1 dans le dossier de l&apos;étape</translation>
    </message>
    <message>
        <source>&lt;!-- %1 --&gt; begins no part; explore, code and all do</source>
        <translation>&lt;!-- %1 --&gt; ne commence aucune partie&#xa0;; explore, code et all le font</translation>
    </message>
</context>
<context>
    <name>LabReport</name>
    <message>
        <source>The scene at %1 s</source>
        <translation>La scène à %1 s</translation>
    </message>
    <message>
        <source>Checks: %1</source>
        <translation>Vérifications&#xa0;: %1</translation>
    </message>
    <message>
        <source>You have written a physics engine</source>
        <translation>Vous avez écrit un moteur physique</translation>
    </message>
    <message>
        <source>%1 of %2 steps pass, judged anew a moment ago.</source>
        <translation>Étapes réussies&#xa0;: %1 sur %2, évaluées à nouveau à l&apos;instant.</translation>
    </message>
    <message>
        <source>What took the most checks</source>
        <translation>Ce qui a demandé le plus de vérifications</translation>
    </message>
    <message>
        <source>The energy of all runs</source>
        <translation>L&apos;énergie de toutes les exécutions</translation>
    </message>
    <message>
        <source>At %1 s, when two circles first meet</source>
        <translation>À %1 s, à la première rencontre de deux cercles</translation>
    </message>
    <message>
        <source>At %1 s, when a circle first reaches a wall</source>
        <translation>À %1 s, quand un cercle atteint une paroi pour la première fois</translation>
    </message>
    <message>
        <source>At %1 s</source>
        <translation>À %1 s</translation>
    </message>
    <message>
        <source>not sure</source>
        <translation>je ne sais pas</translation>
    </message>
    <message>
        <source>%1 of %2 steps pass. Every step was judged anew for this report, by version %3 of the lab.</source>
        <translation>Étapes réussies&#xa0;: %1 sur %2. Chaque étape a été évaluée à nouveau pour ce rapport, par la version %3 du TP.</translation>
    </message>
    <message>
        <source>To the teacher</source>
        <translation>À l&apos;enseignant</translation>
    </message>
    <message>
        <source>✓ passes</source>
        <translation>✓ réussie</translation>
    </message>
    <message>
        <source>does not pass yet</source>
        <translation>pas encore réussie</translation>
    </message>
    <message>
        <source>stops with an error</source>
        <translation>s&apos;arrête sur une erreur</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>pas faite</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>Found on the way</source>
        <translation>Trouvé en chemin</translation>
    </message>
    <message>
        <source>Expected and found</source>
        <translation>Prédit et observé</translation>
    </message>
    <message>
        <source>Expected: %1</source>
        <translation>Prédit&#xa0;: %1</translation>
    </message>
    <message>
        <source>The run</source>
        <translation>L&apos;exécution</translation>
    </message>
    <message>
        <source>What changed in the program</source>
        <translation>Ce qui a changé dans le programme</translation>
    </message>
    <message>
        <source>Nothing: it is the program of the step before.</source>
        <translation>Rien&#xa0;: c&apos;est le programme de l&apos;étape précédente.</translation>
    </message>
    <message>
        <source>… and more, which no page holds.</source>
        <translation>… et d&apos;autres, qu&apos;aucune page ne contient.</translation>
    </message>
    <message>
        <source>Looking back</source>
        <translation>Rétrospective</translation>
    </message>
    <message>
        <source>The energy of the runs above in one chart, each as a part of what it started with. A law that keeps energy draws a straight line at 1; what lies above was made by the program, what lies below was lost.</source>
        <translation>L&apos;énergie des exécutions ci-dessus dans un seul graphique, chacune en part de son énergie de départ. Une loi qui conserve l&apos;énergie trace une droite à 1&#xa0;; ce qui est au-dessus a été créé par le programme, ce qui est au-dessous a été perdu.</translation>
    </message>
    <message>
        <source>Momentum of all circles, kg m/s</source>
        <translation>Quantité de mouvement de tous les cercles, kg m/s</translation>
    </message>
    <message>
        <source>Energy of all circles, J</source>
        <translation>Énergie de tous les cercles, J</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>cinétique</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>potentielle</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>somme</translation>
    </message>
    <message>
        <source>Energy as a part of that at the start</source>
        <translation>Énergie en part de celle du départ</translation>
    </message>
    <message>
        <source>What happens: %1</source>
        <translation>Ce qui se passe&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>LabSearch</name>
    <message>
        <source>this file is broken, so nothing can be replaced in it, and nothing was replaced elsewhere; mend it first</source>
        <translation>ce fichier est abîmé&#xa0;: rien ne peut y être remplacé, et rien n&apos;a été remplacé ailleurs&#xa0;; réparez-le d&apos;abord</translation>
    </message>
</context>
<context>
    <name>LabVerifier</name>
    <message>
        <source>stops with an error at line %1: %2</source>
        <translation>s&apos;arrête sur une erreur à la ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>passes; a starter should fail by a check</source>
        <translation>réussit&#xa0;; un programme de départ doit échouer à une vérification</translation>
    </message>
    <message>
        <source>fails with seed %1 by %2</source>
        <translation>échoue avec la graine %1 à %2</translation>
    </message>
    <message>
        <source>passes; a mistake should fail by a check</source>
        <translation>réussit&#xa0;; une erreur doit échouer à une vérification</translation>
    </message>
    <message>
        <source>is not recognised</source>
        <translation>n&apos;est pas reconnue</translation>
    </message>
    <message>
        <source>is taken for %1</source>
        <translation>est prise pour %1</translation>
    </message>
    <message>
        <source>fails by %1; work that gets a remark passes</source>
        <translation>échoue à %1&#xa0;; un travail qui reçoit une appréciation réussit</translation>
    </message>
    <message>
        <source>the check %1 asks for the same as %2</source>
        <translation>la vérification %1 demande la même chose que %2</translation>
    </message>
    <message>
        <source>no mistake fails by the check %1 alone: it repeats %2</source>
        <translation>aucune erreur n&apos;échoue à la seule vérification %1&#xa0;: elle répète %2</translation>
    </message>
    <message>
        <source>%1 differs in more than its mistake: it has “%2” where the solution has “%3”</source>
        <translation>%1 diffère par plus que son erreur&#xa0;: il y a «&#xa0;%2&#xa0;» là où le corrigé a «&#xa0;%3&#xa0;»</translation>
    </message>
    <message>
        <source>there is no solution.lua</source>
        <translation>il n&apos;y a pas de solution.lua</translation>
    </message>
    <message>
        <source>no mistake fails the check %1</source>
        <translation>aucune erreur n&apos;échoue à la vérification %1</translation>
    </message>
    <message>
        <source>the check %1 allows %2, and the solution itself is off by %3 (%4): other right programs may fail; at least %5 is right</source>
        <translation>la vérification %1 admet %2, et le corrigé lui-même s&apos;écarte de %3 (%4)&#xa0;: d&apos;autres programmes justes peuvent échouer&#xa0;; il faut au moins %5</translation>
    </message>
    <message>
        <source>fails what is turned, too fast, adrift by</source>
        <translation>met en échec ce qui est tourné, trop rapide, décalé de</translation>
    </message>
    <message>
        <source>with %1 seeds</source>
        <translation>avec %1 graines</translation>
    </message>
    <message>
        <source>with the values of the student %1: %2</source>
        <translation>avec les valeurs de l&apos;étudiant %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>is not judged by the check %1: %2</source>
        <translation>n&apos;est pas évalué par la vérification %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2 of %3 values, %4 to %5</source>
        <comment>of a range</comment>
        <translation>%1&#xa0;: %2 valeurs sur %3, de %4 à %5</translation>
    </message>
    <message>
        <source>the question %1 asks for %2, and its tolerance is 0: nobody answers it rightly</source>
        <translation>la question %1 demande %2 et sa tolérance est 0&#xa0;: personne n&apos;y répond juste</translation>
    </message>
    <message>
        <source>in the language %1: %2</source>
        <translation>dans la langue %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>LawNames</name>
    <message>
        <source>None</source>
        <comment>law for walls</comment>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Reflect</source>
        <translation>Réflexion</translation>
    </message>
    <message>
        <source>None</source>
        <comment>law for circles</comment>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêt</translation>
    </message>
    <message>
        <source>Swap velocities</source>
        <translation>Échange des vitesses</translation>
    </message>
    <message>
        <source>Swap normal parts</source>
        <translation>Échange normal</translation>
    </message>
    <message>
        <source>Impulse</source>
        <translation>Impulsion</translation>
    </message>
    <message>
        <source>Discrete</source>
        <translation>Discret</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Continu</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exact</translation>
    </message>
    <message>
        <source>Euler</source>
        <translation>Euler</translation>
    </message>
    <message>
        <source>Symplectic Euler</source>
        <translation>Euler symplectique</translation>
    </message>
    <message>
        <source>Velocity Verlet</source>
        <translation>Verlet vitesse</translation>
    </message>
    <message>
        <source>Runge-Kutta 4</source>
        <translation>Runge-Kutta 4</translation>
    </message>
    <message>
        <source>S. Euler</source>
        <comment>short for Symplectic Euler</comment>
        <translation>Euler s.</translation>
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
        <translation>pesanteur</translation>
    </message>
    <message>
        <source>restitution</source>
        <translation>restitution</translation>
    </message>
    <message>
        <source>timestep</source>
        <translation>pas de temps</translation>
    </message>
    <message>
        <source>half width of the square</source>
        <translation>demi-largeur du carré</translation>
    </message>
    <message>
        <source>law for walls</source>
        <translation>loi des parois</translation>
    </message>
    <message>
        <source>law for circles</source>
        <translation>loi des cercles</translation>
    </message>
    <message>
        <source>timing</source>
        <translation>traitement du temps</translation>
    </message>
    <message>
        <source>number of circles</source>
        <translation>nombre de cercles</translation>
    </message>
    <message>
        <source>position of %1</source>
        <translation>position (%1)</translation>
    </message>
    <message>
        <source>velocity of %1</source>
        <translation>vitesse (%1)</translation>
    </message>
    <message>
        <source>radius of %1</source>
        <translation>rayon (%1)</translation>
    </message>
    <message>
        <source>density of %1</source>
        <translation>masse volumique (%1)</translation>
    </message>
    <message>
        <source>integrator of %1</source>
        <translation>intégrateur (%1)</translation>
    </message>
    <message>
        <source>mass of %1</source>
        <translation>masse (%1)</translation>
    </message>
    <message>
        <source>circle %1</source>
        <translation>cercle %1</translation>
    </message>
    <message>
        <source>Fixed in this step: %1</source>
        <translation>Imposé à cette étape&#xa0;: %1</translation>
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
        <translation>C&apos;est vous qui l&apos;écrivez&#xa0;: s&apos;exécute une fois, avant le premier pas</translation>
    </message>
    <message>
        <source>You write it: moves the circles by one step of timestep seconds</source>
        <translation>C&apos;est vous qui l&apos;écrivez&#xa0;: déplace les cercles d&apos;un pas de timestep secondes</translation>
    </message>
    <message>
        <source>A new vector; its unit is that of its numbers</source>
        <translation>Un nouveau vecteur&#xa0;; son unité est celle de ses nombres</translation>
    </message>
    <message>
        <source>The dot product of two vectors: a.x * b.x + a.y * b.y</source>
        <translation>Le produit scalaire de deux vecteurs&#xa0;: a.x * b.x + a.y * b.y</translation>
    </message>
    <message>
        <source>The first circle</source>
        <translation>Le premier cercle</translation>
    </message>
    <message>
        <source>The second circle</source>
        <translation>Le second cercle</translation>
    </message>
    <message>
        <source>All circles: circles[1] to circles[#circles]</source>
        <translation>Tous les cercles&#xa0;: circles[1] à circles[#circles]</translation>
    </message>
    <message>
        <source>The acceleration of every circle, a vector in m/s²; may be set in on_load</source>
        <translation>L&apos;accélération de chaque cercle, un vecteur en m/s²&#xa0;; peut être fixée dans on_load</translation>
    </message>
    <message>
        <source>From 0 (no rebound) to 1 (elastic); may be set in on_load</source>
        <translation>De 0 (aucun rebond) à 1 (élastique)&#xa0;; peut être fixé dans on_load</translation>
    </message>
    <message>
        <source>The box that the circles are in</source>
        <translation>La boîte dans laquelle sont les cercles</translation>
    </message>
    <message>
        <source>Seconds since the start of the run, at the start of this step</source>
        <translation>Secondes depuis le début de l&apos;exécution, au début de ce pas</translation>
    </message>
    <message>
        <source>The number of steps made so far</source>
        <translation>Le nombre de pas faits jusqu&apos;ici</translation>
    </message>
    <message>
        <source>Adds a point of this step to the curve called name in the charts</source>
        <translation>Ajoute un point de ce pas à la courbe nommée name dans les graphiques</translation>
    </message>
    <message>
        <source>Draws over the scene, for this step</source>
        <translation>Dessine par-dessus la scène, pour ce pas</translation>
    </message>
    <message>
        <source>Writes a line to the console</source>
        <translation>Écrit une ligne dans la console</translation>
    </message>
    <message>
        <source>Functions of numbers</source>
        <translation>Fonctions de nombres</translation>
    </message>
    <message>
        <source>Functions of texts</source>
        <translation>Fonctions de textes</translation>
    </message>
    <message>
        <source>Functions of lists</source>
        <translation>Fonctions de listes</translation>
    </message>
    <message>
        <source>For a loop over a list in order: for i, v in ipairs(list) do</source>
        <translation>Pour une boucle sur une liste, dans l&apos;ordre&#xa0;: for i, v in ipairs(list) do</translation>
    </message>
    <message>
        <source>For a loop over all fields of a table: for k, v in pairs(t) do</source>
        <translation>Pour une boucle sur tous les champs d&apos;une table&#xa0;: for k, v in pairs(t) do</translation>
    </message>
    <message>
        <source>The arguments from number n on; with &apos;#&apos; how many there are</source>
        <translation>Les arguments à partir du numéro n&#xa0;; avec &apos;#&apos;, combien il y en a</translation>
    </message>
    <message>
        <source>What a value is, as a text: &quot;number&quot;, &quot;vector&quot;, &quot;circle&quot; …</source>
        <translation>Ce qu&apos;est une valeur, sous forme de texte&#xa0;: &quot;number&quot;, &quot;vector&quot;, &quot;circle&quot; …</translation>
    </message>
    <message>
        <source>A value as a text</source>
        <translation>Une valeur sous forme de texte</translation>
    </message>
    <message>
        <source>The number that a text says, or nil; base is 10 unless given</source>
        <translation>Le nombre que dit un texte, ou nil&#xa0;; base vaut 10 par défaut</translation>
    </message>
    <message>
        <source>Stops the run with the message if value is false or nil</source>
        <translation>Arrête l&apos;exécution avec le message si la valeur est false ou nil</translation>
    </message>
    <message>
        <source>Stops the run at this line with the message</source>
        <translation>Arrête l&apos;exécution à cette ligne avec le message</translation>
    </message>
    <message>
        <source>Calls f: true and its results, or false and the error</source>
        <translation>Appelle f&#xa0;: true et ses résultats, ou false et l&apos;erreur</translation>
    </message>
    <message>
        <source>The length of the vector</source>
        <translation>La longueur du vecteur</translation>
    </message>
    <message>
        <source>The square of the length: v:dot(v)</source>
        <translation>Le carré de la longueur&#xa0;: v:dot(v)</translation>
    </message>
    <message>
        <source>The vector of length 1 with the same direction; an error for (0, 0)</source>
        <translation>Le vecteur de longueur 1 et de même direction&#xa0;; une erreur pour (0, 0)</translation>
    </message>
    <message>
        <source>The dot product with another vector</source>
        <translation>Le produit scalaire avec un autre vecteur</translation>
    </message>
    <message>
        <source>The vector turned left by 90°: (-y, x)</source>
        <translation>Le vecteur tourné de 90° vers la gauche&#xa0;: (-y, x)</translation>
    </message>
    <message>
        <source>The part to the right; to change it, build a new vector</source>
        <translation>La composante vers la droite&#xa0;; pour la changer, construisez un nouveau vecteur</translation>
    </message>
    <message>
        <source>The part upwards; to change it, build a new vector</source>
        <translation>La composante vers le haut&#xa0;; pour la changer, construisez un nouveau vecteur</translation>
    </message>
    <message>
        <source>The centre, a vector in m</source>
        <translation>Le centre, un vecteur en m</translation>
    </message>
    <message>
        <source>A vector in m/s</source>
        <translation>Un vecteur en m/s</translation>
    </message>
    <message>
        <source>In m, above 0</source>
        <translation>En m, supérieur à 0</translation>
    </message>
    <message>
        <source>In 1000 kg/m³, above 0: steel has 7.8</source>
        <translation>En 1000 kg/m³, supérieure à 0&#xa0;: l&apos;acier a 7.8</translation>
    </message>
    <message>
        <source>The number of the circle, from 1; cannot be set</source>
        <translation>Le numéro du cercle, à partir de 1&#xa0;; ne peut pas être changé</translation>
    </message>
    <message>
        <source>Half the side of the box, in m</source>
        <translation>La moitié du côté de la boîte, en m</translation>
    </message>
    <message>
        <source>The x of the left wall, in m</source>
        <translation>Le x de la paroi gauche, en m</translation>
    </message>
    <message>
        <source>The x of the right wall, in m</source>
        <translation>Le x de la paroi droite, en m</translation>
    </message>
    <message>
        <source>The y of the floor, in m</source>
        <translation>Le y du sol, en m</translation>
    </message>
    <message>
        <source>The y of the ceiling, in m</source>
        <translation>Le y du plafond, en m</translation>
    </message>
    <message>
        <source>An arrow that begins at from; colour and label may be left out</source>
        <translation>Une flèche qui commence en from&#xa0;; la couleur et l&apos;étiquette sont facultatives</translation>
    </message>
    <message>
        <source>A line between two points; the colour may be left out</source>
        <translation>Un segment entre deux points&#xa0;; la couleur est facultative</translation>
    </message>
    <message>
        <source>A dot; the colour may be left out</source>
        <translation>Un point&#xa0;; la couleur est facultative</translation>
    </message>
    <message>
        <source>A text at a point</source>
        <translation>Un texte en un point</translation>
    </message>
    <message>
        <source>x without its sign</source>
        <translation>x sans son signe</translation>
    </message>
    <message>
        <source>The angle whose cosine is x, in radians</source>
        <translation>L&apos;angle dont le cosinus est x, en radians</translation>
    </message>
    <message>
        <source>The angle whose sine is x, in radians</source>
        <translation>L&apos;angle dont le sinus est x, en radians</translation>
    </message>
    <message>
        <source>The angle of the direction (x, y), in radians; x is 1 unless given</source>
        <translation>L&apos;angle de la direction (x, y), en radians&#xa0;; x vaut 1 par défaut</translation>
    </message>
    <message>
        <source>The next whole number that is not below x</source>
        <translation>Le plus petit entier qui n&apos;est pas inférieur à x</translation>
    </message>
    <message>
        <source>The cosine of an angle in radians</source>
        <translation>Le cosinus d&apos;un angle en radians</translation>
    </message>
    <message>
        <source>Radians in degrees</source>
        <translation>Des radians en degrés</translation>
    </message>
    <message>
        <source>e to the power of x</source>
        <translation>e à la puissance x</translation>
    </message>
    <message>
        <source>The next whole number that is not above x</source>
        <translation>Le plus grand entier qui n&apos;est pas supérieur à x</translation>
    </message>
    <message>
        <source>What is left of x divided by y, with the sign of x</source>
        <translation>Ce qui reste de x divisé par y, avec le signe de x</translation>
    </message>
    <message>
        <source>Infinity: more than any number</source>
        <translation>L&apos;infini&#xa0;: plus que tout nombre</translation>
    </message>
    <message>
        <source>The logarithm of x; base is e unless given</source>
        <translation>Le logarithme de x&#xa0;; base vaut e par défaut</translation>
    </message>
    <message>
        <source>The largest of the numbers</source>
        <translation>Le plus grand des nombres</translation>
    </message>
    <message>
        <source>The largest whole number of Lua</source>
        <translation>Le plus grand entier de Lua</translation>
    </message>
    <message>
        <source>The smallest of the numbers</source>
        <translation>Le plus petit des nombres</translation>
    </message>
    <message>
        <source>The smallest whole number of Lua</source>
        <translation>Le plus petit entier de Lua</translation>
    </message>
    <message>
        <source>The whole part of x, and the rest</source>
        <translation>La partie entière de x, et le reste</translation>
    </message>
    <message>
        <source>3.14159…</source>
        <translation>3.14159…</translation>
    </message>
    <message>
        <source>Degrees in radians</source>
        <translation>Des degrés en radians</translation>
    </message>
    <message>
        <source>From 0 up to 1, or a whole number from m to n; the same in every run</source>
        <translation>De 0 à 1 exclu, ou un entier de m à n&#xa0;; les mêmes à chaque exécution</translation>
    </message>
    <message>
        <source>Begins another row of random numbers</source>
        <translation>Commence une autre suite de nombres aléatoires</translation>
    </message>
    <message>
        <source>The sine of an angle in radians</source>
        <translation>Le sinus d&apos;un angle en radians</translation>
    </message>
    <message>
        <source>The square root of x</source>
        <translation>La racine carrée de x</translation>
    </message>
    <message>
        <source>The tangent of an angle in radians</source>
        <translation>La tangente d&apos;un angle en radians</translation>
    </message>
    <message>
        <source>x as a whole number, or nil if it is none</source>
        <translation>x sous forme d&apos;entier, ou nil s&apos;il n&apos;en est pas un</translation>
    </message>
    <message>
        <source>&quot;integer&quot;, &quot;float&quot;, or nil if x is no number</source>
        <translation>&quot;integer&quot;, &quot;float&quot;, ou nil si x n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>Whether m is below n, both read without sign</source>
        <translation>Si m est inférieur à n, tous deux lus sans signe</translation>
    </message>
    <message>
        <source>Values in a text: string.format(&quot;%.3f&quot;, x)</source>
        <translation>Des valeurs dans un texte&#xa0;: string.format(&quot;%.3f&quot;, x)</translation>
    </message>
    <message>
        <source>The number of bytes of a text</source>
        <translation>Le nombre d&apos;octets d&apos;un texte</translation>
    </message>
    <message>
        <source>A text in small letters</source>
        <translation>Un texte en minuscules</translation>
    </message>
    <message>
        <source>Part of a text; -1 is its last byte</source>
        <translation>Une partie d&apos;un texte&#xa0;; -1 est son dernier octet</translation>
    </message>
    <message>
        <source>A text in capital letters</source>
        <translation>Un texte en majuscules</translation>
    </message>
    <message>
        <source>The elements of a list as one text</source>
        <translation>Les éléments d&apos;une liste en un seul texte</translation>
    </message>
    <message>
        <source>Puts a value into a list, at its end if no position is given</source>
        <translation>Met une valeur dans une liste, à la fin si aucune position n&apos;est donnée</translation>
    </message>
    <message>
        <source>Takes an element out of a list, the last one unless told</source>
        <translation>Retire un élément d&apos;une liste, le dernier par défaut</translation>
    </message>
    <message>
        <source>Sorts a list; before(a, b) says whether a comes first</source>
        <translation>Trie une liste&#xa0;; before(a, b) dit si a vient en premier</translation>
    </message>
    <message>
        <source>The elements of a list as so many values</source>
        <translation>Les éléments d&apos;une liste comme autant de valeurs</translation>
    </message>
</context>
<context>
    <name>Main</name>
    <message>
        <source>open this step</source>
        <translation>ouvrir cette étape</translation>
    </message>
    <message>
        <source>speak this language, such as en or de</source>
        <translation>langue de l&apos;interface, par exemple fr ou en</translation>
    </message>
    <message>
        <source>system, light, dark or high-contrast</source>
        <translation>system, light, dark ou high-contrast</translation>
    </message>
    <message>
        <source>of texts, %: 100 to 200</source>
        <translation>des textes, en %&#xa0;: 100 à 200</translation>
    </message>
    <message>
        <source>open this scene of Lab → Example scenes</source>
        <translation>ouvrir cette scène de TP → Scènes d&apos;exemple</translation>
    </message>
    <message>
        <source>work on steps by this: explore or code</source>
        <translation>mode de travail&#xa0;: explore ou code</translation>
    </message>
    <message>
        <source>take this program as your own of the step</source>
        <translation>prendre ce programme comme le vôtre pour l&apos;étape</translation>
    </message>
    <message>
        <source>open this lab in the window in which labs are written</source>
        <translation>ouvrir ce TP dans la fenêtre où l&apos;on écrit les TP</translation>
    </message>
    <message>
        <source>of that window: scene, text, checks, programs or proof</source>
        <translation>de cette fenêtre&#xa0;: scene, text, checks, programs ou proof</translation>
    </message>
    <message>
        <source>draw the window into this file and quit</source>
        <translation>dessiner la fenêtre dans ce fichier et quitter</translation>
    </message>
    <message>
        <source>of the scene&apos;s time, s, in the picture</source>
        <translation>du temps de la scène, en s, sur l&apos;image</translation>
    </message>
    <message>
        <source>of the window, pixels</source>
        <translation>de la fenêtre, en pixels</translation>
    </message>
    <message>
        <source>Learn how a physics engine works by writing one.</source>
        <translation>Comprendre un moteur physique en l&apos;écrivant soi-même.</translation>
    </message>
    <message>
        <source>the lab or the scene to open; without it Lab 4.2</source>
        <translation>le TP ou la scène à ouvrir&#xa0;; par défaut le TP 4.2</translation>
    </message>
    <message>
        <source>cradle: unexpected argument %1; one lab or scene is right</source>
        <translation>cradle&#xa0;: argument inattendu&#xa0;: %1&#xa0;; il faut un seul TP ou une seule scène</translation>
    </message>
    <message>
        <source>cradle: --language %1: one of %2 is right</source>
        <translation>cradle&#xa0;: --language %1&#xa0;: il faut une valeur parmi %2</translation>
    </message>
    <message>
        <source>cradle: --theme %1: system, light, dark or high-contrast is right</source>
        <translation>cradle&#xa0;: --theme %1&#xa0;: il faut system, light, dark ou high-contrast</translation>
    </message>
    <message>
        <source>cradle: --mode %1: explore or code is right</source>
        <translation>cradle&#xa0;: --mode %1&#xa0;: il faut explore ou code</translation>
    </message>
    <message>
        <source>cradle: --text-size %1: a number from 100 to 200 is right</source>
        <translation>cradle&#xa0;: --text-size %1&#xa0;: il faut un nombre de 100 à 200</translation>
    </message>
    <message>
        <source>there is no step %1; there are %2</source>
        <translation>il n&apos;y a pas d&apos;étape %1&#xa0;; il y a %2</translation>
    </message>
    <message>
        <source>there is no step %1 in this lab</source>
        <translation>il n&apos;y a pas d&apos;étape %1 dans ce TP</translation>
    </message>
    <message>
        <source>there is no example %1; there are %2</source>
        <translation>il n&apos;y a pas d&apos;exemple %1&#xa0;; il y a %2</translation>
    </message>
    <message>
        <source>--tab %1: scene, text, checks, programs or proof is right</source>
        <translation>--tab %1&#xa0;: il faut scene, text, checks, programs ou proof</translation>
    </message>
    <message>
        <source>--at %1: a number of seconds from 0 to %2 is right</source>
        <translation>--at %1&#xa0;: il faut un nombre de secondes de 0 à %2</translation>
    </message>
    <message>
        <source>--size %1: a size like 1280x800 is right</source>
        <translation>--size %1&#xa0;: il faut une taille comme 1280x800</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>impossible d&apos;écrire %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>MainMenu</name>
    <message>
        <source>&amp;States of the run as CSV…</source>
        <translation>É&amp;tats de l&apos;exécution en CSV…</translation>
    </message>
    <message>
        <source>&amp;Totals of the run as CSV…</source>
        <translation>T&amp;otaux de l&apos;exécution en CSV…</translation>
    </message>
    <message>
        <source>&amp;Hits of the run as CSV…</source>
        <translation>&amp;Chocs de l&apos;exécution en CSV…</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xporter</translation>
    </message>
    <message>
        <source>&amp;Example scenes</source>
        <translation>Scènes d&apos;&amp;exemple</translation>
    </message>
    <message>
        <source>&amp;Lab</source>
        <translation>&amp;TP</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>Étape &amp;suivante</translation>
    </message>
    <message>
        <source>&amp;Previous step</source>
        <translation>Étape &amp;précédente</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Rapport…</translation>
    </message>
    <message>
        <source>&amp;Hand in…</source>
        <translation>Re&amp;ndre…</translation>
    </message>
    <message>
        <source>Share with &amp;git…</source>
        <translation>Partager avec &amp;git…</translation>
    </message>
    <message>
        <source>Grade a &amp;class…</source>
        <translation>Noter une &amp;classe…</translation>
    </message>
    <message>
        <source>&amp;Open lab…</source>
        <translation>&amp;Ouvrir un TP…</translation>
    </message>
    <message>
        <source>Open lab in one &amp;file…</source>
        <translation>Ouvrir un TP en un seul &amp;fichier…</translation>
    </message>
    <message>
        <source>Open &amp;scene…</source>
        <translation>Ou&amp;vrir une scène…</translation>
    </message>
    <message>
        <source>&amp;Author a lab…</source>
        <translation>Écrire un &amp;TP…</translation>
    </message>
    <message>
        <source>Sa&amp;ve scene as…</source>
        <translation>Enregistrer la scène so&amp;us…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;Add circle</source>
        <translation>A&amp;jouter un cercle</translation>
    </message>
    <message>
        <source>Reset to the &amp;step&apos;s scene</source>
        <translation>Re&amp;venir à la scène de l&apos;étape</translation>
    </message>
    <message>
        <source>&amp;Pin this run</source>
        <translation>Épin&amp;gler cette exécution</translation>
    </message>
    <message>
        <source>Keeps its curves, pale, beneath those of later runs</source>
        <translation>Garde ses courbes, pâles, sous celles des exécutions suivantes</translation>
    </message>
    <message>
        <source>Remo&amp;ve pinned runs</source>
        <translation>Retirer les exéc&amp;utions épinglées</translation>
    </message>
    <message>
        <source>Start a &amp;new run from here</source>
        <translation>Démarrer une &amp;nouvelle exécution d&apos;ici</translation>
    </message>
    <message>
        <source>The moment shown becomes the start of the scene; the run so far stays in the charts</source>
        <translation>L&apos;instant affiché devient le départ de la scène&#xa0;; l&apos;exécution jusque-là reste dans les graphiques</translation>
    </message>
    <message>
        <source>&amp;Simulation</source>
        <translation>&amp;Simulation</translation>
    </message>
    <message>
        <source>Pause at &amp;hits</source>
        <translation>Pause aux &amp;chocs</translation>
    </message>
    <message>
        <source>A run stops at the step of every collision; Run goes on</source>
        <translation>L&apos;exécution s&apos;arrête au pas de chaque choc&#xa0;; «&#xa0;Lancer&#xa0;» la poursuit</translation>
    </message>
    <message>
        <source>Slow &amp;motion around hits</source>
        <translation>Ralenti autour des c&amp;hocs</translation>
    </message>
    <message>
        <source>A run goes at 1/8× after every hit, and before those that are recorded already; its steps stay as they are</source>
        <translation>L&apos;exécution va à 1/8× après chaque choc, et avant ceux qui sont déjà enregistrés&#xa0;; ses pas restent ce qu&apos;ils sont</translation>
    </message>
    <message>
        <source>Steps as long as the &amp;frames took</source>
        <translation>Pas aussi longs que les &amp;images</translation>
    </message>
    <message>
        <source>As the original lab did: see why stable timesteps matter</source>
        <translation>Comme le faisait le TP d&apos;origine&#xa0;: pour voir pourquoi il faut des pas de temps réguliers</translation>
    </message>
    <message>
        <source>&amp;Scene shows</source>
        <translation>La &amp;scène montre</translation>
    </message>
    <message>
        <source>&amp;Velocities</source>
        <translation>&amp;Vitesses</translation>
    </message>
    <message>
        <source>&amp;Trails</source>
        <translation>&amp;Traces</translation>
    </message>
    <message>
        <source>&amp;Parts of a hit</source>
        <translation>Co&amp;mposantes d&apos;un choc</translation>
    </message>
    <message>
        <source>&amp;Loupe at a hit</source>
        <translation>&amp;Loupe lors d&apos;un choc</translation>
    </message>
    <message>
        <source>&amp;Momenta tip to tail</source>
        <translation>&amp;Quantités de mouvement bout à bout</translation>
    </message>
    <message>
        <source>&amp;Centre of mass and its way</source>
        <translation>&amp;Centre de masse et son trajet</translation>
    </message>
    <message>
        <source>&amp;Drawings of the program</source>
        <translation>&amp;Dessins du programme</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>&amp;Noms</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Grille</translation>
    </message>
    <message>
        <source>&amp;Exact motion beside the run</source>
        <translation>Mouvement &amp;exact à côté de l&apos;exécution</translation>
    </message>
    <message>
        <source>Outlines where every circle would be without any error of the integrator, the program or the timestep</source>
        <translation>Les contours là où serait chaque cercle sans aucune erreur de l&apos;intégrateur, du programme ou du pas de temps</translation>
    </message>
    <message>
        <source>&amp;Follow the centre of mass</source>
        <translation>Suivre le centre de &amp;masse</translation>
    </message>
    <message>
        <source>The view moves along with it: in its frame the momenta of all circles add up to nothing</source>
        <translation>La vue se déplace avec lui&#xa0;: dans son référentiel, la somme des quantités de mouvement de tous les cercles est nulle</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Zoom &amp;avant</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Zoom a&amp;rrière</translation>
    </message>
    <message>
        <source>Zoom to the hi&amp;t</source>
        <translation>&amp;Zoom sur le choc</translation>
    </message>
    <message>
        <source>Show the whole s&amp;quare</source>
        <translation>Tout le carr&amp;é</translation>
    </message>
    <message>
        <source>C&amp;harts</source>
        <translation>&amp;Graphiques</translation>
    </message>
    <message>
        <source>&amp;Reset zoom</source>
        <translation>Réin&amp;itialiser le zoom</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Plein écran</translation>
    </message>
    <message>
        <source>Scene &amp;alone</source>
        <translation>Scène seu&amp;le</translation>
    </message>
    <message>
        <source>P&amp;resentation</source>
        <translation>Présen&amp;tation</translation>
    </message>
    <message>
        <source>Large texts and high contrast; Page Up and Page Down go from hit to hit, B makes it black, Esc ends it</source>
        <translation>Grands textes et fort contraste&#xa0;; Page préc. et Page suiv. vont de choc en choc, B met l&apos;écran en noir, Échap y met fin</translation>
    </message>
    <message>
        <source>Scene in a &amp;window of its own</source>
        <translation>Scène dans sa propre &amp;fenêtre</translation>
    </message>
    <message>
        <source>Hits to scree&amp;n readers</source>
        <translation>Annoncer les c&amp;hocs aux lecteurs d&apos;écran</translation>
    </message>
    <message>
        <source>They tell every hit that is shown; of a run that goes on, one in a while</source>
        <translation>Ils annoncent chaque choc affiché&#xa0;; d&apos;une exécution en cours, un de temps en temps</translation>
    </message>
    <message>
        <source>Ne&amp;xt pane</source>
        <translation>Volet s&amp;uivant</translation>
    </message>
    <message>
        <source>Pre&amp;vious pane</source>
        <translation>Volet précé&amp;dent</translation>
    </message>
    <message>
        <source>Into the progra&amp;m</source>
        <translation>Aller dans le pr&amp;ogramme</translation>
    </message>
    <message>
        <source>&amp;Panes</source>
        <translation>&amp;Volets</translation>
    </message>
    <message>
        <source>&amp;Move panes</source>
        <translation>Déplacer les v&amp;olets</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Réinitialiser la disposition</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Couleurs</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Comme le &amp;système</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>S&amp;ombre</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Contraste &amp;élevé</translation>
    </message>
    <message>
        <source>Si&amp;ze of texts</source>
        <translation>Taille des te&amp;xtes</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>La&amp;ngue</translation>
    </message>
    <message>
        <source>Scene drawn &amp;by</source>
        <translation>Scène dess&amp;inée par</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatique</translation>
    </message>
    <message>
        <source>&amp;OpenGL</source>
        <translation>&amp;OpenGL</translation>
    </message>
    <message>
        <source>&amp;Processor</source>
        <translation>&amp;Processeur</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>&amp;Reference of the lab&apos;s Lua</source>
        <translation>&amp;Référence Lua du TP</translation>
    </message>
    <message>
        <source>&amp;Lua for C# people</source>
        <translation>&amp;Lua pour qui connaît C#</translation>
    </message>
    <message>
        <source>&amp;Tour of the window</source>
        <translation>&amp;Visite de la fenêtre</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>Raccourcis &amp;clavier</translation>
    </message>
    <message>
        <source>&amp;About Cradle</source>
        <translation>À &amp;propos de Cradle</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>À propos de &amp;Qt</translation>
    </message>
    <message>
        <source>S&amp;ounds of hits</source>
        <translation>S&amp;ons des chocs</translation>
    </message>
    <message>
        <source>The heavier a circle, the lower its tone; the greater the impulse, the louder</source>
        <translation>Plus un cercle est lourd, plus le son est grave&#xa0;; plus l&apos;impulsion est grande, plus il est fort</translation>
    </message>
</context>
<context>
    <name>MomentumInset</name>
    <message>
        <source>Momentum</source>
        <translation>Quantité de mouvement</translation>
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
        <translation>Un terme a le mauvais signe</translation>
    </message>
    <message>
        <source>Which way should this term act? Try it with a circle that moves to the right.</source>
        <translation>Dans quel sens ce terme doit-il agir&#xa0;? Essayez avec un cercle qui va vers la droite.</translation>
    </message>
    <message>
        <source>The factor `%1` is missing</source>
        <translation>Le facteur `%1` manque</translation>
    </message>
    <message>
        <source>Do both sides have the same unit? What changes if this factor is twice as large?</source>
        <translation>Les deux côtés ont-ils la même unité&#xa0;? Qu&apos;est-ce qui change si ce facteur est deux fois plus grand&#xa0;?</translation>
    </message>
    <message>
        <source>Something stands in the wrong place</source>
        <translation>Quelque chose est au mauvais endroit</translation>
    </message>
    <message>
        <source>A product comes before a sum: what belongs together here?</source>
        <translation>Un produit passe avant une somme&#xa0;: qu&apos;est-ce qui va ensemble ici&#xa0;?</translation>
    </message>
    <message>
        <source>The normal does not have the length 1</source>
        <translation>La normale n&apos;a pas la longueur 1</translation>
    </message>
    <message>
        <source>How long is this vector? A part along it is right only if its length is 1.</source>
        <translation>Quelle est la longueur de ce vecteur&#xa0;? Une composante suivant lui n&apos;est juste que si elle vaut 1.</translation>
    </message>
    <message>
        <source>A comparison is the wrong way round</source>
        <translation>Une comparaison est à l&apos;envers</translation>
    </message>
    <message>
        <source>When should this happen: above or below?</source>
        <translation>Quand cela doit-il se produire&#xa0;: au-dessus ou au-dessous&#xa0;?</translation>
    </message>
    <message>
        <source>A part of a condition is missing</source>
        <translation>Une partie d&apos;une condition manque</translation>
    </message>
    <message>
        <source>When should this happen, and when not? Think of circles that already move apart, and of every wall.</source>
        <translation>Quand cela doit-il se produire, et quand non&#xa0;? Pensez aux cercles qui s&apos;éloignent déjà, et à chaque paroi.</translation>
    </message>
    <message>
        <source>One case is missing</source>
        <translation>Un cas manque</translation>
    </message>
    <message>
        <source>Go through the cases one by one: which of them does nothing?</source>
        <translation>Passez les cas un par un&#xa0;: lequel ne fait rien&#xa0;?</translation>
    </message>
    <message>
        <source>It happens always</source>
        <translation>Cela se produit toujours</translation>
    </message>
    <message>
        <source>When should this happen, and when not?</source>
        <translation>Quand cela doit-il se produire, et quand non&#xa0;?</translation>
    </message>
    <message>
        <source>`%1` stands where `%2` belongs</source>
        <translation>`%1` est là où il faut `%2`</translation>
    </message>
    <message>
        <source>Which circle, and which coordinate, is meant here?</source>
        <translation>De quel cercle, et de quelle coordonnée, s&apos;agit-il ici&#xa0;?</translation>
    </message>
    <message>
        <source>The hit takes nothing</source>
        <translation>Le choc ne fait rien perdre</translation>
    </message>
    <message>
        <source>Which part of the velocity should become e times what it was?</source>
        <translation>Quelle composante de la vitesse doit devenir e fois ce qu&apos;elle était&#xa0;?</translation>
    </message>
    <message>
        <source>e counts twice</source>
        <translation>e compte deux fois</translation>
    </message>
    <message>
        <source>How fast does it leave, compared with how fast it came?</source>
        <translation>À quelle vitesse repart-il, comparée à celle de l&apos;arrivée&#xa0;?</translation>
    </message>
    <message>
        <source>Something is left out</source>
        <translation>Quelque chose est omis</translation>
    </message>
    <message>
        <source>Compare with the instructions what has to be done for every circle in every step.</source>
        <translation>Comparez avec les instructions ce qu&apos;il faut faire pour chaque cercle à chaque pas.</translation>
    </message>
    <message>
        <source>Something happens twice</source>
        <translation>Quelque chose se produit deux fois</translation>
    </message>
    <message>
        <source>How often does this run in one step?</source>
        <translation>Combien de fois cela s&apos;exécute-t-il en un pas&#xa0;?</translation>
    </message>
    <message>
        <source>Two lines stand in the other order</source>
        <translation>Deux lignes sont interverties</translation>
    </message>
    <message>
        <source>Which value does the second line need: the one from before or the one from after the first?</source>
        <translation>Quelle valeur faut-il à la seconde ligne&#xa0;: celle d&apos;avant ou celle d&apos;après la première&#xa0;?</translation>
    </message>
</context>
<context>
    <name>Panes</name>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>lab.lua</source>
        <translation>lab.lua</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspecteur</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versions</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Quantité de mouvement</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Énergie</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
</context>
<context>
    <name>ParameterText</name>
    <message>
        <source>from %1 to %2%3</source>
        <translation>de %1 à %2%3</translation>
    </message>
    <message>
        <source>%1%2 or more</source>
        <translation>%1%2 ou plus</translation>
    </message>
    <message>
        <source>any%1</source>
        <translation>quelconque%1</translation>
    </message>
    <message>
        <source>%1: a whole number, %2, is right</source>
        <translation>%1&#xa0;: il faut un nombre entier, %2</translation>
    </message>
    <message>
        <source>%1: two numbers as “2, 0”, %2, are right</source>
        <translation>%1&#xa0;: il faut deux nombres comme «&#xa0;2, 0&#xa0;», %2</translation>
    </message>
    <message>
        <source>%1: the least and the most as “0.5, 2”, %2, are right</source>
        <translation>%1&#xa0;: il faut le minimum et le maximum comme «&#xa0;0.5, 2&#xa0;», %2</translation>
    </message>
    <message>
        <source>%1: pairs of numbers as “2, 0; 0, 0”, %2, are right</source>
        <translation>%1&#xa0;: il faut des paires de nombres comme «&#xa0;2, 0; 0, 0&#xa0;», %2</translation>
    </message>
    <message>
        <source>%1: numbers as “0.5, 1”, %2, are right</source>
        <translation>%1&#xa0;: il faut des nombres comme «&#xa0;0.5, 1&#xa0;», %2</translation>
    </message>
    <message>
        <source>%1: a number, %2, is right</source>
        <translation>%1&#xa0;: il faut un nombre, %2</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>, in %1</source>
        <translation>, en %1</translation>
    </message>
</context>
<context>
    <name>Phase</name>
    <message>
        <source>kinetic</source>
        <translation>cinétique</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>potentielle</translation>
    </message>
    <message>
        <source>total</source>
        <translation>totale</translation>
    </message>
    <message>
        <source>distance 1–2</source>
        <translation>distance 1–2</translation>
    </message>
    <message>
        <source>off exact</source>
        <translation>écart à l&apos;exact</translation>
    </message>
    <message>
        <source>more than exact</source>
        <translation>de plus que l&apos;exact</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Position x</source>
        <translation>Position x</translation>
    </message>
    <message>
        <source>Position y</source>
        <translation>Position y</translation>
    </message>
    <message>
        <source>Velocity to the right</source>
        <translation>Vitesse vers la droite</translation>
    </message>
    <message>
        <source>Velocity upwards</source>
        <translation>Vitesse vers le haut</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse (norme)</translation>
    </message>
    <message>
        <source>Momentum to the right</source>
        <translation>Quantité de mouvement vers la droite</translation>
    </message>
    <message>
        <source>Momentum upwards</source>
        <translation>Quantité de mouvement vers le haut</translation>
    </message>
    <message>
        <source>Size of the momentum</source>
        <translation>Norme de la quantité de mouvement</translation>
    </message>
    <message>
        <source>Kinetic energy</source>
        <translation>Énergie cinétique</translation>
    </message>
    <message>
        <source>Potential energy</source>
        <translation>Énergie potentielle</translation>
    </message>
    <message>
        <source>Total energy</source>
        <translation>Énergie totale</translation>
    </message>
    <message>
        <source>Distance of circles 1 and 2</source>
        <translation>Distance des cercles 1 et 2</translation>
    </message>
    <message>
        <source>Distance from the exact motion</source>
        <translation>Distance au mouvement exact</translation>
    </message>
    <message>
        <source>Energy more than the exact motion</source>
        <translation>Énergie de plus que le mouvement exact</translation>
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
        <translation>%1 tous</translation>
    </message>
</context>
<context>
    <name>Preset</name>
    <message>
        <source>%1 circles of radius %2 m do not fit into the square; at most %3 are right</source>
        <translation>%1 cercles de rayon %2 m ne tiennent pas dans le carré&#xa0;; au plus %3 conviennent</translation>
    </message>
    <message>
        <source>%1 is out of range; a number from %2 to %3 is right</source>
        <translation>%1 est hors limites&#xa0;; il faut un nombre de %2 à %3</translation>
    </message>
    <message>
        <source>the name is too long; at most %1 characters are right</source>
        <translation>le nom est trop long&#xa0;; au plus %1 caractères conviennent</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; one like #1e90ff is right</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas une couleur&#xa0;; il en faut une comme #1e90ff</translation>
    </message>
    <message>
        <source>it is wider than the square</source>
        <translation>il est plus large que le carré</translation>
    </message>
    <message>
        <source>x and y from %1 to %2 m are right</source>
        <translation>il faut x et y de %1 à %2 m</translation>
    </message>
    <message>
        <source>circle %1 at (%2, %3) m is not inside the square, whose walls reflect; %4</source>
        <translation>le cercle %1 en (%2, %3) m n&apos;est pas à l&apos;intérieur du carré, dont les parois renvoient&#xa0;; %4</translation>
    </message>
    <message>
        <source>circles %1 and %2 overlap: their centres are %3 m apart; at least r₁ + r₂ = %4 m is right</source>
        <translation>les cercles %1 et %2 se chevauchent&#xa0;: leurs centres sont à %3 m l&apos;un de l&apos;autre&#xa0;; il faut au moins r₁ + r₂ = %4 m</translation>
    </message>
    <message>
        <source>at most %1 circles are right</source>
        <translation>au plus %1 cercles conviennent</translation>
    </message>
</context>
<context>
    <name>Progress</name>
    <message>
        <source>your progress could not be saved: %1</source>
        <translation>votre progression n&apos;a pas pu être enregistrée&#xa0;: %1</translation>
    </message>
    <message>
        <source>your progress could not be read (%2) and was moved to %1; Cradle begins anew</source>
        <translation>votre progression n&apos;a pas pu être lue (%2) et a été déplacée vers %1&#xa0;; Cradle repart de zéro</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Return</source>
        <translation>Entrée</translation>
    </message>
</context>
<context>
    <name>Questions</name>
    <message>
        <source>“%1” is no number; one like 0.75 is asked for</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas un nombre&#xa0;; il en faut un comme 0.75</translation>
    </message>
    <message>
        <source>“%1” is no number with a unit; one like 3.2 kg is asked for</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas un nombre avec une unité&#xa0;; il en faut un comme 3.2 kg</translation>
    </message>
    <message>
        <source>“%1” is no unit that is known</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas une unité connue</translation>
    </message>
    <message>
        <source>the number is right; its unit is missing</source>
        <translation>le nombre est juste&#xa0;; son unité manque</translation>
    </message>
    <message>
        <source>%1 is not right, and its unit is missing</source>
        <translation>%1 n&apos;est pas juste, et son unité manque</translation>
    </message>
    <message>
        <source>the number is right, but not its unit: what is asked for is not measured in %1</source>
        <translation>le nombre est juste, mais pas son unité&#xa0;: ce qui est demandé ne se mesure pas en %1</translation>
    </message>
    <message>
        <source>%1 is not right: what is asked for is not measured in %2</source>
        <translation>%1 n&apos;est pas juste&#xa0;: ce qui est demandé ne se mesure pas en %2</translation>
    </message>
    <message>
        <source>the number is right, but not in %1</source>
        <translation>le nombre est juste, mais pas en %1</translation>
    </message>
    <message>
        <source>%1 is not right</source>
        <translation>%1 n&apos;est pas juste</translation>
    </message>
    <message>
        <source>one that is chosen is not right, and a right one is missing</source>
        <translation>une des réponses choisies n&apos;est pas juste, et il en manque une juste</translation>
    </message>
    <message>
        <source>one that is chosen is not right</source>
        <translation>une des réponses choisies n&apos;est pas juste</translation>
    </message>
    <message>
        <source>all that is chosen is right, but not all that is right is chosen</source>
        <translation>tout ce qui est choisi est juste, mais il manque des réponses justes</translation>
    </message>
    <message>
        <source>not all of them are in the order</source>
        <translation>il manque des éléments dans l&apos;ordre</translation>
    </message>
    <message>
        <source>it does not begin with what is first</source>
        <translation>cela ne commence pas par ce qui vient en premier</translation>
    </message>
    <message>
        <source>the order is right up to number %1, and not behind it</source>
        <translation>l&apos;ordre est juste jusqu&apos;au numéro %1, et plus après</translation>
    </message>
    <message>
        <source>the answer that is chosen is not right</source>
        <translation>la réponse choisie n&apos;est pas juste</translation>
    </message>
    <message>
        <source>not answered yet</source>
        <translation>pas encore de réponse</translation>
    </message>
    <message>
        <source>for the teacher to read, who may give up to %1 points: %2</source>
        <translation>à lire par l&apos;enseignant, qui peut donner jusqu&apos;à %1 points&#xa0;: %2</translation>
    </message>
    <message>
        <source>a list of two to eight answers is right</source>
        <translation>il faut une liste de deux à huit réponses</translation>
    </message>
    <message>
        <source>the right answers by their numbers from 1 are missing</source>
        <translation>il manque les bonnes réponses, par leurs numéros à partir de 1</translation>
    </message>
    <message>
        <source>a number from 1 to %1, for there are so many answers, is right</source>
        <translation>il faut un nombre de 1 à %1, car il y a autant de réponses</translation>
    </message>
    <message>
        <source>one right answer; for more of them the kind is several</source>
        <translation>il faut une seule bonne réponse&#xa0;; pour plusieurs, le type est several</translation>
    </message>
    <message>
        <source>%1 is no unit; one like m/s, kg m/s, N s, J, ° or % is right</source>
        <translation>%1 n&apos;est pas une unité&#xa0;; il en faut une comme m/s, kg m/s, N s, J, ° ou %</translation>
    </message>
    <message>
        <source>another check or question has the id %1 already; an id of its own is right</source>
        <translation>une autre vérification ou question a déjà l&apos;id %1&#xa0;; il faut un autre id</translation>
    </message>
    <message>
        <source>the right number is missing</source>
        <translation>le nombre juste manque</translation>
    </message>
    <message>
        <source>Tolerance: a number from 0 is right</source>
        <translation>Tolérance&#xa0;: il faut un nombre à partir de 0</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>in step %1, at %2 s</source>
        <translation>au pas %1, à %2 s</translation>
    </message>
    <message>
        <source>with %1</source>
        <translation>avec %1</translation>
    </message>
    <message>
        <source>Look at %1:%2</source>
        <translation>Regardez %1:%2</translation>
    </message>
    <message>
        <source>The program moved the circles.</source>
        <translation>Le programme a déplacé les cercles.</translation>
    </message>
    <message>
        <source>The laws of the scene moved the circles.</source>
        <translation>Les lois de la scène ont déplacé les cercles.</translation>
    </message>
    <message>
        <source>Commit message: %1</source>
        <translation>Message de commit&#xa0;: %1</translation>
    </message>
    <message>
        <source>in the scene: %1</source>
        <translation>dans la scène&#xa0;: %1</translation>
    </message>
    <message>
        <source>last assigned in that step by %1:%2</source>
        <translation>dernière affectation de ce pas : %1:%2</translation>
    </message>
    <message>
        <source>%1 passed</source>
        <translation>%1 réussie</translation>
    </message>
    <message>
        <source>%1 did not pass: the program stopped</source>
        <translation>%1 non réussie&#xa0;: le programme s&apos;est arrêté</translation>
    </message>
    <message>
        <source>%1 did not pass: the program stopped before its first step</source>
        <translation>%1 non réussie&#xa0;: le programme s&apos;est arrêté avant son premier pas</translation>
    </message>
    <message>
        <source>%1 did not pass: the program does not load</source>
        <translation>%1 non réussie&#xa0;: le programme ne se charge pas</translation>
    </message>
    <message>
        <source>%1 did not pass: %2 of %3 checks and answers failed</source>
        <translation>%1 non réussie&#xa0;: %2 vérifications et réponses sur %3 ont échoué</translation>
    </message>
    <message>
        <source>%1 did not pass: %2 of %3 checks failed</source>
        <translation>%1 non réussie&#xa0;: %2 vérifications sur %3 ont échoué</translation>
    </message>
    <message>
        <source>%1 (%2 of %3 points)</source>
        <translation>%1 (%2 points sur %3)</translation>
    </message>
</context>
<context>
    <name>ReportPrinter</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
</context>
<context>
    <name>ResultPane</name>
    <message>
        <source>%1: %2</source>
        <comment>place, message</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>The program cannot be read</source>
        <translation>Le programme est illisible</translation>
    </message>
    <message>
        <source>The program takes too long</source>
        <translation>Le programme est trop lent</translation>
    </message>
    <message>
        <source>The program needs too much memory</source>
        <translation>Le programme demande trop de mémoire</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Non évalué</translation>
    </message>
    <message>
        <source>The program stopped</source>
        <translation>Le programme s&apos;est arrêté</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Ligne %1</translation>
    </message>
    <message>
        <source>in step %1, at %2 s</source>
        <translation>au pas %1, à %2 s</translation>
    </message>
</context>
<context>
    <name>RunDifference</name>
    <message>
        <source>circle %1</source>
        <translation>cercle %1</translation>
    </message>
    <message>
        <source>laws → program</source>
        <translation>lois → programme</translation>
    </message>
    <message>
        <source>program → laws</source>
        <translation>programme → lois</translation>
    </message>
    <message>
        <source>program changed</source>
        <translation>programme modifié</translation>
    </message>
    <message>
        <source>half width</source>
        <translation>demi-largeur</translation>
    </message>
    <message>
        <source>timing</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>parois</translation>
    </message>
    <message>
        <source>circles</source>
        <translation>cercles</translation>
    </message>
    <message>
        <source>%1 → %2 circles</source>
        <translation>%1 → %2 cercles</translation>
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
        <translation>Choc frontal</translation>
    </message>
    <message>
        <source>Glancing collision</source>
        <translation>Choc oblique</translation>
    </message>
    <message>
        <source>Newton&apos;s cradle</source>
        <translation>Pendule de Newton</translation>
    </message>
    <message>
        <source>Gas</source>
        <translation>Gaz</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Chute</translation>
    </message>
</context>
<context>
    <name>Schema</name>
    <message numerus="yes">
        <source>a list of %n value(s)</source>
        <translation>
            <numerusform>une liste de %n valeur</numerusform>
            <numerusform>une liste de %n valeurs</numerusform>
        </translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;; the keys here are %2</source>
        <translation>clé inconnue «&#xa0;%1&#xa0;»&#xa0;; les clés sont ici %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing</source>
        <translation>«&#xa0;%1&#xa0;» manque</translation>
    </message>
    <message>
        <source>%1 is not right here; right would be %2</source>
        <translation>%1 ne convient pas ici&#xa0;; il faudrait %2</translation>
    </message>
    <message>
        <source>needs a newer Cradle: format %1, this one reads %2</source>
        <translation>il faut un Cradle plus récent&#xa0;: format %1, celui-ci lit %2</translation>
    </message>
    <message>
        <source>this is not JSON: %1</source>
        <translation>ce n&apos;est pas du JSON&#xa0;: %1</translation>
    </message>
    <message>
        <source>this is a folder; a file is right</source>
        <translation>c&apos;est un dossier&#xa0;; il faut un fichier</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>illisible&#xa0;: %1</translation>
    </message>
    <message>
        <source>the file is too large; at most %1 are right</source>
        <translation>le fichier est trop grand&#xa0;; au plus %1 conviennent</translation>
    </message>
    <message>
        <source>a list of questions</source>
        <translation>une liste de questions</translation>
    </message>
    <message>
        <source>a list of two to eight answers</source>
        <translation>une liste de deux à huit réponses</translation>
    </message>
    <message>
        <source>a number or an expression, the number of an answer from 1, or a list of such numbers</source>
        <translation>un nombre ou une expression, le numéro d&apos;une réponse à partir de 1, ou une liste de tels nombres</translation>
    </message>
    <message>
        <source>a number, an expression like 2*k, or an object with from, to and step</source>
        <translation>un nombre, une expression comme 2*k, ou un objet avec from, to et step</translation>
    </message>
    <message>
        <source>a text of 1 to 200 characters</source>
        <translation>un texte de 1 à 200 caractères</translation>
    </message>
    <message>
        <source>a text of at most 200 characters; another draws other values</source>
        <translation>un texte d&apos;au plus 200 caractères&#xa0;; un autre tire d&apos;autres valeurs</translation>
    </message>
    <message>
        <source>a unit like m/s of at most 40 characters</source>
        <translation>une unité comme m/s, d&apos;au plus 40 caractères</translation>
    </message>
    <message>
        <source>an object with format, id, title, commit, preset, hints, code_hints, prediction, remarks, checks, questions, values, moves, extra and locked</source>
        <translation>un objet avec format, id, title, commit, preset, hints, code_hints, prediction, remarks, checks, questions, values, moves, extra et locked</translation>
    </message>
    <message>
        <source>an object with format, id, title, version, language, values, draw and steps</source>
        <translation>un objet avec format, id, title, version, language, values, draw et steps</translation>
    </message>
    <message>
        <source>an object with id, kind, title, text, answers, right, unit, tolerance and points</source>
        <translation>un objet avec id, kind, title, text, answers, right, unit, tolerance et points</translation>
    </message>
    <message>
        <source>an object with numbers, expressions, or ranges with from, to and step, by their names</source>
        <translation>un objet avec des nombres, des expressions ou des intervalles avec from, to et step, par leurs noms</translation>
    </message>
    <message>
        <source>an object with the texts of the questions by their id</source>
        <translation>un objet avec les textes des questions par leur id</translation>
    </message>
    <message>
        <source>an object with title, hints, code_hints, prediction, checks, questions, mistakes and remarks</source>
        <translation>un objet avec title, hints, code_hints, prediction, checks, questions, mistakes et remarks</translation>
    </message>
    <message>
        <source>an object with title, text and answers</source>
        <translation>un objet avec title, text et answers</translation>
    </message>
    <message>
        <source>from one to the next, a number greater than 0</source>
        <translation>de l&apos;un au suivant, un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>one of number, one, several, order, text</source>
        <translation>une valeur parmi number, one, several, order, text</translation>
    </message>
    <message>
        <source>the least, a number</source>
        <translation>le minimum, un nombre</translation>
    </message>
    <message>
        <source>the most, a number</source>
        <translation>le maximum, un nombre</translation>
    </message>
    <message>
        <source>the number of an answer, from 1</source>
        <translation>le numéro d&apos;une réponse, à partir de 1</translation>
    </message>
    <message>
        <source>what a right answer is worth, a number from 0 to 1000</source>
        <translation>ce que vaut une bonne réponse, un nombre de 0 à 1000</translation>
    </message>
    <message>
        <source>1, the format that this version reads</source>
        <translation>1, le format que lit cette version</translation>
    </message>
    <message>
        <source>a circle number from 1</source>
        <translation>un numéro de cercle à partir de 1</translation>
    </message>
    <message>
        <source>a colour like #1e90ff</source>
        <translation>une couleur comme #1e90ff</translation>
    </message>
    <message>
        <source>a language code like en or de</source>
        <translation>un code de langue comme en ou de</translation>
    </message>
    <message>
        <source>a list of checks</source>
        <translation>une liste de vérifications</translation>
    </message>
    <message>
        <source>a list of circle numbers from 1</source>
        <translation>une liste de numéros de cercles à partir de 1</translation>
    </message>
    <message>
        <source>a list of circles, or an object with fill</source>
        <translation>une liste de cercles, ou un objet avec fill</translation>
    </message>
    <message>
        <source>a list of folder names, in order</source>
        <translation>une liste de noms de dossiers, dans l&apos;ordre</translation>
    </message>
    <message>
        <source>a list of remarks</source>
        <translation>une liste d&apos;appréciations</translation>
    </message>
    <message>
        <source>a list of texts</source>
        <translation>une liste de textes</translation>
    </message>
    <message>
        <source>a list of two to four answers</source>
        <translation>une liste de deux à quatre réponses</translation>
    </message>
    <message>
        <source>a number in m from -10000 to 10000</source>
        <translation>un nombre en m de -10000 à 10000</translation>
    </message>
    <message>
        <source>a number in m/s from -1e7 to 1e7</source>
        <translation>un nombre en m/s de -1e7 à 1e7</translation>
    </message>
    <message>
        <source>a number in m/s² from -10000 to 10000</source>
        <translation>un nombre en m/s² de -10000 à 10000</translation>
    </message>
    <message>
        <source>a text of 1 to 100 characters</source>
        <translation>un texte de 1 à 100 caractères</translation>
    </message>
    <message>
        <source>a text of 1 to 400 characters</source>
        <translation>un texte de 1 à 400 caractères</translation>
    </message>
    <message>
        <source>a text of 1 to 1000 characters</source>
        <translation>un texte de 1 à 1000 caractères</translation>
    </message>
    <message>
        <source>a text of at most 200 characters</source>
        <translation>un texte d&apos;au plus 200 caractères</translation>
    </message>
    <message>
        <source>a text of at most 2000 characters</source>
        <translation>un texte d&apos;au plus 2000 caractères</translation>
    </message>
    <message>
        <source>a whole number from 0 to 2147483647</source>
        <translation>un nombre entier de 0 à 2147483647</translation>
    </message>
    <message>
        <source>an object that says which scenes the check runs: kind, count, duration, timesteps and what they vary</source>
        <translation>un objet qui dit quelles scènes fait tourner la vérification&#xa0;: kind, count, duration, timesteps et ce qu&apos;elles font varier</translation>
    </message>
    <message>
        <source>an object with count and radius, and if wanted rms_speed, density, seed</source>
        <translation>un objet avec count et radius et, si voulu, rms_speed, density, seed</translation>
    </message>
    <message>
        <source>a list of fields of the scene that the student may not change</source>
        <translation>une liste de champs de la scène que l&apos;étudiant ne peut pas changer</translation>
    </message>
    <message>
        <source>a field as gravity, restitution, timestep, half_width, circles, laws/walls, laws/circles, laws/timing or circles/1/velocity</source>
        <translation>un champ comme gravity, restitution, timestep, half_width, circles, laws/walls, laws/circles, laws/timing ou circles/1/velocity</translation>
    </message>
    <message>
        <source>an object with format, name, square, gravity, restitution, timestep, laws and circles</source>
        <translation>un objet avec format, name, square, gravity, restitution, timestep, laws et circles</translation>
    </message>
    <message>
        <source>an object with half_width</source>
        <translation>un objet avec half_width</translation>
    </message>
    <message>
        <source>an object with id, compare and scene</source>
        <translation>un objet avec id, compare et scene</translation>
    </message>
    <message>
        <source>an object with id, kind, title, points, parameters and scene</source>
        <translation>un objet avec id, kind, title, points, parameters et scene</translation>
    </message>
    <message>
        <source>an object with position, and if wanted name, velocity, radius, density, colour, integrator</source>
        <translation>un objet avec position et, si voulu, name, velocity, radius, density, colour, integrator</translation>
    </message>
    <message>
        <source>an object with question, answers, right and outcome</source>
        <translation>un objet avec question, answers, right et outcome</translation>
    </message>
    <message>
        <source>an object with question, answers and outcome</source>
        <translation>un objet avec question, answers et outcome</translation>
    </message>
    <message>
        <source>an object with the parameters of the kind</source>
        <translation>un objet avec les paramètres du type</translation>
    </message>
    <message>
        <source>an object with the texts of the mistakes by their name</source>
        <translation>un objet avec les textes des erreurs par leur nom</translation>
    </message>
    <message>
        <source>an object with the texts of the remarks by their name</source>
        <translation>un objet avec les textes des appréciations par leur nom</translation>
    </message>
    <message>
        <source>an object with the titles of the checks by their id</source>
        <translation>un objet avec les titres des vérifications par leur id</translation>
    </message>
    <message>
        <source>an object with walls, circles and timing</source>
        <translation>un objet avec walls, circles et timing</translation>
    </message>
    <message>
        <source>half the side of the square in m, a number from 1e-6 to 10000</source>
        <translation>la moitié du côté du carré en m, un nombre de 1e-6 à 10000</translation>
    </message>
    <message>
        <source>how many circles, a whole number from 1 to 100000</source>
        <translation>combien de cercles, un nombre entier de 1 à 100000</translation>
    </message>
    <message>
        <source>one of discrete, continuous, exact</source>
        <translation>une valeur parmi discrete, continuous, exact</translation>
    </message>
    <message>
        <source>one of euler, symplectic_euler, verlet, rk4</source>
        <translation>une valeur parmi euler, symplectic_euler, verlet, rk4</translation>
    </message>
    <message>
        <source>one of none, reflect</source>
        <translation>une valeur parmi none, reflect</translation>
    </message>
    <message>
        <source>one of none, stop, swap_velocities, swap_normal, impulse</source>
        <translation>une valeur parmi none, stop, swap_velocities, swap_normal, impulse</translation>
    </message>
    <message>
        <source>one of program, laws, either</source>
        <translation>une valeur parmi program, laws, either</translation>
    </message>
    <message>
        <source>one of velocities, positions, fields</source>
        <translation>une valeur parmi velocities, positions, fields</translation>
    </message>
    <message>
        <source>the coefficient of restitution e, a number from 0 to 1</source>
        <translation>le coefficient de restitution e, un nombre de 0 à 1</translation>
    </message>
    <message>
        <source>the density in 1000 kg/m³, a number from 1e-9 to 1e9</source>
        <translation>la masse volumique en 1000 kg/m³, un nombre de 1e-9 à 1e9</translation>
    </message>
    <message>
        <source>the name of a file beside task.json</source>
        <translation>le nom d&apos;un fichier à côté de task.json</translation>
    </message>
    <message>
        <source>the name of a folder beside lab.json: letters, digits, dashes and underscores</source>
        <translation>le nom d&apos;un dossier à côté de lab.json&#xa0;: lettres, chiffres, traits d&apos;union et tirets bas</translation>
    </message>
    <message>
        <source>the name of a kind of check</source>
        <translation>le nom d&apos;un type de vérification</translation>
    </message>
    <message>
        <source>the number of the answer that comes true, from 1</source>
        <translation>le numéro de la réponse qui se réalise, à partir de 1</translation>
    </message>
    <message>
        <source>the radius in m, a number from 1e-6 to 10000</source>
        <translation>le rayon en m, un nombre de 1e-6 à 10000</translation>
    </message>
    <message>
        <source>the root mean square speed in m/s, a number from 0 to 1e6</source>
        <translation>la vitesse quadratique moyenne en m/s, un nombre de 0 à 1e6</translation>
    </message>
    <message>
        <source>the timestep in s, a number from 1e-6 to 0.1</source>
        <translation>le pas de temps en s, un nombre de 1e-6 à 0.1</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>two numbers [x, y] in m, each from -10000 to 10000</source>
        <translation>deux nombres [x, y] en m, chacun de -10000 à 10000</translation>
    </message>
    <message>
        <source>two numbers [x, y] in m/s, each from -1e7 to 1e7</source>
        <translation>deux nombres [x, y] en m/s, chacun de -1e7 à 1e7</translation>
    </message>
    <message>
        <source>two numbers [x, y] in m/s², each from -10000 to 10000</source>
        <translation>deux nombres [x, y] en m/s², chacun de -10000 à 10000</translation>
    </message>
    <message>
        <source>what passing the check is worth, a number from 0 to 1000</source>
        <translation>ce que vaut la réussite de la vérification, un nombre de 0 à 1000</translation>
    </message>
    <message>
        <source>what the step is worth, a number from 0 to 1000</source>
        <translation>ce que vaut l&apos;étape, un nombre de 0 à 1000</translation>
    </message>
    <message>
        <source>of an edition for students: the SHA-256 of the lab that it is of</source>
        <translation>d&apos;une édition pour étudiants&#xa0;: le SHA-256 du TP dont elle vient</translation>
    </message>
    <message>
        <source>how far off is still right, a number from 0 or an expression</source>
        <translation>l&apos;écart encore admis, un nombre à partir de 0 ou une expression</translation>
    </message>
    <message>
        <source>a short name of letters, digits, dots, dashes and underscores</source>
        <translation>un nom court fait de lettres, de chiffres, de points, de traits d&apos;union et de tirets bas</translation>
    </message>
    <message>
        <source>an object with format and labs</source>
        <translation>un objet avec format et labs</translation>
    </message>
    <message>
        <source>an object with the progress in each lab by its id</source>
        <translation>un objet avec la progression dans chaque TP par son identifiant</translation>
    </message>
</context>
<context>
    <name>Script</name>
    <message>
        <source>there is no function check(run) … end</source>
        <translation>il n&apos;y a pas de fonction check(run) … end</translation>
    </message>
    <message>
        <source>check(run) returned %1; true, or false and a message, is right</source>
        <translation>check(run) a renvoyé %1&#xa0;; il faut true, ou false et un message</translation>
    </message>
    <message>
        <source>check(run) returned false without a message for the student; return false, &quot;what is wrong&quot; is right</source>
        <translation>check(run) a renvoyé false sans message pour l&apos;étudiant&#xa0;; il faut return false, &quot;ce qui ne va pas&quot;</translation>
    </message>
    <message>
        <source>%1 has no field %2; a field has a name</source>
        <translation>%1 n&apos;a pas de champ %2&#xa0;; un champ a un nom</translation>
    </message>
    <message>
        <source>%1 has no field `%2`: did you mean `%3`?</source>
        <translation>%1 n&apos;a pas de champ `%2`&#xa0;: vouliez-vous dire `%3`&#xa0;?</translation>
    </message>
    <message>
        <source>%1 has no field `%2`; it has %3. A field of your own must be set before it is read: %1.%2 = …</source>
        <translation>%1 n&apos;a pas de champ `%2`&#xa0;; il y a %3. Un champ à vous doit être fixé avant d&apos;être lu&#xa0;: %1.%2 = …</translation>
    </message>
    <message>
        <source>%1 must be a vector, not %2; write vec(x, y)</source>
        <translation>%1 doit être un vecteur, pas %2&#xa0;; écrivez vec(x, y)</translation>
    </message>
    <message>
        <source>%1 would be %2; every number of a circle must be finite. Look for a division by zero, or for a value that grows in every step</source>
        <translation>%1 serait %2&#xa0;; chaque nombre d&apos;un cercle doit être fini. Cherchez une division par zéro, ou une valeur qui croît à chaque pas</translation>
    </message>
    <message>
        <source>%1 must be a number, not %2</source>
        <translation>%1 doit être un nombre, pas %2</translation>
    </message>
    <message>
        <source>%1 would be %2; it must be finite and above 0</source>
        <translation>%1 serait %2&#xa0;; il doit être fini et supérieur à 0</translation>
    </message>
    <message>
        <source>%1.index is given and cannot be changed</source>
        <translation>%1.index est donné et ne peut pas être changé</translation>
    </message>
    <message>
        <source>how many circles there are is #circles</source>
        <translation>le nombre de cercles s&apos;écrit #circles</translation>
    </message>
    <message>
        <source>circles[i] takes a number from 1 to %1, not %2</source>
        <translation>circles[i] prend un nombre de 1 à %1, pas %2</translation>
    </message>
    <message>
        <source>circles cannot be added or removed by a program; set the position and velocity of those that are there</source>
        <translation>un programme ne peut ni ajouter ni retirer de cercles&#xa0;; fixez la position et la vitesse de ceux qui sont là</translation>
    </message>
    <message>
        <source>the program needs more than %1 MiB of memory; is there a table or a text that grows without end?</source>
        <translation>le programme demande plus de %1 Mio de mémoire&#xa0;; y a-t-il une table ou un texte qui croît sans fin&#xa0;?</translation>
    </message>
    <message>
        <source>the program called error with %1</source>
        <translation>le programme a appelé error avec %1</translation>
    </message>
    <message>
        <source>this is no text, so it is no program</source>
        <translation>ce n&apos;est pas du texte, donc pas un programme</translation>
    </message>
    <message>
        <source>the author of this step has fixed this: %1. It stays as the scene has it; take this line out</source>
        <translation>l&apos;auteur de cette étape a imposé ceci&#xa0;: %1. Cela reste comme dans la scène&#xa0;; supprimez cette ligne</translation>
    </message>
    <message>
        <source>`%1.%2` is not part of the lab&apos;s Lua; %1 has %3</source>
        <translation>`%1.%2` ne fait pas partie du Lua du TP&#xa0;; %1 a %3</translation>
    </message>
    <message>
        <source>%1 has no `%2`; it has %3</source>
        <translation>%1 n&apos;a pas de `%2`&#xa0;; il y a %3</translation>
    </message>
    <message>
        <source>%1 has no `%2`: did you mean `%1.%3`?</source>
        <translation>%1 n&apos;a pas de `%2`&#xa0;: vouliez-vous dire `%1.%3`&#xa0;?</translation>
    </message>
    <message>
        <source>&apos;%1&apos; expected (to close &apos;%2&apos; at line %3) near %4</source>
        <translation>&apos;%1&apos; attendu (pour fermer &apos;%2&apos; de la ligne %3) près de %4</translation>
    </message>
    <message>
        <source>%1 expected near %2</source>
        <translation>%1 attendu près de %2</translation>
    </message>
    <message>
        <source>unexpected symbol near %1</source>
        <translation>symbole inattendu près de %1</translation>
    </message>
    <message>
        <source>syntax error near %1</source>
        <translation>erreur de syntaxe près de %1</translation>
    </message>
    <message>
        <source>unfinished string near %1</source>
        <translation>texte non terminé près de %1</translation>
    </message>
    <message>
        <source>unfinished long string (starting at line %1)</source>
        <translation>texte long non terminé (commencé à la ligne %1)</translation>
    </message>
    <message>
        <source>unfinished long comment (starting at line %1)</source>
        <translation>commentaire long non terminé (commencé à la ligne %1)</translation>
    </message>
    <message>
        <source>malformed number near %1</source>
        <translation>nombre mal formé près de %1</translation>
    </message>
    <message>
        <source>invalid escape sequence near %1</source>
        <translation>séquence d&apos;échappement incorrecte près de %1</translation>
    </message>
    <message>
        <source>break outside loop at line %1</source>
        <translation>break hors d&apos;une boucle à la ligne %1</translation>
    </message>
    <message>
        <source>no visible label &apos;%1&apos; for goto at line %2</source>
        <translation>aucune étiquette &apos;%1&apos; visible pour le goto de la ligne %2</translation>
    </message>
    <message>
        <source>label &apos;%1&apos; already defined on line %2</source>
        <translation>l&apos;étiquette &apos;%1&apos; est déjà définie à la ligne %2</translation>
    </message>
    <message>
        <source>attempt to assign to const variable &apos;%1&apos;</source>
        <translation>tentative d&apos;affectation à la constante &apos;%1&apos;</translation>
    </message>
    <message>
        <source>attempt to compare two %1 values</source>
        <translation>tentative de comparer deux valeurs de type %1</translation>
    </message>
    <message>
        <source>attempt to compare %1 with %2</source>
        <translation>tentative de comparer %1 avec %2</translation>
    </message>
    <message>
        <source>attempt to divide a whole number by zero</source>
        <translation>tentative de diviser un entier par zéro</translation>
    </message>
    <message>
        <source>attempt to take the rest of a division by zero</source>
        <translation>tentative de prendre le reste d&apos;une division par zéro</translation>
    </message>
    <message>
        <source>%1 and %2 are no two numbers to calculate with</source>
        <translation>%1 et %2 ne sont pas deux nombres avec lesquels calculer</translation>
    </message>
    <message>
        <source>bad argument #%1 to &apos;%2&apos; (%3 expected, got %4)</source>
        <translation>argument n°&#xa0;%1 de &apos;%2&apos; incorrect (%3 attendu, %4 reçu)</translation>
    </message>
    <message>
        <source>bad argument #%1 to &apos;%2&apos; (number has no integer representation)</source>
        <translation>argument n°&#xa0;%1 de &apos;%2&apos; incorrect (le nombre n&apos;est pas représentable comme entier)</translation>
    </message>
    <message>
        <source>bad argument #%1 to &apos;%2&apos; (out of range)</source>
        <translation>argument n°&#xa0;%1 de &apos;%2&apos; incorrect (hors limites)</translation>
    </message>
    <message>
        <source>number has no integer representation</source>
        <translation>le nombre n&apos;est pas représentable comme entier</translation>
    </message>
    <message>
        <source>the first value of &apos;for&apos; must be a number</source>
        <translation>la première valeur de &apos;for&apos; doit être un nombre</translation>
    </message>
    <message>
        <source>the last value of &apos;for&apos; must be a number</source>
        <translation>la dernière valeur de &apos;for&apos; doit être un nombre</translation>
    </message>
    <message>
        <source>the step of &apos;for&apos; must be a number</source>
        <translation>le pas de &apos;for&apos; doit être un nombre</translation>
    </message>
    <message>
        <source>the step of &apos;for&apos; is zero</source>
        <translation>le pas de &apos;for&apos; est zéro</translation>
    </message>
    <message>
        <source>assertion failed!</source>
        <translation>l&apos;assertion a échoué&#xa0;!</translation>
    </message>
    <message>
        <source>&lt;eof&gt;</source>
        <extracomment>the end of the program</extracomment>
        <translation>la fin du programme</translation>
    </message>
    <message>
        <source>&lt;name&gt;</source>
        <translation>un nom</translation>
    </message>
    <message>
        <source>this value</source>
        <translation>cette valeur</translation>
    </message>
    <message>
        <source>%1 is %2, so it has no fields</source>
        <translation>%1 est %2, donc sans champs</translation>
    </message>
    <message>
        <source>%1 is %2, not a function that can be called</source>
        <translation>%1 est %2, pas une fonction que l&apos;on peut appeler</translation>
    </message>
    <message>
        <source>%1 is %2, not a number to calculate with</source>
        <translation>%1 est %2, pas un nombre avec lequel calculer</translation>
    </message>
    <message>
        <source>%1 is %2, so .. cannot join it to a text</source>
        <translation>%1 est %2, et .. ne peut donc pas le joindre à un texte</translation>
    </message>
    <message>
        <source>%1 is %2, so it has no length</source>
        <translation>%1 est %2, donc sans longueur</translation>
    </message>
    <message>
        <source>%1; only numbers compare with numbers (the length of a vector is v:length())</source>
        <translation>%1&#xa0;; seuls des nombres se comparent à des nombres (la longueur d&apos;un vecteur est v:length())</translation>
    </message>
    <message>
        <source>a function calls itself without end (stack overflow)</source>
        <translation>une fonction s&apos;appelle elle-même sans fin (débordement de pile)</translation>
    </message>
    <message>
        <source>. There is no circles[%1]: circles are counted from 1 to %2</source>
        <translation>. Il n&apos;y a pas de circles[%1]&#xa0;: les cercles sont numérotés de 1 à %2</translation>
    </message>
    <message>
        <source>. The length of a list is #%1</source>
        <translation>. La longueur d&apos;une liste est #%1</translation>
    </message>
    <message>
        <source>. Texts are joined by .., not by +</source>
        <translation>. Les textes se joignent par .., pas par +</translation>
    </message>
    <message>
        <source>. A function is called with its parentheses, and that of a vector with a colon: v:length()</source>
        <translation>. Une fonction s&apos;appelle avec ses parenthèses, et celle d&apos;un vecteur avec un deux-points&#xa0;: v:length()</translation>
    </message>
    <message>
        <source>`%1.%2` is %3 in Lua</source>
        <translation>`%1.%2` s&apos;écrit %3 en Lua</translation>
    </message>
    <message>
        <source>Lua has no null; nothing is written nil</source>
        <translation>Lua n&apos;a pas de null&#xa0;; rien s&apos;écrit nil</translation>
    </message>
    <message>
        <source>there is no `%1` here; the circles are circle1, circle2 …, and what is your own has its plain name</source>
        <translation>il n&apos;y a pas de `%1` ici&#xa0;; les cercles sont circle1, circle2 …, et ce qui est à vous porte son simple nom</translation>
    </message>
    <message>
        <source>Lua has no `new`; a vector is made by vec(x, y), a table by {}</source>
        <translation>Lua n&apos;a pas de `new`&#xa0;; un vecteur se fait par vec(x, y), une table par {}</translation>
    </message>
    <message>
        <source>`%1` is not known; a vector is made by vec(x, y)</source>
        <translation>`%1` n&apos;est pas connu&#xa0;; un vecteur se fait par vec(x, y)</translation>
    </message>
    <message>
        <source>`%1` is not known; print(…) writes to the console</source>
        <translation>`%1` n&apos;est pas connu&#xa0;; print(…) écrit dans la console</translation>
    </message>
    <message>
        <source>`%1` is not known; // divides, a comment begins with -- in Lua</source>
        <translation>`%1` n&apos;est pas connu&#xa0;; // divise, un commentaire commence par -- en Lua</translation>
    </message>
    <message>
        <source>`%1` is not known yet: it is local and stands below, in line %2; move it up, or leave out `local`</source>
        <translation>`%1` n&apos;est pas encore connu&#xa0;: il est local et se trouve plus bas, à la ligne %2&#xa0;; déplacez-le plus haut, ou supprimez `local`</translation>
    </message>
    <message>
        <source>`%1` is not known here: it is local to the block of line %2; declare it before that block</source>
        <translation>`%1` n&apos;est pas connu ici&#xa0;: il est local au bloc de la ligne %2&#xa0;; déclarez-le avant ce bloc</translation>
    </message>
    <message>
        <source>pairs needs keys that have an order: numbers, texts, circles. Of tables, functions and equal vectors there may be one; keep them in a list and go through it with ipairs</source>
        <translation>pairs a besoin de clés qui ont un ordre&#xa0;: nombres, textes, cercles. De tables, de fonctions et de vecteurs égaux, il ne peut y en avoir qu&apos;un&#xa0;; gardez-les dans une liste et parcourez-la avec ipairs</translation>
    </message>
    <message>
        <source>pairs goes through a table or circles, not %1</source>
        <translation>pairs parcourt une table ou circles, pas %1</translation>
    </message>
    <message>
        <source>Lua has no foreach; write: for _, %1 in ipairs(%2) do … end</source>
        <translation>Lua n&apos;a pas de foreach&#xa0;; écrivez&#xa0;: for _, %1 in ipairs(%2) do … end</translation>
    </message>
    <message>
        <source>a loop that counts is written: for %1 = first, last do … end, both included</source>
        <translation>une boucle qui compte s&apos;écrit&#xa0;: for %1 = début, fin do … end, bornes comprises</translation>
    </message>
    <message>
        <source>Lua has no =&gt;; a function is function(x) return … end, and &quot;greater or equal&quot; is &gt;=</source>
        <translation>Lua n&apos;a pas de =&gt;&#xa0;; une fonction est function(x) return … end, et «&#xa0;supérieur ou égal&#xa0;» est &gt;=</translation>
    </message>
    <message>
        <source>Lua has no ? : to choose; write: if … then … else … end, or: condition and a or b</source>
        <translation>Lua n&apos;a pas de&#xa0;?&#xa0;: pour choisir&#xa0;; écrivez&#xa0;: if … then … else … end, ou&#xa0;: condition and a or b</translation>
    </message>
    <message>
        <source>Lua has no %2=; write %1 = %1 %2 %3</source>
        <translation>Lua n&apos;a pas de %2=&#xa0;; écrivez %1 = %1 %2 %3</translation>
    </message>
    <message>
        <source>&quot;not equal&quot; is ~= in Lua, not !=</source>
        <translation>«&#xa0;différent&#xa0;» s&apos;écrit ~= en Lua, pas&#xa0;!=</translation>
    </message>
    <message>
        <source>Lua has no ++; write %1 = %1 + 1</source>
        <translation>Lua n&apos;a pas de ++&#xa0;; écrivez %1 = %1 + 1</translation>
    </message>
    <message>
        <source>Lua writes `and`, `or`, `not` in words</source>
        <translation>Lua écrit `and`, `or`, `not` en toutes lettres</translation>
    </message>
    <message>
        <source>Lua writes `not` in words, not !</source>
        <translation>Lua écrit `not` en toutes lettres, pas&#xa0;!</translation>
    </message>
    <message>
        <source>Lua names no types; a function is written: function %1(…) … end</source>
        <translation>Lua ne nomme pas les types&#xa0;; une fonction s&apos;écrit&#xa0;: function %1(…) … end</translation>
    </message>
    <message>
        <source>Lua names no types; write: local %1 = …</source>
        <translation>Lua ne nomme pas les types&#xa0;; écrivez&#xa0;: local %1 = …</translation>
    </message>
    <message>
        <source>Lua names no types; of a parameter write only the name: %1</source>
        <translation>Lua ne nomme pas les types&#xa0;; d&apos;un paramètre, n&apos;écrivez que le nom&#xa0;: %1</translation>
    </message>
    <message>
        <source>Lua has no `%1`</source>
        <translation>Lua n&apos;a pas de `%1`</translation>
    </message>
    <message>
        <source>Lua has no `continue`; put what it leaves out into an if</source>
        <translation>Lua n&apos;a pas de `continue`&#xa0;; mettez ce qu&apos;il saute dans un if</translation>
    </message>
    <message>
        <source>a comment begins with -- in Lua</source>
        <translation>un commentaire commence par -- en Lua</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; write: if … then … else … end</source>
        <translation>Lua n&apos;a pas d&apos;accolades autour des blocs&#xa0;; écrivez&#xa0;: if … then … else … end</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; write: while … do … end</source>
        <translation>Lua n&apos;a pas d&apos;accolades autour des blocs&#xa0;; écrivez&#xa0;: while … do … end</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; write: for … do … end</source>
        <translation>Lua n&apos;a pas d&apos;accolades autour des blocs&#xa0;; écrivez&#xa0;: for … do … end</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; write: function name(…) … end</source>
        <translation>Lua n&apos;a pas d&apos;accolades autour des blocs&#xa0;; écrivez&#xa0;: function nom(…) … end</translation>
    </message>
    <message>
        <source>Lua has no braces around blocks; a block ends with `end`</source>
        <translation>Lua n&apos;a pas d&apos;accolades autour des blocs&#xa0;; un bloc finit par `end`</translation>
    </message>
    <message>
        <source>= assigns; to compare write ==</source>
        <translation>= affecte&#xa0;; pour comparer, écrivez ==</translation>
    </message>
    <message>
        <source>== compares; to assign write =</source>
        <translation>== compare&#xa0;; pour affecter, écrivez =</translation>
    </message>
    <message>
        <source>names have the letters a to z, digits and _ only</source>
        <translation>les noms n&apos;ont que les lettres a à z, des chiffres et _</translation>
    </message>
    <message>
        <source>Lua has no --, which begins a comment; write %1 = %1 - 1</source>
        <translation>Lua n&apos;a pas de --, qui commence un commentaire&#xa0;; écrivez %1 = %1 - 1</translation>
    </message>
    <message>
        <source>return ends its block: nothing may follow it there but end, else or elseif</source>
        <translation>return termine son bloc&#xa0;: rien ne peut le suivre là, sauf end, else ou elseif</translation>
    </message>
    <message>
        <source>here `%1` is missing</source>
        <translation>ici il manque `%1`</translation>
    </message>
    <message>
        <source>an `end` is missing: `else if` begins a second if, which needs an `end` of its own; the one word elseif does not</source>
        <translation>il manque un `end`&#xa0;: `else if` commence un second if, auquel il faut son propre `end`&#xa0;; elseif, en un seul mot, n&apos;en a pas besoin</translation>
    </message>
    <message>
        <source>write %1, with a colon</source>
        <translation>écrivez %1, avec un deux-points</translation>
    </message>
    <message>
        <source>the moment must be a number of seconds from 0 to %1, not %2</source>
        <translation>l&apos;instant doit être un nombre de secondes de 0 à %1, pas %2</translation>
    </message>
    <message>
        <source>this must be a whole number from %1 to %2, not %3</source>
        <translation>ce doit être un nombre entier de %1 à %2, pas %3</translation>
    </message>
    <message>
        <source>this step does as much work as %1 million instructions (what is done to long texts and lists counts by their length); is there a loop that does not end?</source>
        <translation>ce pas fait autant de travail que %1 millions d&apos;instructions (ce qui est fait de longs textes et de longues listes compte selon leur longueur)&#xa0;; y a-t-il une boucle qui ne finit pas&#xa0;?</translation>
    </message>
    <message>
        <source>this step takes more than %1 million instructions; is there a loop that does not end?</source>
        <translation>ce pas demande plus de %1 millions d&apos;instructions&#xa0;; y a-t-il une boucle qui ne finit pas&#xa0;?</translation>
    </message>
    <message>
        <source>this step has run for more than %1 s; is there a loop that does not end?</source>
        <translation>ce pas dure depuis plus de %1 s&#xa0;; y a-t-il une boucle qui ne finit pas&#xa0;?</translation>
    </message>
    <message>
        <source>the run was stopped</source>
        <translation>l&apos;exécution a été arrêtée</translation>
    </message>
    <message>
        <source>functions call each other %1 deep; does one call itself without end?</source>
        <translation>des fonctions s&apos;appellent sur une profondeur de %1&#xa0;; l&apos;une d&apos;elles s&apos;appelle-t-elle elle-même sans fin&#xa0;?</translation>
    </message>
    <message>
        <source>the program has %1 letters; at most %2 are right</source>
        <translation>le programme a %1 caractères&#xa0;; au plus %2 conviennent</translation>
    </message>
    <message>
        <source>there is no memory to run a program</source>
        <translation>il n&apos;y a pas de mémoire pour exécuter un programme</translation>
    </message>
    <message>
        <source>`%1` is local here, so nobody can call it; write function %1(…) without local</source>
        <translation>`%1` est local ici, personne ne peut donc l&apos;appeler&#xa0;; écrivez function %1(…) sans local</translation>
    </message>
    <message>
        <source>the program shows more than %1 KiB in one step</source>
        <translation>le programme montre plus de %1 Kio en un pas</translation>
    </message>
    <message>
        <source>%1 must be a text, not %2</source>
        <translation>%1 doit être un texte, pas %2</translation>
    </message>
    <message>
        <source>the name in plot(name, number)</source>
        <translation>le nom dans plot(name, number)</translation>
    </message>
    <message>
        <source>the name in plot(name, number) must have 1 to %1 letters</source>
        <translation>le nom dans plot(name, number) doit avoir de 1 à %1 caractères</translation>
    </message>
    <message>
        <source>plot(name, number) takes a number, not %1</source>
        <translation>plot(name, number) prend un nombre, pas %1</translation>
    </message>
    <message>
        <source>plot(&quot;%1&quot;, …) would be %2; a finite number is right</source>
        <translation>plot(&quot;%1&quot;, …) vaudrait %2&#xa0;; il faut un nombre fini</translation>
    </message>
    <message>
        <source>%1 would draw at %2; finite numbers are right</source>
        <translation>%1 dessinerait en %2&#xa0;; il faut des nombres finis</translation>
    </message>
    <message>
        <source>%1 would end beyond all numbers</source>
        <translation>%1 finirait au-delà de tous les nombres</translation>
    </message>
    <message>
        <source>a colour</source>
        <translation>une couleur</translation>
    </message>
    <message>
        <source>a label</source>
        <translation>une étiquette</translation>
    </message>
    <message>
        <source>the text in draw.text(p, text)</source>
        <translation>le texte dans draw.text(p, text)</translation>
    </message>
    <message>
        <source>draw has no `%1`; it has %2</source>
        <translation>draw n&apos;a pas de `%1`&#xa0;; il a %2</translation>
    </message>
    <message>
        <source>draw has no `%1`: did you mean `%2`?</source>
        <translation>draw n&apos;a pas de `%1`&#xa0;: vouliez-vous dire `%2`&#xa0;?</translation>
    </message>
    <message>
        <source>square has no `%1`; it has %2</source>
        <translation>square n&apos;a pas de `%1`&#xa0;; il a %2</translation>
    </message>
    <message>
        <source>square has no `%1`: did you mean `%2`?</source>
        <translation>square n&apos;a pas de `%1`&#xa0;: vouliez-vous dire `%2`&#xa0;?</translation>
    </message>
    <message>
        <source>the square can only be read</source>
        <translation>le carré peut seulement être lu</translation>
    </message>
    <message>
        <source>there is no field `%1` here; there are %2</source>
        <translation>il n&apos;y a pas de champ `%1` ici&#xa0;; il y a %2</translation>
    </message>
    <message>
        <source>there is no field `%1` here: did you mean `%2`?</source>
        <translation>il n&apos;y a pas de champ `%1` ici&#xa0;: vouliez-vous dire `%2`&#xa0;?</translation>
    </message>
    <message>
        <source>after on_load the scene cannot be run: %1</source>
        <translation>après on_load, la scène ne peut pas tourner&#xa0;: %1</translation>
    </message>
    <message>
        <source>`on_update` is no function any more; it is given once: function on_update(timestep) … end</source>
        <translation>`on_update` n&apos;est plus une fonction&#xa0;; elle se donne une fois&#xa0;: function on_update(timestep) … end</translation>
    </message>
    <message>
        <source>%p of string.format is not part of the lab&apos;s Lua: an address is another in every run</source>
        <translation>%p de string.format ne fait pas partie du Lua du TP&#xa0;: une adresse est différente à chaque exécution</translation>
    </message>
    <message>
        <source>the vector %1</source>
        <translation>le vecteur %1</translation>
    </message>
    <message>
        <source>the number %1</source>
        <translation>le nombre %1</translation>
    </message>
    <message>
        <source>the text %1</source>
        <translation>le texte %1</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>une table</translation>
    </message>
    <message>
        <source>a function</source>
        <translation>une fonction</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>%1 %2 %3 has no meaning: %4</source>
        <translation>%1 %2 %3 n&apos;a pas de sens&#xa0;: %4</translation>
    </message>
    <message>
        <source>a vector is added to a vector</source>
        <translation>un vecteur s&apos;ajoute à un vecteur</translation>
    </message>
    <message>
        <source>a vector is taken from a vector</source>
        <translation>un vecteur se retranche d&apos;un vecteur</translation>
    </message>
    <message>
        <source>a vector is multiplied by a number; for the dot product write a:dot(b)</source>
        <translation>un vecteur se multiplie par un nombre&#xa0;; pour le produit scalaire, écrivez a:dot(b)</translation>
    </message>
    <message>
        <source>a vector is divided by a number</source>
        <translation>un vecteur se divise par un nombre</translation>
    </message>
    <message>
        <source>a vector has no `%1`; it has %2</source>
        <translation>un vecteur n&apos;a pas de `%1`&#xa0;; il a %2</translation>
    </message>
    <message>
        <source>a vector has no `%1`: did you mean `%2`?</source>
        <translation>un vecteur n&apos;a pas de `%1`&#xa0;: vouliez-vous dire `%2`&#xa0;?</translation>
    </message>
    <message>
        <source>a vector cannot be changed; build a new one: %1 = %2</source>
        <translation>un vecteur ne peut pas être changé&#xa0;; construisez-en un nouveau&#xa0;: %1 = %2</translation>
    </message>
    <message>
        <source>`%1` belongs to a vector; write v:%1(), with a colon</source>
        <translation>`%1` appartient à un vecteur&#xa0;; écrivez v:%1(), avec un deux-points</translation>
    </message>
    <message>
        <source>the vector (0, 0) has no direction, so it cannot be normalized</source>
        <translation>le vecteur (0, 0) n&apos;a pas de direction et ne peut donc pas être normalisé</translation>
    </message>
    <message>
        <source>vec(x, y) takes two numbers; %1 is %2</source>
        <translation>vec(x, y) prend deux nombres&#xa0;; %1 est %2</translation>
    </message>
    <message>
        <source>vec(x, y) takes two numbers, not %1</source>
        <translation>vec(x, y) prend deux nombres, pas %1</translation>
    </message>
    <message>
        <source>%1 needs a vector, not %2</source>
        <translation>%1 a besoin d&apos;un vecteur, pas %2</translation>
    </message>
    <message>
        <source>dot got one vector and takes two: write a:dot(b) with a colon, or dot(a, b)</source>
        <translation>dot a reçu un vecteur et en prend deux&#xa0;: écrivez a:dot(b) avec deux-points, ou dot(a, b)</translation>
    </message>
    <message>
        <source>`%1` is not known: nothing of that name was given a value before</source>
        <translation>`%1` n&apos;est pas connu&#xa0;: rien de ce nom n&apos;a reçu de valeur auparavant</translation>
    </message>
    <message>
        <source>there is no %1: the scene has 1 circle</source>
        <translation>il n&apos;y a pas de %1&#xa0;: la scène a 1 cercle</translation>
    </message>
    <message>
        <source>there is no %1: the scene has %2 circles</source>
        <translation>il n&apos;y a pas de %1&#xa0;: la scène a %2 cercles</translation>
    </message>
    <message>
        <source>`%1` is not known: did you mean `%2`?</source>
        <translation>`%1` n&apos;est pas connu&#xa0;: vouliez-vous dire `%2`&#xa0;?</translation>
    </message>
    <message>
        <source>`%1` is set once, in on_load; in on_update it can only be read</source>
        <translation>`%1` se fixe une fois, dans on_load&#xa0;; dans on_update, on peut seulement le lire</translation>
    </message>
    <message>
        <source>gravity would be %1 m/s²; at most %2 is right</source>
        <translation>gravity vaudrait %1 m/s²&#xa0;; au plus %2 convient</translation>
    </message>
    <message>
        <source>restitution must be a number from 0 to 1, not %1</source>
        <translation>restitution doit être un nombre de 0 à 1, pas %1</translation>
    </message>
    <message>
        <source>`%1` can only be read; choose another name for a variable of your own</source>
        <translation>`%1` peut seulement être lu&#xa0;; choisissez un autre nom pour une variable à vous</translation>
    </message>
    <message>
        <source>`%1` is given by the lab and cannot be replaced; choose another name for a variable of your own</source>
        <translation>`%1` est donné par le TP et ne peut pas être remplacé&#xa0;; choisissez un autre nom pour une variable à vous</translation>
    </message>
    <message>
        <source>`%1` must be a function, not %2</source>
        <translation>`%1` doit être une fonction, pas %2</translation>
    </message>
    <message>
        <source>`%1` is not known yet: a local can be used only after the statement that makes it</source>
        <translation>`%1` n&apos;est pas encore connu&#xa0;: une variable locale ne peut servir qu&apos;après l&apos;instruction qui la crée</translation>
    </message>
    <message>
        <source>`%1` is not known here; how long a step lasts is the parameter of on_update, which other functions get as an argument</source>
        <translation>`%1` n&apos;est pas connu ici&#xa0;; la durée d&apos;un pas est le paramètre de on_update, que les autres fonctions reçoivent en argument</translation>
    </message>
    <message>
        <source>`%1` is not part of the lab&apos;s Lua; see the API page (F1) for what is</source>
        <translation>`%1` ne fait pas partie du Lua du TP&#xa0;; voir la page de l&apos;API (F1) pour ce qui en fait partie</translation>
    </message>
    <message>
        <source>. Look at what the call in line %1 gives for it</source>
        <translation>. Regardez ce que l&apos;appel de la ligne %1 donne pour lui</translation>
    </message>
    <message>
        <source>`%1` is not known here: it is local to another block, in line %2; a function gets what it needs as an argument, or makes it itself</source>
        <translation>`%1` n&apos;est pas connu ici&#xa0;: il est local à un autre bloc, à la ligne %2&#xa0;; ce dont une fonction a besoin lui est donné en argument, ou elle le fait elle-même</translation>
    </message>
    <message>
        <source>%1 has no field `%2`: it belongs to the whole world; write `%2` alone</source>
        <translation>%1 n&apos;a pas de champ `%2`&#xa0;: cela appartient au monde entier&#xa0;; écrivez `%2` tout court</translation>
    </message>
    <message>
        <source>%1 must be a vector, not nil: what it is to become has no value here</source>
        <translation>%1 doit être un vecteur, pas nil&#xa0;: ce qu&apos;on lui donne n&apos;a pas de valeur ici</translation>
    </message>
    <message>
        <source>%1 would be %2 here: the comma ends a value; a number has a point, %2.%3</source>
        <translation>%1 vaudrait %2 ici&#xa0;: la virgule termine une valeur&#xa0;; un nombre s&apos;écrit avec un point, %2.%3</translation>
    </message>
    <message>
        <source>a vector is multiplied by a number</source>
        <translation>un vecteur se multiplie par un nombre</translation>
    </message>
    <message>
        <source>gravity must be a vector in m/s², not %1; write gravity = vec(0, %2)</source>
        <translation>gravity doit être un vecteur en m/s², pas %1&#xa0;; écrivez gravity = vec(0, %2)</translation>
    </message>
    <message>
        <source>parentheses, blocks or terms are nested too deeply</source>
        <translation>parenthèses, blocs ou termes sont trop imbriqués</translation>
    </message>
    <message>
        <source>%1 is not the minus of Lua; write -</source>
        <translation>%1 n&apos;est pas le moins de Lua&#xa0;; écrivez -</translation>
    </message>
    <message>
        <source>Lua does not know the sign %1</source>
        <translation>Lua ne connaît pas le signe %1</translation>
    </message>
</context>
<context>
    <name>Trails</name>
    <message>
        <source>centre of mass</source>
        <translation>centre de masse</translation>
    </message>
</context>
<context>
    <name>UnifiedDiff</name>
    <message>
        <source>this is no line of a difference; “@@ -4,3 +4,2 @@” or a line after blank, minus or plus is right</source>
        <translation>ce n&apos;est pas une ligne d&apos;une différence&#xa0;; il faut «&#xa0;@@ -4,3 +4,2 @@&#xa0;» ou une ligne après une espace, un moins ou un plus</translation>
    </message>
    <message>
        <source>the lines that this changes are not there any more</source>
        <translation>les lignes que ceci modifie ne sont plus là</translation>
    </message>
</context>
<context>
    <name>Variant</name>
    <message>
        <source>timestep 1/%1 s</source>
        <translation>pas de temps 1/%1 s</translation>
    </message>
    <message>
        <source>throw %1</source>
        <translation>lancer %1</translation>
    </message>
    <message>
        <source>circle %1 towards %2°</source>
        <translation>cercle %1 vers %2°</translation>
    </message>
    <message>
        <source>drop %1</source>
        <translation>chute %1</translation>
    </message>
    <message>
        <source>slow hit %1</source>
        <translation>choc lent %1</translation>
    </message>
    <message>
        <source>contact at %1°</source>
        <translation>contact à %1°</translation>
    </message>
    <message>
        <source>parting at %1°</source>
        <translation>séparation à %1°</translation>
    </message>
    <message>
        <source>contact %1, in front of a wall</source>
        <translation>contact %1, devant une paroi</translation>
    </message>
    <message>
        <source>slowly to one side</source>
        <translation>lentement vers un côté</translation>
    </message>
    <message>
        <source>slowly to the other side</source>
        <translation>lentement vers l&apos;autre côté</translation>
    </message>
    <message>
        <source>let go low %1</source>
        <translation>lâché de bas %1</translation>
    </message>
    <message>
        <source>two hits on one line %1</source>
        <translation>deux chocs sur une ligne %1</translation>
    </message>
</context>
<context>
    <name>Workspace</name>
    <message>
        <source>the history of your work cannot be kept: %1</source>
        <translation>l&apos;historique de votre travail ne peut pas être conservé&#xa0;: %1</translation>
    </message>
    <message>
        <source>there is no git repository at this address</source>
        <translation>il n&apos;y a pas de dépôt git à cette adresse</translation>
    </message>
    <message>
        <source>there is other work at this address, which yours does not go on from; give another address</source>
        <translation>il y a un autre travail à cette adresse, que le vôtre ne prolonge pas&#xa0;; donnez une autre adresse</translation>
    </message>
    <message>
        <source>this is no address of a git repository</source>
        <translation>ce n&apos;est pas l&apos;adresse d&apos;un dépôt git</translation>
    </message>
    <message>
        <source>there is no address to share with yet</source>
        <translation>il n&apos;y a pas encore d&apos;adresse avec laquelle partager</translation>
    </message>
    <message>
        <source>your work could not be sent: %1</source>
        <translation>votre travail n&apos;a pas pu être envoyé&#xa0;: %1</translation>
    </message>
    <message>
        <source>the other side did not take your work: %1</source>
        <translation>le dépôt distant n&apos;a pas accepté votre travail&#xa0;: %1</translation>
    </message>
    <message>
        <source>your program cannot be saved here: %1</source>
        <translation>votre programme ne peut pas être enregistré ici&#xa0;: %1</translation>
    </message>
    <message>
        <source>another window works on this lab now; this one saves nothing more, and what was typed last here is among the versions of the step</source>
        <translation>une autre fenêtre travaille maintenant sur ce TP&#xa0;; celle-ci n&apos;enregistre plus rien, et ce qui a été tapé ici en dernier est parmi les versions de l&apos;étape</translation>
    </message>
    <message>
        <source>the file cannot be moved aside</source>
        <translation>le fichier ne peut pas être mis de côté</translation>
    </message>
    <message>
        <source>your work cannot be saved here: %1</source>
        <translation>votre travail ne peut pas être enregistré ici&#xa0;: %1</translation>
    </message>
    <message>
        <source>this does not say whose work it is, as cradle.json of format 1 does</source>
        <translation>ceci ne dit pas à qui est le travail, comme le fait un cradle.json au format 1</translation>
    </message>
    <message>
        <source>another window works on this lab now; this one saves nothing more</source>
        <translation>une autre fenêtre travaille maintenant sur ce TP&#xa0;; celle-ci n&apos;enregistre plus rien</translation>
    </message>
    <message>
        <source>another program has changed this note; yours stays, and the other is kept in git as refs/cradle/notes/%1</source>
        <translation>un autre programme a modifié cette remarque&#xa0;; la vôtre reste, et l&apos;autre est gardée dans git sous refs/cradle/notes/%1</translation>
    </message>
    <message>
        <source>this file is no note; it is kept as %1</source>
        <translation>ce fichier n&apos;est pas une remarque&#xa0;; il est gardé sous %1</translation>
    </message>
</context>
<context>
    <name>cradle::Announcer</name>
    <message>
        <source>Hit at %1 s: %2 and %3, impulse %4 N s</source>
        <translation>Choc à %1 s&#xa0;: %2 et %3, impulsion %4 N s</translation>
    </message>
</context>
<context>
    <name>cradle::ApiPage</name>
    <message>
        <source>:/help/lua-api.md</source>
        <extracomment>The file of the page in your language: docs/lua-api.LANGUAGE.md, if there is one</extracomment>
        <translation>:/help/lua-api.fr.md</translation>
    </message>
    <message>
        <source>API reference</source>
        <translation>Référence de l&apos;API</translation>
    </message>
    <message>
        <source>Search (Return: next place in the text)</source>
        <translation>Rechercher (Entrée&#xa0;: occurrence suivante)</translation>
    </message>
    <message>
        <source>Search the API reference</source>
        <translation>Rechercher dans la référence de l&apos;API</translation>
    </message>
    <message>
        <source>Entries of the API reference</source>
        <translation>Entrées de la référence de l&apos;API</translation>
    </message>
    <message>
        <source>Not found in the reference: %1</source>
        <translation>Introuvable dans la référence&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>cradle::ArrangementDialog</name>
    <message>
        <source>Rows</source>
        <translation>Rangées</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Cercles</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Gap between rims</source>
        <translation>Écart entre les bords</translation>
    </message>
    <message>
        <source>One more comes from the left</source>
        <translation>Un de plus vient de la gauche</translation>
    </message>
    <message numerus="yes">
        <source>%n circle(s)</source>
        <translation>
            <numerusform>%n cercle</numerusform>
            <numerusform>%n cercles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::AuthorDocument</name>
    <message>
        <source>This lab ships with Cradle and stays as it is; make a copy of it to change that</source>
        <translation>Ce TP est fourni avec Cradle et reste comme il est&#xa0;; faites-en une copie pour y changer quelque chose</translation>
    </message>
    <message>
        <source>New lab</source>
        <translation>Nouveau TP</translation>
    </message>
    <message>
        <source>Changes that were not saved</source>
        <translation>Changements non enregistrés</translation>
    </message>
    <message>
        <source>the folder is not empty; a new or an empty one is right</source>
        <translation>le dossier n&apos;est pas vide&#xa0;; il en faut un nouveau ou un vide</translation>
    </message>
    <message>
        <source>Reload from the folder</source>
        <translation>Recharger depuis le dossier</translation>
    </message>
    <message>
        <source>Take what another program changed</source>
        <translation>Prendre ce qu&apos;un autre programme a changé</translation>
    </message>
</context>
<context>
    <name>cradle::AuthorExports</name>
    <message>
        <source>Labs (*.cradle);;All files (*)</source>
        <translation>TP (*.cradle);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Not all of it can be read</source>
        <translation>Tout n&apos;est pas lisible</translation>
    </message>
    <message>
        <source>Students will not find what cannot be read:</source>
        <translation>Les étudiants ne trouveront pas ce qui est illisible&#xa0;:</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Exporter quand même</translation>
    </message>
    <message>
        <source>Export the lab for students</source>
        <translation>Exporter le TP pour les étudiants</translation>
    </message>
    <message numerus="yes">
        <source>Exported without %n file(s) that are yours: %1</source>
        <translation>
            <numerusform>Exporté sans %n fichier qui n&apos;est que pour vous&#xa0;: %1</numerusform>
            <numerusform>Exporté sans %n fichiers qui ne sont que pour vous&#xa0;: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>In %1 students are told what checks saw, and not which law is wrong.</source>
        <translation>Dans %1, les étudiants lisent ce que les vérifications ont vu, et non quelle loi est fausse.</translation>
    </message>
    <message>
        <source>Export the lab as one file</source>
        <translation>Exporter le TP en un seul fichier</translation>
    </message>
    <message>
        <source>Exported: %1</source>
        <translation>Exporté&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>cradle::AuthorFiles</name>
    <message>
        <source>New lab</source>
        <translation>Nouveau TP</translation>
    </message>
    <message>
        <source>Title of the lab:</source>
        <translation>Titre du TP&#xa0;:</translation>
    </message>
    <message>
        <source>My lab</source>
        <translation>Mon TP</translation>
    </message>
    <message>
        <source>Open a lab&apos;s folder</source>
        <translation>Ouvrir le dossier d&apos;un TP</translation>
    </message>
    <message>
        <source>Open a lab in one file</source>
        <translation>Ouvrir un TP en un seul fichier</translation>
    </message>
    <message>
        <source>Labs (*.cradle);;All files (*)</source>
        <translation>TP (*.cradle);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Replace with mine</source>
        <translation>Remplacer par les miens</translation>
    </message>
    <message>
        <source>Take theirs</source>
        <translation>Prendre les leurs</translation>
    </message>
    <message>
        <source>You have changes that are not saved. If you take the files of the folder instead, Undo brings yours back.</source>
        <translation>Vous avez des changements non enregistrés. Si vous prenez les fichiers du dossier à la place, Annuler fait revenir les vôtres.</translation>
    </message>
    <message>
        <source>Saved, but for fields that hold no value yet: %1</source>
        <translation>Enregistré, sauf les champs qui ne contiennent pas encore de valeur&#xa0;: %1</translation>
    </message>
    <message>
        <source>A new or empty folder for the lab</source>
        <translation>Un dossier nouveau ou vide pour le TP</translation>
    </message>
    <message>
        <source>Folder:</source>
        <translation>Dossier&#xa0;:</translation>
    </message>
    <message>
        <source>Drop what was typed?</source>
        <translation>Abandonner ce qui a été saisi&#xa0;?</translation>
    </message>
    <message>
        <source>What is typed here is no value yet, and is not in the lab: %1</source>
        <translation>Ce qui est saisi ici n&apos;est pas encore une valeur et n&apos;est pas dans le TP&#xa0;: %1</translation>
    </message>
    <message>
        <source>Save the lab?</source>
        <translation>Enregistrer le TP&#xa0;?</translation>
    </message>
    <message>
        <source>The lab has changes that are not saved.</source>
        <translation>Le TP a des changements non enregistrés.</translation>
    </message>
</context>
<context>
    <name>cradle::AuthorNotices</name>
    <message>
        <source>A scene of the proof, at the moment where it went wrong: %1</source>
        <translation>Une scène de la preuve, à l&apos;instant où cela a échoué&#xa0;: %1</translation>
    </message>
    <message>
        <source>This lab ships with Cradle and stays as it is. Look around, or make a copy of it and change that.</source>
        <translation>Ce TP est fourni avec Cradle et reste comme il est. Regardez-le, ou faites-en une copie et modifiez-la.</translation>
    </message>
    <message>
        <source>Copy to a folder…</source>
        <translation>Copier dans un dossier…</translation>
    </message>
    <message>
        <source>Changed by another program: %1</source>
        <translation>Modifié par un autre programme&#xa0;: %1</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recharger</translation>
    </message>
    <message>
        <source>Discard them</source>
        <translation>Les abandonner</translation>
    </message>
    <message>
        <source>Cradle ended without saving this lab. Your changes of %1 are back; they are not saved yet.</source>
        <translation>Cradle s&apos;est terminé sans enregistrer ce TP. Vos changements du %1 sont revenus&#xa0;; ils ne sont pas encore enregistrés.</translation>
    </message>
    <message>
        <source>Cradle ended before a new lab was saved for the first time.</source>
        <translation>Cradle s&apos;est terminé avant qu&apos;un nouveau TP soit enregistré pour la première fois.</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>L&apos;ouvrir</translation>
    </message>
</context>
<context>
    <name>cradle::AuthorWindow</name>
    <message>
        <source>Insert a figure</source>
        <translation>Insérer une figure</translation>
    </message>
    <message>
        <source>The scene at %1 s</source>
        <translation>La scène à %1 s</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>pas encore enregistré</translation>
    </message>
    <message>
        <source>read only</source>
        <translation>lecture seule</translation>
    </message>
</context>
<context>
    <name>cradle::BrokenFile</name>
    <message>
        <source>Mend %1</source>
        <translation>Réparer %1</translation>
    </message>
    <message>
        <source>Until it can be read, nothing else of this step can be edited. Mend it here; the tabs come back by themselves.</source>
        <translation>Tant que ce fichier n&apos;est pas lisible, rien d&apos;autre de cette étape ne peut être modifié. Réparez-le ici&#xa0;; les onglets reviennent d&apos;eux-mêmes.</translation>
    </message>
    <message>
        <source>Text of the file that cannot be read</source>
        <translation>Texte du fichier illisible</translation>
    </message>
    <message>
        <source>Until it can be read, nothing of the lab can be edited. Mend it here; the steps come back by themselves.</source>
        <translation>Tant qu&apos;il ne peut pas être lu, rien du TP ne peut être modifié. Réparez-le ici&#xa0;; les étapes reviennent d&apos;elles-mêmes.</translation>
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
        <source>%1 over time</source>
        <translation>%1 au cours du temps</translation>
    </message>
    <message>
        <source>%1 over time, %2</source>
        <translation>%1 au cours du temps, %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Show the last %1 seconds</source>
        <translation>Montrer les %1 dernières secondes</translation>
    </message>
    <message>
        <source>all</source>
        <comment>the whole run</comment>
        <translation>tout</translation>
    </message>
    <message>
        <source>Show the whole run</source>
        <translation>Montrer toute l&apos;exécution</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>s</source>
        <comment>seconds</comment>
        <translation>s</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>kept run: curve</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>cradle::ChartPlot</name>
    <message>
        <source>%1: %2</source>
        <comment>curve, value</comment>
        <translation>%1&#xa0;: %2</translation>
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
        <translation>Ce qui est vérifié</translation>
    </message>
    <message>
        <source>In which scenes</source>
        <translation>Dans quelles scènes</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Title of the check</source>
        <translation>Titre de la vérification</translation>
    </message>
    <message>
        <source>Id of the check</source>
        <translation>Id de la vérification</translation>
    </message>
    <message>
        <source>Letters, digits, dots and dashes; reports name the check by it</source>
        <translation>Lettres, chiffres, points et traits d&apos;union&#xa0;; les rapports nomment ainsi la vérification</translation>
    </message>
    <message>
        <source>What passing this check is worth in reports</source>
        <translation>Ce que vaut la réussite de cette vérification dans les rapports</translation>
    </message>
    <message>
        <source>Kind of the check</source>
        <translation>Type de la vérification</translation>
    </message>
</context>
<context>
    <name>cradle::CheckProgram</name>
    <message>
        <source>-- Returns true, or false and what is wrong.
</source>
        <translation>-- Renvoie true, ou false et ce qui ne va pas.
</translation>
    </message>
    <message>
        <source>Edit the program of a check</source>
        <translation>Modifier le programme d&apos;une vérification</translation>
    </message>
    <message>
        <source>Program of the check</source>
        <translation>Programme de la vérification</translation>
    </message>
</context>
<context>
    <name>cradle::CheckRow</name>
    <message>
        <source>Show the moment ▸</source>
        <translation>Montrer l&apos;instant ▸</translation>
    </message>
    <message>
        <source>Show the moment</source>
        <translation>Montrer l&apos;instant</translation>
    </message>
    <message>
        <source>Passed: %1</source>
        <translation>Réussi&#xa0;: %1</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Échoué&#xa0;: %1</translation>
    </message>
    <message>
        <source>Show what was observed</source>
        <translation>Montrer ce qui a été observé</translation>
    </message>
    <message>
        <source>Show what was observed: %1</source>
        <translation>Montrer ce qui a été observé&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>cradle::CheckTrial</name>
    <message>
        <source>It cannot be tried before what is wrong in this step is mended.</source>
        <translation>Elle ne peut être essayée avant que ce qui est faux dans cette étape soit corrigé.</translation>
    </message>
    <message>
        <source>Running…</source>
        <translation>En cours…</translation>
    </message>
    <message>
        <source>%1 stops in line %2: %3</source>
        <translation>%1 s&apos;arrête à la ligne %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1 stops: %2</source>
        <translation>%1 s&apos;arrête&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 passes.</source>
        <translation>%1 réussit.</translation>
    </message>
    <message>
        <source>%1 fails: %2</source>
        <translation>%1 échoue&#xa0;: %2</translation>
    </message>
    <message>
        <source>Try this check</source>
        <translation>Essayer cette vérification</translation>
    </message>
    <message>
        <source>On that program, with the first seed</source>
        <translation>Sur ce programme, avec la première graine</translation>
    </message>
    <message>
        <source>Program to try the check on</source>
        <translation>Programme sur lequel essayer la vérification</translation>
    </message>
    <message>
        <source>How the check went</source>
        <translation>Résultat de la vérification</translation>
    </message>
    <message>
        <source>This is the check as it was before: a field of it holds what is no value.</source>
        <translation>C&apos;est la vérification telle qu&apos;elle était&#xa0;: un de ses champs contient ce qui n&apos;est pas une valeur.</translation>
    </message>
</context>
<context>
    <name>cradle::ChecksTab</name>
    <message>
        <source>Checks · %1</source>
        <translation>Vérifications · %1</translation>
    </message>
    <message>
        <source>Edit a check</source>
        <translation>Modifier une vérification</translation>
    </message>
    <message>
        <source>New check</source>
        <translation>Nouvelle vérification</translation>
    </message>
    <message>
        <source>Add a check</source>
        <translation>Ajouter une vérification</translation>
    </message>
    <message>
        <source>Duplicate a check</source>
        <translation>Dupliquer une vérification</translation>
    </message>
    <message>
        <source>Remove a check</source>
        <translation>Supprimer une vérification</translation>
    </message>
    <message>
        <source>Move a check</source>
        <translation>Déplacer une vérification</translation>
    </message>
    <message>
        <source>Checks of the step</source>
        <translation>Vérifications de l&apos;étape</translation>
    </message>
    <message>
        <source>No check yet. Add one with the plus, then say what is right.</source>
        <translation>Pas encore de vérification. Ajoutez-en une avec le plus, puis dites ce qui est juste.</translation>
    </message>
    <message>
        <source>Duplicate the check</source>
        <translation>Dupliquer la vérification</translation>
    </message>
    <message>
        <source>Remove the check</source>
        <translation>Supprimer la vérification</translation>
    </message>
    <message>
        <source>Move the check up</source>
        <translation>Monter la vérification</translation>
    </message>
    <message>
        <source>Move the check down</source>
        <translation>Descendre la vérification</translation>
    </message>
</context>
<context>
    <name>cradle::CircleTableModel</name>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Centre, to the right</source>
        <translation>Centre, vers la droite</translation>
    </message>
    <message>
        <source>Centre, upward</source>
        <translation>Centre, vers le haut</translation>
    </message>
    <message>
        <source>Velocity to the right</source>
        <translation>Vitesse vers la droite</translation>
    </message>
    <message>
        <source>Velocity upward</source>
        <translation>Vitesse vers le haut</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Density in 1000 kg/m³; steel has 7.8</source>
        <translation>Masse volumique en 1000 kg/m³&#xa0;; l&apos;acier a 7.8</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Masse vol.</translation>
    </message>
    <message>
        <source>How position and velocity are carried over a timestep</source>
        <translation>Comment position et vitesse sont propagées sur un pas de temps</translation>
    </message>
    <message>
        <source>Integrator</source>
        <translation>Intégrateur</translation>
    </message>
    <message>
        <source>Mass of a ball of this radius and density</source>
        <translation>Masse d&apos;une boule de ce rayon et de cette masse volumique</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Change colour of %1</source>
        <translation>Changer la couleur&#xa0;: %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renommer&#xa0;: %1</translation>
    </message>
    <message>
        <source>Change position of %1</source>
        <translation>Changer la position&#xa0;: %1</translation>
    </message>
    <message>
        <source>Change velocity of %1</source>
        <translation>Changer la vitesse&#xa0;: %1</translation>
    </message>
    <message>
        <source>Change radius of %1</source>
        <translation>Changer le rayon&#xa0;: %1</translation>
    </message>
    <message>
        <source>Change density of %1</source>
        <translation>Changer la masse volumique&#xa0;: %1</translation>
    </message>
    <message>
        <source>Change integrator of %1</source>
        <translation>Changer l&apos;intégrateur&#xa0;: %1</translation>
    </message>
    <message>
        <source>Integr.</source>
        <comment>short for Integrator</comment>
        <translation>Intégr.</translation>
    </message>
</context>
<context>
    <name>cradle::CirclesGroup</name>
    <message>
        <source>Circles</source>
        <translation>Cercles</translation>
    </message>
    <message>
        <source>Add circle</source>
        <translation>Ajouter un cercle</translation>
    </message>
    <message>
        <source>Add a circle at a free place</source>
        <translation>Ajouter un cercle à un endroit libre</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Add a copy of the selected circle</source>
        <translation>Ajouter une copie du cercle sélectionné</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Remove the selected circle (Delete)</source>
        <translation>Supprimer le cercle sélectionné (Suppr)</translation>
    </message>
    <message>
        <source>Reset to the step&apos;s scene</source>
        <translation>Revenir à la scène de l&apos;étape</translation>
    </message>
    <message>
        <source>Bring back the scene that the step came with; Undo takes it back</source>
        <translation>Rétablit la scène fournie avec l&apos;étape&#xa0;; Annuler défait cela</translation>
    </message>
    <message>
        <source>Duplicate circle</source>
        <translation>Dupliquer le cercle</translation>
    </message>
    <message>
        <source>Remove circle</source>
        <translation>Supprimer le cercle</translation>
    </message>
</context>
<context>
    <name>cradle::CirclesLine</name>
    <message>
        <source>Circles: numbers from 1 to 100 as “1, 2” are right</source>
        <translation>Cercles&#xa0;: il faut des nombres de 1 à 100 comme «&#xa0;1, 2&#xa0;»</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Cercles</translation>
    </message>
    <message>
        <source>Circles that it looks at</source>
        <translation>Cercles examinés</translation>
    </message>
    <message>
        <source>Numbers of the circles, as “1, 2”</source>
        <translation>Numéros des cercles, comme «&#xa0;1, 2&#xa0;»</translation>
    </message>
</context>
<context>
    <name>cradle::ClipboardActions</name>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cou&amp;per</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>C&amp;oller</translation>
    </message>
    <message>
        <source>Select a&amp;ll</source>
        <translation>&amp;Tout sélectionner</translation>
    </message>
</context>
<context>
    <name>cradle::CodeActions</name>
    <message>
        <source>Run code</source>
        <translation>Lancer le code</translation>
    </message>
    <message>
        <source>Run the program as it stands now, from the start</source>
        <translation>Exécuter le programme tel qu&apos;il est maintenant, depuis le début</translation>
    </message>
    <message>
        <source>Step into line</source>
        <translation>Exécuter une ligne</translation>
    </message>
    <message>
        <source>Run one line of the program</source>
        <translation>Exécuter une ligne du programme</translation>
    </message>
    <message>
        <source>Finish step</source>
        <translation>Finir le pas</translation>
    </message>
    <message>
        <source>Run the rest of this step</source>
        <translation>Exécuter le reste de ce pas</translation>
    </message>
    <message>
        <source>Start this step afresh…</source>
        <translation>Recommencer cette étape…</translation>
    </message>
    <message>
        <source>Go back to the program that this step begins with</source>
        <translation>Revenir au programme par lequel cette étape commence</translation>
    </message>
    <message>
        <source>API reference</source>
        <translation>Référence de l&apos;API</translation>
    </message>
    <message>
        <source>What the program may use</source>
        <translation>Ce que le programme peut utiliser</translation>
    </message>
    <message>
        <source>Find…</source>
        <translation>Rechercher…</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>Remplacer…</translation>
    </message>
    <message>
        <source>Find next</source>
        <translation>Rechercher le suivant</translation>
    </message>
    <message>
        <source>Find previous</source>
        <translation>Rechercher le précédent</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>Texte plus grand</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>Texte plus petit</translation>
    </message>
    <message>
        <source>Usual text size</source>
        <translation>Taille de texte normale</translation>
    </message>
    <message>
        <source>Hide the reference solution</source>
        <translation>Masquer le corrigé</translation>
    </message>
    <message>
        <source>Show the reference solution</source>
        <translation>Montrer le corrigé</translation>
    </message>
    <message>
        <source>A program that passes this step, beside yours</source>
        <translation>Un programme qui réussit cette étape, à côté du vôtre</translation>
    </message>
    <message>
        <source>After you have passed this step, or opened all its hints</source>
        <translation>Une fois cette étape réussie, ou tous ses indices ouverts</translation>
    </message>
</context>
<context>
    <name>cradle::CodeDesk</name>
    <message>
        <source>in step %1, at %2 s</source>
        <translation>au pas %1, à %2 s</translation>
    </message>
    <message>
        <source>Reference of the lab&apos;s Lua</source>
        <translation>Référence Lua du TP</translation>
    </message>
    <message>
        <source>Start this step afresh</source>
        <translation>Recommencer cette étape</translation>
    </message>
    <message>
        <source>Your program goes back to what this step started from. What you have written in this step stays among its versions. Go back?</source>
        <translation>Votre programme revient à ce par quoi cette étape a commencé. Ce que vous avez écrit dans cette étape reste parmi ses versions. Revenir en arrière&#xa0;?</translation>
    </message>
</context>
<context>
    <name>cradle::CodeEditor</name>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Tout sélectionner</translation>
    </message>
    <message>
        <source>API reference</source>
        <translation>Référence de l&apos;API</translation>
    </message>
    <message>
        <source>API reference on %1</source>
        <translation>Référence de l&apos;API sur %1</translation>
    </message>
    <message>
        <source>Error in line %1: %2</source>
        <translation>Erreur à la ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Line %1 made the first failing step</source>
        <translation>La ligne %1 a fait le premier pas qui échoue</translation>
    </message>
    <message>
        <source>Line %1 runs next</source>
        <translation>La ligne %1 s&apos;exécute ensuite</translation>
    </message>
    <message>
        <source>Tab indents; Ctrl+Tab, or Escape and then Tab, leaves the editor</source>
        <translation>Tab met en retrait&#xa0;; Ctrl+Tab, ou Échap puis Tab, quitte l&apos;éditeur</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
</context>
<context>
    <name>cradle::CodeHeader</name>
    <message>
        <source>Run as I type</source>
        <translation>Exécuter en tapant</translation>
    </message>
    <message>
        <source>Run every change at once, as long as the program parses</source>
        <translation>Exécuter chaque changement aussitôt, tant que le programme est lisible</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>More for the program</source>
        <translation>Plus pour le programme</translation>
    </message>
</context>
<context>
    <name>cradle::CodePane</name>
    <message>
        <source>saved</source>
        <translation>enregistré</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>non enregistré</translation>
    </message>
    <message>
        <source>read only</source>
        <translation>lecture seule</translation>
    </message>
    <message>
        <source>cannot be read: the last good version runs</source>
        <translation>illisible&#xa0;: la dernière bonne version tourne</translation>
    </message>
    <message>
        <source>cannot be read: nothing runs</source>
        <translation>illisible&#xa0;: rien ne tourne</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
</context>
<context>
    <name>cradle::CompletionPopup</name>
    <message>
        <source>Completions</source>
        <translation>Propositions</translation>
    </message>
</context>
<context>
    <name>cradle::ConsoleDelegate</name>
    <message>
        <source>load</source>
        <comment>printed while loading</comment>
        <translation>début</translation>
    </message>
</context>
<context>
    <name>cradle::ConsoleModel</name>
    <message>
        <source>step %1: %2</source>
        <translation>pas %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Printed in step %1</source>
        <translation>Affiché au pas %1</translation>
    </message>
    <message>
        <source>Printed while the program was loaded</source>
        <translation>Affiché pendant le chargement du programme</translation>
    </message>
    <message>
        <source>Printed in step %1, at %2 s; a double click shows it</source>
        <translation>Affiché au pas %1, à %2 s&#xa0;; un double-clic le montre</translation>
    </message>
</context>
<context>
    <name>cradle::ConsoleView</name>
    <message>
        <source>Console</source>
        <translation>Console</translation>
    </message>
    <message>
        <source>print(…) in your program writes here</source>
        <translation>print(…) dans votre programme écrit ici</translation>
    </message>
    <message>
        <source>Lines that the program has printed</source>
        <translation>Lignes affichées par le programme</translation>
    </message>
    <message>
        <source>Show the moment</source>
        <translation>Montrer l&apos;instant</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Tout copier</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
</context>
<context>
    <name>cradle::DifferenceDialog</name>
    <message>
        <source>(not in mine)</source>
        <translation>(pas dans le mien)</translation>
    </message>
    <message>
        <source>(not in theirs)</source>
        <translation>(pas dans le leur)</translation>
    </message>
    <message>
        <source>no text</source>
        <translation>pas de texte</translation>
    </message>
    <message>
        <source>Changed by another program</source>
        <translation>Modifié par un autre programme</translation>
    </message>
    <message>
        <source>From mine (−) to theirs (+):</source>
        <translation>Du mien (−) au leur (+)&#xa0;:</translation>
    </message>
    <message>
        <source>Difference of the two versions</source>
        <translation>Différence des deux versions</translation>
    </message>
</context>
<context>
    <name>cradle::EnergyChart</name>
    <message>
        <source>By the pro&amp;gram</source>
        <translation>Par le pro&amp;gramme</translation>
    </message>
    <message>
        <source>Energy made by the program besides the hits, or lost if negative: total + dissipated in hits − total at the start.</source>
        <translation>Énergie créée par le programme hors des chocs, ou perdue si négative&#xa0;: totale + dissipée par les chocs − totale au départ.</translation>
    </message>
    <message>
        <source>By the &amp;integrator</source>
        <translation>Par l&apos;&amp;intégrateur</translation>
    </message>
    <message>
        <source>Energy made by the integrator, or lost if negative: total + dissipated in hits − total at the start. So start = total + dissipated − made by the integrator.</source>
        <translation>Énergie créée par l&apos;intégrateur, ou perdue si négative&#xa0;: totale + dissipée par les chocs − totale au départ. Donc départ = totale + dissipée − créée par l&apos;intégrateur.</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Énergie</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>Press Run to see the energy</source>
        <translation>Appuyez sur «&#xa0;Lancer&#xa0;» pour voir l&apos;énergie</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Choose the curves</source>
        <translation>Choisir les courbes</translation>
    </message>
    <message>
        <source>&amp;Total</source>
        <translation>&amp;Totale</translation>
    </message>
    <message>
        <source>Total of e&amp;ach</source>
        <translation>Totale de c&amp;hacun</translation>
    </message>
    <message>
        <source>Kinetic, &amp;each circle</source>
        <translation>Cinétique, &amp;chaque cercle</translation>
    </message>
    <message>
        <source>&amp;Kinetic, all circles</source>
        <translation>Ci&amp;nétique, tous les cercles</translation>
    </message>
    <message>
        <source>&amp;Potential</source>
        <translation>&amp;Potentielle</translation>
    </message>
    <message>
        <source>&amp;Dissipated in hits</source>
        <translation>&amp;Dissipée par les chocs</translation>
    </message>
    <message>
        <source>Energy that circles lose in steps with a hit, and while they rest on something; negative if hits made energy, as going back to a higher place does</source>
        <translation>Énergie que les cercles perdent dans les pas avec un choc, et pendant qu&apos;ils reposent sur quelque chose&#xa0;; négative si des chocs ont créé de l&apos;énergie, comme le fait le retour à un endroit plus haut</translation>
    </message>
    <message>
        <source>More than the e&amp;xact motion</source>
        <translation>De plus que le mouvement e&amp;xact</translation>
    </message>
    <message>
        <source>Total energy of the run minus that of the exact motion beside it: the error of integrator and timestep</source>
        <translation>Énergie totale de l&apos;exécution moins celle du mouvement exact à côté&#xa0;: l&apos;erreur de l&apos;intégrateur et du pas de temps</translation>
    </message>
    <message>
        <source>&amp;Stacked areas</source>
        <translation>Aires &amp;empilées</translation>
    </message>
    <message>
        <source>Kinetic, potential and dissipated energy on top of each other</source>
        <translation>Énergies cinétique, potentielle et dissipée l&apos;une sur l&apos;autre</translation>
    </message>
    <message>
        <source>more than exact</source>
        <translation>de plus que l&apos;exact</translation>
    </message>
    <message>
        <source>kinetic %1</source>
        <comment>unit</comment>
        <translation>cinétique %1</translation>
    </message>
    <message>
        <source>kinetic %1</source>
        <translation>cinétique %1</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>cinétique</translation>
    </message>
    <message>
        <source>+ potential</source>
        <translation>+ potentielle</translation>
    </message>
    <message>
        <source>+ dissipated</source>
        <translation>+ dissipée</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>potentielle</translation>
    </message>
    <message>
        <source>total</source>
        <translation>totale</translation>
    </message>
    <message>
        <source>total %1</source>
        <translation>totale %1</translation>
    </message>
    <message>
        <source>taken by hits</source>
        <translation>prise par les chocs</translation>
    </message>
    <message>
        <source>dissipated</source>
        <translation>dissipée</translation>
    </message>
    <message>
        <source>by the program</source>
        <translation>par le programme</translation>
    </message>
    <message>
        <source>by the integrator</source>
        <translation>par l&apos;intégrateur</translation>
    </message>
</context>
<context>
    <name>cradle::ErrorLine</name>
    <message>
        <source>line %1, step %2: %3</source>
        <translation>ligne %1, pas %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>step %1: %2</source>
        <translation>pas %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>The program stopped: %1</source>
        <translation>Le programme s&apos;est arrêté&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>cradle::FindBar</name>
    <message>
        <source>Find</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Replace by</source>
        <translation>Remplacer par</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Respecter la casse</translation>
    </message>
    <message>
        <source>Whole words only</source>
        <translation>Mots entiers seulement</translation>
    </message>
    <message>
        <source>Previous match</source>
        <translation>Occurrence précédente</translation>
    </message>
    <message>
        <source>Shift+F3</source>
        <translation>Maj+F3</translation>
    </message>
    <message>
        <source>Next match</source>
        <translation>Occurrence suivante</translation>
    </message>
    <message>
        <source>F3</source>
        <translation>F3</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Replace all</source>
        <translation>Tout remplacer</translation>
    </message>
    <message numerus="yes">
        <source>%n replaced</source>
        <translation>
            <numerusform>%n remplacement</numerusform>
            <numerusform>%n remplacements</numerusform>
        </translation>
    </message>
    <message>
        <source>no match</source>
        <translation>aucune occurrence</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message numerus="yes">
        <source>%n match(es)</source>
        <translation>
            <numerusform>%n occurrence</numerusform>
            <numerusform>%n occurrences</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::FindPanel</name>
    <message>
        <source>Found nowhere</source>
        <translation>Introuvable</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n endroit</numerusform>
            <numerusform>%n endroits</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in %n file(s)</source>
        <translation>
            <numerusform>dans %n fichier</numerusform>
            <numerusform>dans %n fichiers</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace “%1”</source>
        <translation>Remplacer «&#xa0;%1&#xa0;»</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) replaced; Undo brings them back</source>
        <translation>
            <numerusform>%n endroit remplacé&#xa0;; Annuler le rétablit</numerusform>
            <numerusform>%n endroits remplacés&#xa0;; Annuler les rétablit</numerusform>
        </translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Text to find in the lab</source>
        <translation>Texte à rechercher dans le TP</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Remplacer par</translation>
    </message>
    <message>
        <source>Text to put there</source>
        <translation>Texte à mettre à la place</translation>
    </message>
    <message>
        <source>Replace all</source>
        <translation>Tout remplacer</translation>
    </message>
    <message>
        <source>In all places of the list, as one edit</source>
        <translation>À tous les endroits de la liste, en une seule modification</translation>
    </message>
    <message>
        <source>Match case</source>
        <translation>Respecter la casse</translation>
    </message>
    <message>
        <source>Whole words</source>
        <translation>Mots entiers</translation>
    </message>
    <message>
        <source>In the whole lab</source>
        <translation>Dans tout le TP</translation>
    </message>
    <message>
        <source>In this step</source>
        <translation>Dans cette étape</translation>
    </message>
    <message>
        <source>Where to look</source>
        <translation>Où chercher</translation>
    </message>
    <message>
        <source>Close the search</source>
        <translation>Fermer la recherche</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Places that were found</source>
        <translation>Endroits trouvés</translation>
    </message>
</context>
<context>
    <name>cradle::FindingCard</name>
    <message>
        <source>Show what was measured</source>
        <translation>Montrer ce qui a été mesuré</translation>
    </message>
    <message>
        <source>Show what was measured: %1</source>
        <translation>Montrer ce qui a été mesuré&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>cradle::FindingsList</name>
    <message>
        <source>All files can be read</source>
        <translation>Tous les fichiers sont lisibles</translation>
    </message>
    <message>
        <source>Findings · %1</source>
        <translation>Constats · %1</translation>
    </message>
    <message>
        <source>Findings in the lab&apos;s files</source>
        <translation>Constats dans les fichiers du TP</translation>
    </message>
</context>
<context>
    <name>cradle::FormulaRenderer</name>
    <message>
        <source>Cradle was built without MathJax, so formulas show as text.</source>
        <translation>Cradle a été construit sans MathJax, les formules s&apos;affichent donc en texte.</translation>
    </message>
    <message>
        <source>MathJax does not run: %1</source>
        <translation>MathJax ne marche pas&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>cradle::GradeDialog</name>
    <message>
        <source>Grade a class: %1</source>
        <translation>Noter une classe&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Handed in:</source>
        <translation>Re&amp;ndus&#xa0;:</translation>
    </message>
    <message>
        <source>A folder with a folder, or a .cradle-work file, for each student; or a download of Moodle, Canvas, Blackboard or GitHub Classroom. Nothing in it is changed.</source>
        <translation>Un dossier avec, pour chaque étudiant, un dossier ou un fichier .cradle-work&#xa0;; ou un téléchargement de Moodle, Canvas, Blackboard ou GitHub Classroom. Rien n&apos;y est modifié.</translation>
    </message>
    <message>
        <source>Choose what was handed in</source>
        <translation>Choisir ce qui a été rendu</translation>
    </message>
    <message>
        <source>&amp;Results:</source>
        <translation>&amp;Résultats&#xa0;:</translation>
    </message>
    <message>
        <source>A folder for the results: an empty one, or one with the results of the same class, which then go on where they were.</source>
        <translation>Un dossier pour les résultats&#xa0;: un dossier vide, ou un dossier avec les résultats de la même classe, qui reprennent alors où ils en étaient.</translation>
    </message>
    <message>
        <source>Choose a folder for the results</source>
        <translation>Choisir un dossier pour les résultats</translation>
    </message>
    <message>
        <source>R&amp;oster:</source>
        <translation>&amp;Liste&#xa0;:</translation>
    </message>
    <message>
        <source>A table (CSV) of who is in the class: id, folder, name, number, email, late days. It may be left out.</source>
        <translation>Un tableau (CSV) de qui est dans la classe&#xa0;: id, folder, name, number, email, late days. Facultatif.</translation>
    </message>
    <message>
        <source>Choose a roster</source>
        <translation>Choisir une liste de classe</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source> % a day</source>
        <translation>&#xa0;% par jour</translation>
    </message>
    <message>
        <source>What each day late that has begun takes of the points</source>
        <translation>Ce que chaque jour de retard commencé retire aux points</translation>
    </message>
    <message>
        <source>&amp;Late:</source>
        <translation>Re&amp;tard&#xa0;:</translation>
    </message>
    <message>
        <source>How the grading goes</source>
        <translation>Où en est la notation</translation>
    </message>
    <message>
        <source>Students done</source>
        <translation>Étudiants traités</translation>
    </message>
    <message>
        <source>&amp;Grade</source>
        <translation>N&amp;oter</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>O&amp;pen the results</source>
        <translation>Ou&amp;vrir les résultats</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>Choisir&#xa0;: %1</translation>
    </message>
    <message>
        <source>What was handed in is read…</source>
        <translation>Lecture de ce qui a été rendu…</translation>
    </message>
    <message>
        <source>%1 of %2 students: %3 steps pass, %4 do not, %5 could not be graded.</source>
        <translation>Étudiants&#xa0;: %1 sur %2. Étapes réussies&#xa0;: %3, non réussies&#xa0;: %4, impossibles à noter&#xa0;: %5.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the students as they were before.</source>
        <translation>
            <numerusform>%n étudiant inchangé.</numerusform>
            <numerusform>%n étudiants inchangés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopped. What is judged stays; grading again goes on from here.</source>
        <translation>Arrêté. Ce qui est évalué reste&#xa0;; une nouvelle notation reprend ici.</translation>
    </message>
    <message>
        <source>No program opened the page. It is %1</source>
        <translation>Aucun programme n&apos;a ouvert la page. La voici&#xa0;: %1</translation>
    </message>
    <message>
        <source>Choose what was handed in, and a folder for the results. Grading can be stopped at any time, and goes on where it was.</source>
        <translation>Choisissez ce qui a été rendu, et un dossier pour les résultats. On peut arrêter la notation à tout moment&#xa0;; elle reprend ensuite où elle en était.</translation>
    </message>
    <message>
        <source>Remarks on what was handed in</source>
        <translation>Remarques sur ce qui a été rendu</translation>
    </message>
</context>
<context>
    <name>cradle::GradeRun</name>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 ne peut pas être lancé&#xa0;: %2</translation>
    </message>
    <message>
        <source>cradle-cli broke down</source>
        <translation>cradle-cli est tombé en panne</translation>
    </message>
</context>
<context>
    <name>cradle::HandInDialog</name>
    <message>
        <source>Hand in %1</source>
        <translation>Rendre %1</translation>
    </message>
    <message>
        <source>The values of this lab were drawn by this number</source>
        <translation>Les valeurs de ce TP ont été tirées de ce numéro</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>What is handed in</source>
        <translation>Ce qui est rendu</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Steps that are handed in</source>
        <translation>Étapes qui sont rendues</translation>
    </message>
    <message>
        <source>Note to the teacher</source>
        <translation>Mot pour l&apos;enseignant</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Nom&#xa0;:</translation>
    </message>
    <message>
        <source>N&amp;umber:</source>
        <translation>N&amp;uméro&#xa0;:</translation>
    </message>
    <message>
        <source>Note to the &amp;teacher:</source>
        <translation>Mot pour l&apos;ensei&amp;gnant&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Save the file…</source>
        <translation>&amp;Enregistrer le fichier…</translation>
    </message>
    <message>
        <source>Every step is judged once more…</source>
        <translation>Chaque étape est évaluée encore une fois…</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>un programme</translation>
    </message>
    <message>
        <source>a scene</source>
        <translation>une scène</translation>
    </message>
    <message>
        <source>passes ✓</source>
        <translation>réussie ✓</translation>
    </message>
    <message>
        <source>does not pass</source>
        <translation>non réussie</translation>
    </message>
    <message>
        <source>stops with an error</source>
        <translation>s&apos;arrête sur une erreur</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>pas faite</translation>
    </message>
    <message>
        <source>%1 of %2 steps pass. All of them are handed in as they are.</source>
        <translation>Étapes réussies&#xa0;: %1 sur %2. Toutes sont rendues telles qu&apos;elles sont.</translation>
    </message>
    <message>
        <source>Save what is handed in</source>
        <translation>Enregistrer ce qui est rendu</translation>
    </message>
    <message>
        <source>Work to hand in (*.cradle-work)</source>
        <translation>Travail à rendre (*.cradle-work)</translation>
    </message>
</context>
<context>
    <name>cradle::HelpDesk</name>
    <message>
        <source>The step</source>
        <translation>L&apos;étape</translation>
    </message>
    <message>
        <source>Here stands what to do and why. The dots are the steps of the lab; hints wait below the text.</source>
        <translation>Ici est écrit ce qu&apos;il faut faire, et pourquoi. Les points sont les étapes du TP&#xa0;; des indices attendent sous le texte.</translation>
    </message>
    <message>
        <source>Your program</source>
        <translation>Votre programme</translation>
    </message>
    <message>
        <source>The scene in numbers</source>
        <translation>La scène en chiffres</translation>
    </message>
    <message>
        <source>You keep one program through all steps. It is saved and runs as you type; F1 explains the word under the cursor.</source>
        <translation>Vous gardez un seul programme à travers toutes les étapes. Il est enregistré et tourne pendant que vous tapez&#xa0;; F1 explique le mot sous le curseur.</translation>
    </message>
    <message>
        <source>World, laws and circles: what you change here or by dragging in the scene starts the run anew.</source>
        <translation>Monde, lois et cercles&#xa0;: ce que vous changez ici, ou en faisant glisser dans la scène, relance l&apos;exécution depuis le début.</translation>
    </message>
    <message>
        <source>The scene</source>
        <translation>La scène</translation>
    </message>
    <message>
        <source>What your circles do. At a hit, arrows show the parts of the velocities along and across the normal.</source>
        <translation>Ce que font vos cercles. Lors d&apos;un choc, des flèches montrent les composantes normale et tangentielle des vitesses.</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Momentum and energy of the same run. Click where you want the numbers of that moment; every hit is marked.</source>
        <translation>Quantité de mouvement et énergie de la même exécution. Cliquez là où vous voulez les nombres de cet instant&#xa0;; chaque choc est marqué.</translation>
    </message>
    <message>
        <source>Any moment again</source>
        <translation>Revoir n&apos;importe quel instant</translation>
    </message>
    <message>
        <source>Drag to any moment of the run, or press Next hit. Space runs and pauses.</source>
        <translation>Glissez jusqu&apos;à n&apos;importe quel instant de l&apos;exécution, ou appuyez sur «&#xa0;Choc suivant&#xa0;». Espace lance et met en pause.</translation>
    </message>
    <message>
        <source>Run and check</source>
        <translation>Lancer et vérifier</translation>
    </message>
    <message>
        <source>Run to watch; Check when you are done: it says what is right, what is not, and why.</source>
        <translation>Lancez pour observer&#xa0;; vérifiez quand vous avez fini&#xa0;: vous saurez ce qui est juste, ce qui ne l&apos;est pas, et pourquoi.</translation>
    </message>
    <message>
        <source>:/help/lua-for-csharp.md</source>
        <extracomment>The file of the page in your language: docs/lua-for-csharp.LANGUAGE.md, if there is one</extracomment>
        <translation>:/help/lua-for-csharp.fr.md</translation>
    </message>
    <message>
        <source>Lua for C# people</source>
        <translation>Lua pour qui connaît C#</translation>
    </message>
    <message>
        <source>Comment lines, or not</source>
        <translation>Commenter les lignes, ou non</translation>
    </message>
    <message>
        <source>Words that fit here</source>
        <translation>Mots qui conviennent ici</translation>
    </message>
    <message>
        <source>What the call takes</source>
        <translation>Ce que l&apos;appel attend</translation>
    </message>
    <message>
        <source>Out of the program</source>
        <translation>Sortir du programme</translation>
    </message>
    <message>
        <source>Esc, then Tab</source>
        <translation>Échap, puis Tab</translation>
    </message>
    <message>
        <source>Select several circles</source>
        <translation>Sélectionner plusieurs cercles</translation>
    </message>
    <message>
        <source>Ctrl+click, Shift+drag, Shift+arrows</source>
        <translation>Ctrl+clic, Maj+glisser, Maj+flèches</translation>
    </message>
    <message>
        <source>Move what is selected</source>
        <translation>Déplacer la sélection</translation>
    </message>
    <message>
        <source>drag; Ctrl+arrows, finer with Shift</source>
        <translation>glisser&#xa0;; Ctrl+flèches, plus fin avec Maj</translation>
    </message>
    <message>
        <source>Drag free of the grid</source>
        <translation>Glisser sans la grille</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Zoom to a box</source>
        <translation>Agrandir un cadre</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Maj+glisser</translation>
    </message>
    <message>
        <source>wheel; values alone with Ctrl</source>
        <translation>molette&#xa0;; les valeurs seules avec Ctrl</translation>
    </message>
    <message>
        <source>Move along</source>
        <translation>Déplacer la vue</translation>
    </message>
    <message>
        <source>drag with the middle button</source>
        <translation>glisser avec le bouton central</translation>
    </message>
    <message>
        <source>Reset the zoom</source>
        <translation>Réinitialiser le zoom</translation>
    </message>
    <message>
        <source>double click</source>
        <translation>double-clic</translation>
    </message>
    <message>
        <source>In a chart</source>
        <translation>Dans un graphique</translation>
    </message>
    <message>
        <source>Take a drag back</source>
        <translation>Annuler un glissement</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Remove what is selected</source>
        <translation>Retirer la sélection</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Déplacer la vue</translation>
    </message>
    <message>
        <source>drag on empty space, or the middle button</source>
        <translation>glisser sur le vide, ou bouton du milieu</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Zoomer au pointeur</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>molette</translation>
    </message>
    <message>
        <source>A step back or on</source>
        <translation>Un pas en arrière ou en avant</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Gauche, Droite</translation>
    </message>
    <message>
        <source>The hit before or after</source>
        <translation>Le choc précédent ou suivant</translation>
    </message>
    <message>
        <source>PgUp, PgDown</source>
        <translation>Page préc., Page suiv.</translation>
    </message>
    <message>
        <source>Start and end of the run</source>
        <translation>Début et fin de l&apos;exécution</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Début, Fin</translation>
    </message>
    <message>
        <source>From curve to curve of a chart, from bar to bar of the speeds</source>
        <translation>D&apos;une courbe à l&apos;autre d&apos;un graphique, d&apos;une barre à l&apos;autre des vitesses</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>Haut, Bas</translation>
    </message>
    <message>
        <source>Hear that curve from left to right</source>
        <translation>Écouter cette courbe de gauche à droite</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Along the dots of the steps, and open</source>
        <translation>Parcourir les points des étapes, ouvrir</translation>
    </message>
    <message>
        <source>Left, Right, Return</source>
        <translation>Gauche, Droite, Entrée</translation>
    </message>
    <message>
        <source>Anywhere</source>
        <translation>Partout</translation>
    </message>
    <message>
        <source>On the timeline and the steps</source>
        <translation>Sur la ligne de temps et les étapes</translation>
    </message>
    <message>
        <source>In the program</source>
        <translation>Dans le programme</translation>
    </message>
    <message>
        <source>In the scene</source>
        <translation>Dans la scène</translation>
    </message>
    <message>
        <source>About Cradle</source>
        <translation>À propos de Cradle</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Cradle %1&lt;/h3&gt;&lt;p&gt;Learn how a physics engine works by writing one.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. Built with Qt, Lua, QScintilla, MathJax and valijson.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Cradle %1&lt;/h3&gt;&lt;p&gt;Comprendre un moteur physique en l&apos;écrivant soi-même.&lt;/p&gt;&lt;p&gt;Logiciel libre sous la licence publique générale GNU, version 3 ou ultérieure. Construit avec Qt, Lua, QScintilla, MathJax et valijson.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>cradle::HintsList</name>
    <message>
        <source>A new hint</source>
        <translation>Un nouvel indice</translation>
    </message>
    <message>
        <source>Hints, in the order of opening</source>
        <translation>Indices, dans l&apos;ordre d&apos;ouverture</translation>
    </message>
    <message>
        <source>Add a hint</source>
        <translation>Ajouter un indice</translation>
    </message>
    <message>
        <source>Remove the hint</source>
        <translation>Supprimer l&apos;indice</translation>
    </message>
    <message>
        <source>Move the hint up</source>
        <translation>Monter l&apos;indice</translation>
    </message>
    <message>
        <source>Move the hint down</source>
        <translation>Descendre l&apos;indice</translation>
    </message>
</context>
<context>
    <name>cradle::HitsModel</name>
    <message>
        <source>left wall</source>
        <translation>paroi gauche</translation>
    </message>
    <message>
        <source>right wall</source>
        <translation>paroi droite</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>sol</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>plafond</translation>
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
        <source>Hit %1 at %2 s: momentum before %3, after %4, change %5 kg m/s.</source>
        <translation>Choc %1 à %2 s&#xa0;: quantité de mouvement avant %3, après %4, changement %5 kg m/s.</translation>
    </message>
    <message>
        <source>Hit %1 at %2 s, circle %6 on the %7: momentum before %3, after %4, change %5 kg m/s.</source>
        <translation>Choc %1 à %2 s, cercle %6 (%7)&#xa0;: quantité de mouvement avant %3, après %4, changement %5 kg m/s.</translation>
    </message>
    <message>
        <source>Hit %1: circle %2 on the %3, in contact from %4 s to %5 s.</source>
        <translation>Choc %1&#xa0;: cercle %2 (%3), en contact de %4 s à %5 s.</translation>
    </message>
    <message>
        <source>Hit %1: circles %2 and %3, in contact from %4 s to %5 s.</source>
        <translation>Choc %1&#xa0;: cercles %2 et %3, en contact de %4 s à %5 s.</translation>
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
        <source>Momentum (p_x, p_y) of the circles of the hit; p_x alone where there is no p_y</source>
        <translation>Quantité de mouvement (p_x, p_y) des cercles du choc&#xa0;; p_x seul quand il n&apos;y a pas de p_y</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>who</source>
        <translation>qui</translation>
    </message>
    <message>
        <source>impulse</source>
        <translation>impulsion</translation>
    </message>
    <message>
        <source>before</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>after</source>
        <translation>après</translation>
    </message>
    <message>
        <source>change</source>
        <translation>changement</translation>
    </message>
</context>
<context>
    <name>cradle::Inspector</name>
    <message>
        <source>Inspector</source>
        <translation>Inspecteur</translation>
    </message>
    <message>
        <source>These values are the start of the run.</source>
        <translation>Ces valeurs sont le départ de l&apos;exécution.</translation>
    </message>
    <message>
        <source>Not possible: %1.</source>
        <translation>Impossible&#xa0;: %1.</translation>
    </message>
    <message>
        <source>“%1” is not a number; 0.5, 1e-3 or 1/240 would be right.</source>
        <translation>«&#xa0;%1&#xa0;» n&apos;est pas un nombre&#xa0;; 0.5, 1e-3 ou 1/240 conviendraient.</translation>
    </message>
</context>
<context>
    <name>cradle::InstructionsPane</name>
    <message>
        <source>Hint %1</source>
        <translation>Indice %1</translation>
    </message>
    <message>
        <source>Hint %1 of %2 ▸</source>
        <translation>Indice %1 sur %2 ▸</translation>
    </message>
    <message>
        <source>Show hint %1 of %2</source>
        <translation>Montrer l&apos;indice %1 sur %2</translation>
    </message>
    <message>
        <source>Instructions</source>
        <translation>Instructions</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>Indices</translation>
    </message>
</context>
<context>
    <name>cradle::KeysDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
</context>
<context>
    <name>cradle::LabDialog</name>
    <message>
        <source>A copy of the lab</source>
        <translation>Une copie du TP</translation>
    </message>
    <message>
        <source>Properties of the lab</source>
        <translation>Propriétés du TP</translation>
    </message>
    <message>
        <source>The copy is a lab of its own, so it has an id of its own: who has passed a step of the original has not passed that of the copy.</source>
        <translation>La copie est un TP à part, elle a donc son propre id&#xa0;: qui a réussi une étape de l&apos;original n&apos;a pas réussi celle de la copie.</translation>
    </message>
    <message>
        <source>The progress of students is kept by the id. A corrected lab keeps its id and gets a higher version; a new lab gets a new id.</source>
        <translation>La progression des étudiants est conservée par l&apos;id. Un TP corrigé garde son id et reçoit une version plus élevée&#xa0;; un nouveau TP reçoit un nouvel id.</translation>
    </message>
    <message>
        <source>Title, %1</source>
        <translation>Titre, %1</translation>
    </message>
    <message>
        <source>Letters, digits, dots and dashes</source>
        <translation>Lettres, chiffres, points et traits d&apos;union</translation>
    </message>
    <message>
        <source>The language of task.json and instructions.md; texts in others have files of their own</source>
        <translation>La langue de task.json et instructions.md&#xa0;; les textes dans d&apos;autres langues ont leurs propres fichiers</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Written in</source>
        <translation>Écrit en</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (copie)</translation>
    </message>
    <message>
        <source>A title of 1 to 200 characters is right</source>
        <translation>Il faut un titre de 1 à 200 caractères</translation>
    </message>
    <message>
        <source>Another id than that of the original is right</source>
        <translation>Il faut un autre id que celui de l&apos;original</translation>
    </message>
    <message>
        <source>Edit the properties of the lab</source>
        <translation>Modifier les propriétés du TP</translation>
    </message>
</context>
<context>
    <name>cradle::LabDrop</name>
    <message>
        <source>no version</source>
        <translation>sans version</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>version %1</translation>
    </message>
    <message>
        <source>Another version</source>
        <translation>Une autre version</translation>
    </message>
    <message>
        <source>“%1” is there already with %2. The file has %3.</source>
        <translation>«&#xa0;%1&#xa0;» est déjà là, %2. Dans le fichier&#xa0;: %3.</translation>
    </message>
    <message>
        <source>Both have one id, so what was passed in one counts as passed in the other.</source>
        <translation>Les deux ont le même id&#xa0;; ce qui a été réussi dans l&apos;un compte donc comme réussi dans l&apos;autre.</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>Le remplacer</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>Garder les deux</translation>
    </message>
</context>
<context>
    <name>cradle::LanguageBox</name>
    <message>
        <source>Texts in %1</source>
        <translation>Textes en %1</translation>
    </message>
    <message>
        <source>Language of the texts</source>
        <translation>Langue des textes</translation>
    </message>
    <message>
        <source>What is typed in any of the tabs, and the titles of steps, are in this language</source>
        <translation>Ce qui est tapé dans n&apos;importe quel onglet, ainsi que les titres des étapes, est dans cette langue</translation>
    </message>
</context>
<context>
    <name>cradle::LawsGroup</name>
    <message>
        <source>Change law for walls</source>
        <translation>Changer la loi des parois</translation>
    </message>
    <message>
        <source>Change law for circles</source>
        <translation>Changer la loi des cercles</translation>
    </message>
    <message>
        <source>Change timing</source>
        <translation>Changer le traitement du temps</translation>
    </message>
    <message>
        <source>Laws</source>
        <translation>Lois</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Parois</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Cercles</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Law: %1</source>
        <translation>Loi&#xa0;: %1</translation>
    </message>
    <message>
        <source>Circles leave the square unhindered.</source>
        <translation>Les cercles quittent le carré sans obstacle.</translation>
    </message>
    <message>
        <source>A wall turns the part of the velocity that points into it around, and multiplies it by e.</source>
        <translation>Une paroi inverse la composante de la vitesse qui pointe vers elle, et la multiplie par e.</translation>
    </message>
    <message>
        <source>Circles pass through each other.</source>
        <translation>Les cercles se traversent.</translation>
    </message>
    <message>
        <source>Circles that meet both stop.</source>
        <translation>Les cercles qui se rencontrent s&apos;arrêtent tous deux.</translation>
    </message>
    <message>
        <source>Circles that meet exchange their whole velocities.</source>
        <translation>Les cercles qui se rencontrent échangent leurs vitesses entières.</translation>
    </message>
    <message>
        <source>Only the parts of the velocities along the line of centres are exchanged; the parts across it stay.</source>
        <translation>Seules les composantes des vitesses suivant la ligne des centres sont échangées&#xa0;; les composantes perpendiculaires restent.</translation>
    </message>
    <message>
        <source>An impulse along the line of centres keeps the momentum, with the masses and the restitution e.</source>
        <translation>Une impulsion suivant la ligne des centres conserve la quantité de mouvement, avec les masses et la restitution e.</translation>
    </message>
    <message>
        <source>After each step overlaps are looked for; on a hit the circles go back to their old positions and respond.</source>
        <translation>Après chaque pas, on cherche les chevauchements&#xa0;; lors d&apos;un choc, les cercles retournent à leurs anciennes positions et réagissent.</translation>
    </message>
    <message>
        <source>The time of a hit inside the step is found, and the rest of the step is spent after it.</source>
        <translation>L&apos;instant d&apos;un choc à l&apos;intérieur du pas est trouvé, et le reste du pas se fait après lui.</translation>
    </message>
    <message>
        <source>The motion is solved from hit to hit; the timestep only says when to look.</source>
        <translation>Le mouvement est résolu de choc en choc&#xa0;; le pas de temps dit seulement quand regarder.</translation>
    </message>
</context>
<context>
    <name>cradle::LocalsTable</name>
    <message>
        <source>Local variables</source>
        <translation>Variables locales</translation>
    </message>
    <message>
        <source>None at this line</source>
        <translation>Aucune à cette ligne</translation>
    </message>
    <message>
        <source>Local variables at the line that runs next</source>
        <translation>Variables locales à la ligne qui s&apos;exécute ensuite</translation>
    </message>
</context>
<context>
    <name>cradle::MarkdownView</name>
    <message>
        <source>(a picture)</source>
        <translation>(une image)</translation>
    </message>
</context>
<context>
    <name>cradle::MomentumChart</name>
    <message>
        <source>Momentum</source>
        <translation>Quantité de mouvement</translation>
    </message>
    <message>
        <source>kg m/s</source>
        <translation>kg m/s</translation>
    </message>
    <message>
        <source>Press Run to see the momentum</source>
        <translation>Appuyez sur «&#xa0;Lancer&#xa0;» pour voir la quantité de mouvement</translation>
    </message>
    <message>
        <source>Momentum to the right</source>
        <translation>Quantité de mouvement vers la droite</translation>
    </message>
    <message>
        <source>Momentum upwards</source>
        <translation>Quantité de mouvement vers le haut</translation>
    </message>
    <message>
        <source>Size of the momentum</source>
        <translation>Norme de la quantité de mouvement</translation>
    </message>
    <message>
        <source>Part of the momentum</source>
        <translation>Composante de la quantité de mouvement</translation>
    </message>
    <message>
        <source>sum %1</source>
        <translation>somme %1</translation>
    </message>
</context>
<context>
    <name>cradle::NotesPane</name>
    <message>
        <source>Notes</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>What you noted about this step: it becomes part of your report. Markdown, and formulas as $v = a t$.</source>
        <translation>Ce que vous avez noté sur cette étape&#xa0;: cela entre dans votre rapport. Markdown, et formules comme $v = a t$.</translation>
    </message>
    <message>
        <source>Notes about this step</source>
        <translation>Remarques sur cette étape</translation>
    </message>
    <message>
        <source>The notes, set</source>
        <translation>Les remarques, mises en forme</translation>
    </message>
</context>
<context>
    <name>cradle::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation>Avis</translation>
    </message>
    <message>
        <source>Got it</source>
        <translation>Compris</translation>
    </message>
</context>
<context>
    <name>cradle::Opening</name>
    <message>
        <source>Open a lab&apos;s folder</source>
        <translation>Ouvrir le dossier d&apos;un TP</translation>
    </message>
    <message>
        <source>Open a lab in one file</source>
        <translation>Ouvrir un TP en un seul fichier</translation>
    </message>
    <message>
        <source>Labs and work (*.cradle *.cradle-work);;All files (*)</source>
        <translation>TP et travaux (*.cradle *.cradle-work);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation>Ouvrir une scène</translation>
    </message>
    <message>
        <source>Scenes (*.json);;All files (*)</source>
        <translation>Scènes (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Enregistrer la scène</translation>
    </message>
</context>
<context>
    <name>cradle::OtherMistakesMenu</name>
    <message>
        <source>A mistake of another &amp;step</source>
        <translation>Une erreur d&apos;une autre &amp;étape</translation>
    </message>
    <message>
        <source>No mistake of another step applies to this solution that the step does not have</source>
        <translation>Cette étape a déjà toutes les erreurs d&apos;autres étapes qui s&apos;appliquent à ce corrigé</translation>
    </message>
</context>
<context>
    <name>cradle::ParameterForm</name>
    <message>
        <source>left out</source>
        <translation>omis</translation>
    </message>
    <message>
        <source>%1 (usual)</source>
        <translation>%1 (habituel)</translation>
    </message>
</context>
<context>
    <name>cradle::PhaseChart</name>
    <message>
        <source>Vertical axis: %1</source>
        <translation>Axe vertical&#xa0;: %1</translation>
    </message>
    <message>
        <source>Horizontal axis: %1</source>
        <translation>Axe horizontal&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 against %2</source>
        <translation>%1 en fonction de&#xa0;: %2</translation>
    </message>
    <message>
        <source>Press Run to see one quantity against another</source>
        <translation>Appuyez sur «&#xa0;Lancer&#xa0;» pour voir une grandeur en fonction d&apos;une autre</translation>
    </message>
    <message>
        <source>There is nothing to draw: choose other quantities</source>
        <translation>Il n&apos;y a rien à tracer&#xa0;: choisissez d&apos;autres grandeurs</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <comment>quantity, unit</comment>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>against</source>
        <translation>en fonction de</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>quantity, unit</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Circle %1</source>
        <translation>Cercle %1</translation>
    </message>
    <message>
        <source>All together</source>
        <translation>Tous ensemble</translation>
    </message>
    <message>
        <source>%1, circle %2</source>
        <comment>quantity, of</comment>
        <translation>%1, cercle %2</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <comment>quantity, value, unit</comment>
        <translation>%1&#xa0;: %2 %3</translation>
    </message>
</context>
<context>
    <name>cradle::PictureObjects</name>
    <message>
        <source>pictures from elsewhere are not loaded</source>
        <translation>les images venues d&apos;ailleurs ne sont pas chargées</translation>
    </message>
    <message>
        <source>the picture must be in the folder of the instructions</source>
        <translation>l&apos;image doit être dans le dossier des instructions</translation>
    </message>
    <message>
        <source>there is no picture %1</source>
        <translation>il n&apos;y a pas d&apos;image %1</translation>
    </message>
    <message>
        <source>the picture cannot be read</source>
        <translation>l&apos;image est illisible</translation>
    </message>
    <message>
        <source>the picture refers to another file</source>
        <translation>l&apos;image renvoie à un autre fichier</translation>
    </message>
    <message>
        <source>the picture is too large; at most %1 × %1 pixels are right</source>
        <translation>l&apos;image est trop grande&#xa0;; au plus %1 × %1 pixels conviennent</translation>
    </message>
</context>
<context>
    <name>cradle::PinnedRuns</name>
    <message>
        <source>pinned %1</source>
        <comment>a run</comment>
        <translation>épinglée %1</translation>
    </message>
    <message>
        <source>%1: how it went on after %2 s</source>
        <comment>kept run, moment</comment>
        <translation>%1&#xa0;: comment cela continuait après %2 s</translation>
    </message>
    <message>
        <source>%1: the same scene and program</source>
        <translation>%1&#xa0;: même scène et même programme</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 et %n autre</numerusform>
            <numerusform>%1 et %n autres</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::Plot</name>
    <message>
        <source>%1 %</source>
        <comment>share</comment>
        <translation>%1&#xa0;%</translation>
    </message>
</context>
<context>
    <name>cradle::PlotPane</name>
    <message>
        <source>Zoom, pin and export</source>
        <translation>Zoomer, épingler et exporter</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Zoom &amp;avant</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Zoom a&amp;rrière</translation>
    </message>
    <message>
        <source>&amp;Reset zoom</source>
        <translation>Réin&amp;itialiser le zoom</translation>
    </message>
    <message>
        <source>&amp;Pin this run</source>
        <translation>É&amp;pingler cette exécution</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <comment>a kept run</comment>
        <translation>Retirer&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>cradle::PlotsChart</name>
    <message>
        <source>Plots</source>
        <translation>Tracés</translation>
    </message>
    <message>
        <source>plot(name, number) in your program adds a curve here</source>
        <translation>plot(name, number) dans votre programme ajoute ici une courbe</translation>
    </message>
</context>
<context>
    <name>cradle::PredictionCard</name>
    <message>
        <source>Not sure</source>
        <translation>Je ne sais pas</translation>
    </message>
    <message>
        <source>The scene has run already. What did you expect?</source>
        <translation>La scène a déjà tourné. À quoi vous attendiez-vous&#xa0;?</translation>
    </message>
    <message>
        <source>Choose before you run the scene. The check does not count it.</source>
        <translation>Choisissez avant de lancer la scène. La vérification n&apos;en tient pas compte.</translation>
    </message>
    <message>
        <source>Kept. Did it come so?</source>
        <translation>Noté. Est-ce bien ce qui s&apos;est passé&#xa0;?</translation>
    </message>
    <message>
        <source>Kept. Now run the scene and watch.</source>
        <translation>Noté. Maintenant, lancez la scène et observez.</translation>
    </message>
    <message>
        <source>You were not sure.</source>
        <translation>Vous n&apos;avez pas tranché.</translation>
    </message>
    <message>
        <source>You predicted: %1</source>
        <translation>Vous avez prédit&#xa0;: %1</translation>
    </message>
    <message>
        <source>Predict</source>
        <translation>Prédire</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>Prédiction</translation>
    </message>
    <message>
        <source>What happens: %1.</source>
        <translation>Ce qui se passe&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Question</translation>
    </message>
    <message>
        <source>What happens</source>
        <translation>Ce qui se passe</translation>
    </message>
    <message>
        <source>Show what happens ▸</source>
        <translation>Montrer ce qui se passe ▸</translation>
    </message>
    <message>
        <source>Show what happens</source>
        <translation>Montrer ce qui se passe</translation>
    </message>
</context>
<context>
    <name>cradle::PredictionEditor</name>
    <message>
        <source>What will happen?</source>
        <translation>Que va-t-il se passer&#xa0;?</translation>
    </message>
    <message>
        <source>The first answer</source>
        <translation>La première réponse</translation>
    </message>
    <message>
        <source>The second answer</source>
        <translation>La deuxième réponse</translation>
    </message>
    <message>
        <source>What happens, and why.</source>
        <translation>Ce qui se passe, et pourquoi.</translation>
    </message>
    <message>
        <source>Another answer</source>
        <translation>Une autre réponse</translation>
    </message>
    <message>
        <source>A question of 1 to %1 characters is right</source>
        <translation>Il faut une question de 1 à %1 caractères</translation>
    </message>
    <message>
        <source>A text of 1 to %1 characters on what happens is right</source>
        <translation>Il faut un texte de 1 à %1 caractères sur ce qui se passe</translation>
    </message>
    <message>
        <source>An answer of 1 to 100 characters is right</source>
        <translation>Il faut une réponse de 1 à 100 caractères</translation>
    </message>
    <message>
        <source>This step asks for no prediction. A question that is asked before the scene is watched, and answered after it, makes students look.</source>
        <translation>Cette étape ne demande pas de prédiction. Une question posée avant de regarder la scène, et à laquelle on répond après, fait regarder les étudiants.</translation>
    </message>
    <message>
        <source>Ask for a prediction</source>
        <translation>Demander une prédiction</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Question</translation>
    </message>
    <message>
        <source>Answers: two to four that students truly believe; mark the one that comes true</source>
        <translation>Réponses&#xa0;: deux à quatre que des étudiants croient vraiment&#xa0;; marquez celle qui se réalise</translation>
    </message>
    <message>
        <source>Answer %1 comes true</source>
        <translation>La réponse %1 se réalise</translation>
    </message>
    <message>
        <source>Answer %1</source>
        <translation>Réponse %1</translation>
    </message>
    <message>
        <source>Remove answer %1</source>
        <translation>Supprimer la réponse %1</translation>
    </message>
    <message>
        <source>Add an answer</source>
        <translation>Ajouter une réponse</translation>
    </message>
    <message>
        <source>What happens, and why; told after the step was passed</source>
        <translation>Ce qui se passe, et pourquoi&#xa0;; dit une fois l&apos;étape réussie</translation>
    </message>
    <message>
        <source>What happens, and why</source>
        <translation>Ce qui se passe, et pourquoi</translation>
    </message>
    <message>
        <source>Remove the prediction</source>
        <translation>Supprimer la prédiction</translation>
    </message>
    <message>
        <source>What the student sees before</source>
        <translation>Ce que l&apos;étudiant voit avant</translation>
    </message>
    <message>
        <source>And after</source>
        <translation>Et après</translation>
    </message>
</context>
<context>
    <name>cradle::Presenter</name>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
</context>
<context>
    <name>cradle::PresetDocument</name>
    <message>
        <source>Start from %1 s</source>
        <translation>Démarrer à %1 s</translation>
    </message>
    <message>
        <source>This is a scene of the check; go back to your own scene to change it</source>
        <translation>C&apos;est une scène de la vérification&#xa0;; revenez à votre propre scène pour la changer</translation>
    </message>
    <message>
        <source>Reset to the step&apos;s own scene</source>
        <translation>Revenir à la scène de l&apos;étape</translation>
    </message>
</context>
<context>
    <name>cradle::ProgramPage</name>
    <message>
        <source>Program %1</source>
        <translation>Programme %1</translation>
    </message>
    <message>
        <source>What a student&apos;s program starts from in this step.</source>
        <translation>Ce par quoi commence le programme d&apos;un étudiant dans cette étape.</translation>
    </message>
    <message>
        <source>None of its own: students go on from the solution of the step before. Write here to start from something else.</source>
        <translation>Cette étape n&apos;en a pas&#xa0;: les étudiants continuent à partir du corrigé de l&apos;étape précédente. Écrivez ici pour partir d&apos;autre chose.</translation>
    </message>
    <message>
        <source>The reference: it should pass every check, with every seed.</source>
        <translation>Le corrigé de référence&#xa0;: il doit réussir chaque vérification, avec chaque graine.</translation>
    </message>
    <message>
        <source>The solution was changed where this difference changes it. Mend the lines after @@ so that they say what stands in the solution now, and what stands here instead.</source>
        <translation>Le corrigé a été modifié là où cette différence le modifie. Réparez les lignes après @@ pour qu&apos;elles disent ce qu&apos;il y a maintenant dans le corrigé, et ce qu&apos;il y a ici à la place.</translation>
    </message>
    <message>
        <source>A whole program with one mistake: it fails by a check, and who wrote the same reads the comment that it begins with.</source>
        <translation>Un programme entier avec une seule erreur&#xa0;: il échoue à une vérification, et qui a écrit la même lit le commentaire par lequel il commence.</translation>
    </message>
    <message>
        <source>A whole program that passes and deserves a word.</source>
        <translation>Un programme entier qui réussit et mérite un mot.</translation>
    </message>
    <message>
        <source>It is kept as its difference from the solution, which is marked, and follows it.</source>
        <translation>Il est conservé comme différence par rapport au corrigé&#xa0;; elle est marquée, et il suit le corrigé.</translation>
    </message>
    <message>
        <source>Edit a program</source>
        <translation>Modifier un programme</translation>
    </message>
    <message>
        <source>Edit what the student reads</source>
        <translation>Modifier ce que lit l&apos;étudiant</translation>
    </message>
    <message>
        <source>Edit a remark</source>
        <translation>Modifier une appréciation</translation>
    </message>
    <message>
        <source>What the student reads</source>
        <translation>Ce que lit l&apos;étudiant</translation>
    </message>
    <message>
        <source>How it is recognised</source>
        <translation>À quoi on la reconnaît</translation>
    </message>
    <message>
        <source>About the program</source>
        <translation>À propos du programme</translation>
    </message>
    <message>
        <source>The comment that the program begins with, or its translation</source>
        <translation>Le commentaire par lequel commence le programme, ou sa traduction</translation>
    </message>
    <message>
        <source>What the student reads, translated</source>
        <translation>Ce que lit l&apos;étudiant, traduit</translation>
    </message>
    <message>
        <source>The starter for students who read %1: the same code, with comments in that language. Without it they get starter.lua.</source>
        <translation>Le programme de départ pour qui lit %1&#xa0;: le même code, avec des commentaires dans cette langue. Sans lui, c&apos;est starter.lua.</translation>
    </message>
</context>
<context>
    <name>cradle::ProgramsTab</name>
    <message>
        <source>-- What went wrong, in a few words
--
-- What was observed, what it means, and where to look.
</source>
        <translation>-- Ce qui n&apos;allait pas, en quelques mots
--
-- Ce qui a été observé, ce que cela veut dire, et où regarder.
</translation>
    </message>
    <message>
        <source>-- What is good about it, in a few words
--
-- What it does otherwise than most, and what that is worth.
</source>
        <translation>-- Ce qu&apos;il y a de bien, en quelques mots
--
-- Ce qu&apos;il fait autrement que la plupart, et ce que cela vaut.
</translation>
    </message>
    <message>
        <source>Add a mistake</source>
        <translation>Ajouter une erreur</translation>
    </message>
    <message>
        <source>Add a remark</source>
        <translation>Ajouter une appréciation</translation>
    </message>
    <message>
        <source>Remove a program</source>
        <translation>Supprimer un programme</translation>
    </message>
    <message>
        <source>Rename a program</source>
        <translation>Renommer un programme</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programmes</translation>
    </message>
    <message>
        <source>Programs of the step</source>
        <translation>Programmes de l&apos;étape</translation>
    </message>
    <message>
        <source>Add a program</source>
        <translation>Ajouter un programme</translation>
    </message>
    <message>
        <source>Rename the program</source>
        <translation>Renommer le programme</translation>
    </message>
    <message>
        <source>Remove the program</source>
        <translation>Supprimer le programme</translation>
    </message>
    <message>
        <source>A &amp;mistake that students make</source>
        <translation>Une &amp;erreur que font les étudiants</translation>
    </message>
    <message>
        <source>A &amp;remark on work that passes</source>
        <translation>Une &amp;appréciation sur un travail qui réussit</translation>
    </message>
    <message>
        <source>Take over a mistake</source>
        <translation>Reprendre une erreur</translation>
    </message>
</context>
<context>
    <name>cradle::ProofMatrix</name>
    <message>
        <source>Programs and the checks that they fail</source>
        <translation>Les programmes et les vérifications où ils échouent</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Said of it</source>
        <translation>Ce qu&apos;on en dit</translation>
    </message>
    <message>
        <source>Check %1</source>
        <translation>Vérification %1</translation>
    </message>
    <message>
        <source>Just wrong enough</source>
        <translation>Juste assez faux</translation>
    </message>
    <message>
        <source>%1: turned by %2, too fast by %3, adrift by %4</source>
        <translation>%1&#xa0;: tournée de %2, trop rapide de %3, décalée de %4</translation>
    </message>
    <message>
        <source>%1: not measured</source>
        <translation>%1&#xa0;: pas de mesure</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>réussit</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>not recognised</source>
        <translation>non reconnu</translation>
    </message>
    <message>
        <source>By how much a right run must be turned, too fast or adrift, or how wrong restitution and masses must be in its first hit, for the check to fail it</source>
        <translation>De combien une exécution juste doit être tournée, trop rapide ou décalée, ou à quel point la restitution et les masses doivent être fausses à son premier choc, pour échouer à la vérification</translation>
    </message>
    <message>
        <source>; a hit with %1</source>
        <translation>; un choc avec %1</translation>
    </message>
</context>
<context>
    <name>cradle::ProofTab</name>
    <message>
        <source>Every program runs through the checks…</source>
        <translation>Chaque programme passe par les vérifications…</translation>
    </message>
    <message>
        <source>Press Verify this step: the starter should fail by a check, the solution pass with every seed, and each mistake fail and be recognised.</source>
        <translation>Appuyez sur «&#xa0;Vérifier cette étape&#xa0;»&#xa0;: le programme de départ doit échouer à une vérification, le corrigé réussir avec chaque graine, et chaque erreur échouer et être reconnue.</translation>
    </message>
    <message>
        <source>Not as it should be: %1</source>
        <translation>Pas comme il faut&#xa0;: %1</translation>
    </message>
    <message>
        <source>The solution passes, and every mistake fails and is recognised; but a check is missing: changes of the solution that pass every check: %1</source>
        <translation>Le corrigé réussit, et chaque erreur échoue et est reconnue&#xa0;; mais il manque une vérification, car ces modifications du corrigé réussissent toutes les vérifications&#xa0;: %1</translation>
    </message>
    <message>
        <source>All is as it should be: the solution passes, every mistake fails and is recognised, every check is needed.</source>
        <translation>Tout est comme il faut&#xa0;: le corrigé réussit, chaque erreur échoue et est reconnue, chaque vérification est nécessaire.</translation>
    </message>
    <message>
        <source>All is as it should be: the solution passes, every mistake fails and is recognised.</source>
        <translation>Tout est comme il faut&#xa0;: le corrigé réussit, chaque erreur échoue et est reconnue.</translation>
    </message>
    <message>
        <source>So it is in every step of the lab.</source>
        <translation>Il en va de même à chaque étape du TP.</translation>
    </message>
    <message>
        <source>Not as it should be in other steps: %1</source>
        <translation>Pas comme il faut dans d&apos;autres étapes&#xa0;: %1</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Worth a look</source>
        <translation>À regarder</translation>
    </message>
    <message>
        <source>Mistakes that this step does not know</source>
        <translation>Erreurs que cette étape ne connaît pas</translation>
    </message>
    <message>
        <source>Mistakes that this step did not know before the last edits</source>
        <translation>Erreurs que cette étape ne connaissait pas avant les dernières modifications</translation>
    </message>
    <message>
        <source>None was found: each change of the solution is caught and explained.</source>
        <translation>Aucune trouvée&#xa0;: chaque modification du corrigé est détectée et expliquée.</translation>
    </message>
    <message>
        <source>Show the run</source>
        <translation>Montrer l&apos;exécution</translation>
    </message>
    <message>
        <source>Open the scene</source>
        <translation>Ouvrir la scène</translation>
    </message>
    <message>
        <source>Open the program</source>
        <translation>Ouvrir le programme</translation>
    </message>
    <message>
        <source>Open the check</source>
        <translation>Ouvrir la vérification</translation>
    </message>
    <message>
        <source>Open the programs</source>
        <translation>Ouvrir les programmes</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Passes every check, so one is missing: %1 (%2)</source>
        <translation>Réussit toutes les vérifications, il en manque donc une&#xa0;: %1 (%2)</translation>
    </message>
    <message>
        <source>Fails by “%1” without a word on why: %2 (%3)</source>
        <translation>Échoue à «&#xa0;%1&#xa0;» sans un mot sur le pourquoi&#xa0;: %2 (%3)</translation>
    </message>
    <message>
        <source>Add as a mistake</source>
        <translation>Ajouter comme erreur</translation>
    </message>
    <message>
        <source>Add a suggested mistake</source>
        <translation>Ajouter une erreur proposée</translation>
    </message>
    <message>
        <source>Verify this step</source>
        <translation>Vérifier cette étape</translation>
    </message>
    <message>
        <source>Judges every program of the step, the solution with five seeds</source>
        <translation>Évalue chaque programme de l&apos;étape, le corrigé avec cinq graines</translation>
    </message>
    <message>
        <source>Verify the lab</source>
        <translation>Vérifier le TP</translation>
    </message>
    <message>
        <source>Suggest mistakes</source>
        <translation>Proposer des erreurs</translation>
    </message>
    <message>
        <source>Changes the solution as students err, and tells which changes the checks miss or cannot explain</source>
        <translation>Modifie le corrigé comme se trompent les étudiants, et dit quelles modifications les vérifications manquent ou ne savent pas expliquer</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Progress of the proof</source>
        <translation>Progression de la preuve</translation>
    </message>
    <message>
        <source>The lab was edited since.</source>
        <translation>Le TP a été modifié depuis.</translation>
    </message>
    <message>
        <source>Fails by “%1”; students read: “%2”, of: %3 (%4)</source>
        <translation>Échoue à «&#xa0;%1&#xa0;»&#xa0;; on lit «&#xa0;%2&#xa0;», pour&#xa0;: %3 (%4)</translation>
    </message>
</context>
<context>
    <name>cradle::QuestionField</name>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a number with its unit</source>
        <translation>un nombre avec son unité</translation>
    </message>
    <message>
        <source>In a few sentences, for the teacher</source>
        <translation>En quelques phrases, pour l&apos;enseignant</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Monter</translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation>Alt+Haut</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Descendre</translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation>Alt+Bas</translation>
    </message>
</context>
<context>
    <name>cradle::QuestionsCard</name>
    <message>
        <source>Questions</source>
        <translation>Questions</translation>
    </message>
    <message>
        <source>The check counts your answers.</source>
        <translation>La vérification tient compte de vos réponses.</translation>
    </message>
    <message>
        <source>%1 (%2 points)</source>
        <translation>%1 (%2 points)</translation>
    </message>
</context>
<context>
    <name>cradle::QuestionsEditor</name>
    <message>
        <source>Questions · %1</source>
        <translation>Questions · %1</translation>
    </message>
    <message>
        <source>Answers in the right order; students find them in another</source>
        <translation>Réponses dans le bon ordre&#xa0;; les étudiants les voient dans un autre</translation>
    </message>
    <message>
        <source>Answers; mark the right one</source>
        <translation>Réponses&#xa0;; marquez la bonne</translation>
    </message>
    <message>
        <source>Answers; mark all that are right</source>
        <translation>Réponses&#xa0;; marquez toutes les bonnes</translation>
    </message>
    <message>
        <source>A new question</source>
        <translation>Une nouvelle question</translation>
    </message>
    <message>
        <source>What is asked?</source>
        <translation>Que demande-t-on&#xa0;?</translation>
    </message>
    <message>
        <source>The first answer</source>
        <translation>La première réponse</translation>
    </message>
    <message>
        <source>The second answer</source>
        <translation>La deuxième réponse</translation>
    </message>
    <message>
        <source>A title of 1 to 200 characters is right</source>
        <translation>Il faut un titre de 1 à 200 caractères</translation>
    </message>
    <message>
        <source>Another question has this id already</source>
        <translation>Une autre question a déjà cet id</translation>
    </message>
    <message>
        <source>Tolerance: a number from 0 is right</source>
        <translation>Tolérance&#xa0;: il faut un nombre à partir de 0</translation>
    </message>
    <message>
        <source>%1 is no unit; one like m/s, kg m/s, N s, J, ° or % is right</source>
        <translation>%1 n&apos;est pas une unité&#xa0;; il en faut une comme m/s, kg m/s, N s, J, ° ou %</translation>
    </message>
    <message>
        <source>Another answer</source>
        <translation>Une autre réponse</translation>
    </message>
    <message>
        <source>Questions of the step</source>
        <translation>Questions de l&apos;étape</translation>
    </message>
    <message>
        <source>Add a question</source>
        <translation>Ajouter une question</translation>
    </message>
    <message>
        <source>Remove the question</source>
        <translation>Supprimer la question</translation>
    </message>
    <message>
        <source>Move the question up</source>
        <translation>Monter la question</translation>
    </message>
    <message>
        <source>Move the question down</source>
        <translation>Descendre la question</translation>
    </message>
    <message>
        <source>This step asks no question that counts. Add one with the plus: a number with its unit, a choice, an order, or a text that you read yourself.</source>
        <translation>Cette étape ne pose aucune question qui compte. Ajoutez-en une avec le plus&#xa0;: un nombre avec son unité, un choix, un ordre, ou un texte que vous lisez vous-même.</translation>
    </message>
    <message>
        <source>A number</source>
        <translation>Un nombre</translation>
    </message>
    <message>
        <source>One choice</source>
        <translation>Un seul choix</translation>
    </message>
    <message>
        <source>Several choices</source>
        <translation>Plusieurs choix</translation>
    </message>
    <message>
        <source>An order</source>
        <translation>Un ordre</translation>
    </message>
    <message>
        <source>A text for the teacher</source>
        <translation>Un texte pour l&apos;enseignant</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Kind of the question</source>
        <translation>Type de la question</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Right number</source>
        <translation>Nombre juste</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Reports name the question by it</source>
        <translation>Les rapports nomment ainsi la question</translation>
    </message>
    <message>
        <source>What a right answer is worth; of a text, what you may give</source>
        <translation>Ce que vaut une bonne réponse&#xa0;; pour un texte, ce que vous pouvez donner</translation>
    </message>
    <message>
        <source>A number, or an expression like 2*9.81*5</source>
        <translation>Un nombre, ou une expression comme 2*9.81*5</translation>
    </message>
    <message>
        <source>How far off is still right, in the unit</source>
        <translation>L&apos;écart encore admis, dans l&apos;unité</translation>
    </message>
    <message>
        <source>Such as m/s, kg m/s, N s, J, ° or %; answers in other units of the same kind are converted</source>
        <translation>Par exemple m/s, kg m/s, N s, J, ° ou %&#xa0;; les réponses dans d&apos;autres unités du même type sont converties</translation>
    </message>
    <message>
        <source>What is asked</source>
        <translation>Ce qui est demandé</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Réponses</translation>
    </message>
    <message>
        <source>Add an answer</source>
        <translation>Ajouter une réponse</translation>
    </message>
    <message>
        <source>Remove the answer</source>
        <translation>Supprimer la réponse</translation>
    </message>
    <message>
        <source>Move the answer up</source>
        <translation>Monter la réponse</translation>
    </message>
    <message>
        <source>Move the answer down</source>
        <translation>Descendre la réponse</translation>
    </message>
    <message>
        <source>What the student sees, answered rightly</source>
        <translation>Ce que voit l&apos;étudiant, avec la bonne réponse</translation>
    </message>
</context>
<context>
    <name>cradle::RemarkEditor</name>
    <message>
        <source>A student&apos;s program that passes is run beside this one and beside the solution. Where these two differ and the student&apos;s does as this one, the remark is made.</source>
        <translation>Un programme d&apos;étudiant qui réussit est exécuté à côté de celui-ci et à côté du corrigé. Là où ces deux-ci diffèrent et où celui de l&apos;étudiant fait comme celui-ci, l&apos;appréciation est donnée.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>Ce qui est comparé</translation>
    </message>
    <message>
        <source>Velocities: they differ at a hit</source>
        <translation>Vitesses&#xa0;: elles diffèrent lors d&apos;un choc</translation>
    </message>
    <message>
        <source>Positions: they differ in many steps</source>
        <translation>Positions&#xa0;: elles diffèrent dans beaucoup de pas</translation>
    </message>
    <message>
        <source>Fields: numbers that the program keeps with the circles, as mass</source>
        <translation>Champs&#xa0;: des nombres que le programme garde avec les cercles, comme mass</translation>
    </message>
</context>
<context>
    <name>cradle::ReportDialog</name>
    <message>
        <source>Looking back at %1</source>
        <translation>Rétrospective&#xa0;: %1</translation>
    </message>
    <message>
        <source>The steps of the lab, and what was hard</source>
        <translation>Les étapes du TP, et ce qui était difficile</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Rapport…</translation>
    </message>
    <message>
        <source>&amp;Hand in…</source>
        <translation>Re&amp;ndre…</translation>
    </message>
    <message>
        <source>Every step is judged once more…</source>
        <translation>Chaque étape est évaluée encore une fois…</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>Documents (*.pdf);;Web pages (*.html)</source>
        <translation>Documents (*.pdf);;Pages web (*.html)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Enregistré&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>cradle::ResultPane</name>
    <message>
        <source>Checking… %1 of %2</source>
        <translation>Vérification… %1 sur %2</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Vérification…</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Nothing to check: this scene belongs to no step.</source>
        <translation>Rien à vérifier&#xa0;: cette scène n&apos;appartient à aucune étape.</translation>
    </message>
    <message>
        <source>Press Check (Ctrl+Return) when you are done.</source>
        <translation>Appuyez sur «&#xa0;Vérifier&#xa0;» (Ctrl+Entrée) quand vous avez fini.</translation>
    </message>
    <message>
        <source>Changed since this check</source>
        <translation>Modifié depuis cette vérification</translation>
    </message>
    <message>
        <source>Not yet: %1</source>
        <translation>Pas encore&#xa0;: %1</translation>
    </message>
    <message>
        <source>Line %1 ▸</source>
        <translation>Ligne %1 ▸</translation>
    </message>
    <message>
        <source>Show line %1 of the program</source>
        <translation>Montrer la ligne %1 du programme</translation>
    </message>
    <message>
        <source>✓ Passed: all %1 checks and answers</source>
        <translation>✓ Réussi&#xa0;: les %1 vérifications et réponses</translation>
    </message>
    <message>
        <source>✓ Passed: the check</source>
        <translation>✓ Réussi&#xa0;: la vérification</translation>
    </message>
    <message>
        <source>✓ Passed: all %1 checks</source>
        <translation>✓ Réussi&#xa0;: les %1 vérifications</translation>
    </message>
    <message>
        <source>The step counts as passed as soon as the run of this work was shown.</source>
        <translation>L&apos;étape compte comme réussie dès que l&apos;exécution de ce travail a été montrée.</translation>
    </message>
    <message>
        <source>✓ You have passed this step</source>
        <translation>✓ Vous avez réussi cette étape</translation>
    </message>
    <message>
        <source>on %1 at %2</source>
        <translation>le %1 à %2</translation>
    </message>
    <message>
        <source>That was the last step.</source>
        <translation>C&apos;était la dernière étape.</translation>
    </message>
    <message>
        <source>Still open: %1</source>
        <translation>Encore à faire&#xa0;: %1</translation>
    </message>
    <message>
        <source>Next step ▸</source>
        <translation>Étape suivante ▸</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Étape suivante</translation>
    </message>
    <message>
        <source>Next step (Ctrl+Page Down)</source>
        <translation>Étape suivante (Ctrl+Page suiv.)</translation>
    </message>
    <message>
        <source>Compare with the reference ▸</source>
        <translation>Comparer avec le corrigé ▸</translation>
    </message>
    <message>
        <source>Compare with the reference</source>
        <translation>Comparer avec le corrigé</translation>
    </message>
    <message>
        <source>Shows the reference solution beside your program</source>
        <translation>Montre le corrigé à côté de votre programme</translation>
    </message>
    <message>
        <source>Commit message</source>
        <translation>Message de commit</translation>
    </message>
    <message>
        <source>Copy the commit message</source>
        <translation>Copier le message de commit</translation>
    </message>
    <message>
        <source>Back to the scene that passed ▸</source>
        <translation>Revenir à la scène qui a réussi ▸</translation>
    </message>
    <message>
        <source>Back to the scene that passed</source>
        <translation>Revenir à la scène qui a réussi</translation>
    </message>
    <message>
        <source>Sets the values with which you passed this step; Undo takes that back</source>
        <translation>Rétablit les valeurs avec lesquelles vous avez réussi cette étape&#xa0;; Annuler revient en arrière</translation>
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
        <translation>Suppr</translation>
    </message>
    <message>
        <source>Alt+Up</source>
        <translation>Alt+Haut</translation>
    </message>
    <message>
        <source>Alt+Down</source>
        <translation>Alt+Bas</translation>
    </message>
</context>
<context>
    <name>cradle::RunDesk</name>
    <message numerus="yes">
        <source>%n runs are pinned; remove one of them first.</source>
        <translation>
            <numerusform>%n exécution est épinglée&#xa0;; retirez-la d&apos;abord.</numerusform>
            <numerusform>%n exécutions sont épinglées&#xa0;; retirez-en d&apos;abord une.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no run yet: press Run, then pin it.</source>
        <translation>Il n&apos;y a pas encore d&apos;exécution&#xa0;: appuyez sur «&#xa0;Lancer&#xa0;», puis épinglez-la.</translation>
    </message>
    <message>
        <source>Your program sets values of circles when it is loaded: the new run starts with those.</source>
        <translation>Votre programme fixe des valeurs de cercles à son chargement&#xa0;: la nouvelle exécution démarre avec celles-là.</translation>
    </message>
    <message>
        <source>Save the data of the run</source>
        <translation>Enregistrer les données de l&apos;exécution</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
</context>
<context>
    <name>cradle::SceneActions</name>
    <message>
        <source>Cu&amp;t circles</source>
        <translation>Cou&amp;per les cercles</translation>
    </message>
    <message>
        <source>&amp;Copy circles</source>
        <translation>&amp;Copier les cercles</translation>
    </message>
    <message>
        <source>&amp;Paste circles</source>
        <translation>C&amp;oller les cercles</translation>
    </message>
    <message>
        <source>&amp;Duplicate circles</source>
        <translation>&amp;Dupliquer les cercles</translation>
    </message>
    <message>
        <source>Re&amp;move circles</source>
        <translation>Suppri&amp;mer les cercles</translation>
    </message>
    <message>
        <source>Set velocities to &amp;zero</source>
        <translation>Vitesses à &amp;zéro</translation>
    </message>
    <message>
        <source>Select a&amp;ll circles</source>
        <translation>Sé&amp;lectionner tous les cercles</translation>
    </message>
</context>
<context>
    <name>cradle::SceneDesk</name>
    <message>
        <source>Nothing hits anything within the next minute.</source>
        <translation>Aucun choc dans la minute qui vient.</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>corrigé</translation>
    </message>
    <message>
        <source>so far in this step</source>
        <translation>jusqu&apos;ici dans cette étape</translation>
    </message>
    <message>
        <source>This is a scene of the check, at the moment where it went wrong.</source>
        <translation>C&apos;est une scène de la vérification, à l&apos;instant où cela a échoué.</translation>
    </message>
    <message>
        <source>This is a scene of the check.</source>
        <translation>C&apos;est une scène de la vérification.</translation>
    </message>
    <message>
        <source>Back to my scene</source>
        <translation>Revenir à ma scène</translation>
    </message>
</context>
<context>
    <name>cradle::SceneEditor</name>
    <message>
        <source>Your program sets this circle in on_load; change it there</source>
        <translation>Votre programme fixe ce cercle dans on_load&#xa0;; changez-le là</translation>
    </message>
    <message numerus="yes">
        <source>%n circles</source>
        <translation>
            <numerusform>%n cercle</numerusform>
            <numerusform>%n cercles</numerusform>
        </translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter&#xa0;: %1</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Dupliquer&#xa0;: %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Supprimer&#xa0;: %1</translation>
    </message>
    <message>
        <source>Set velocity of %1 to zero</source>
        <translation>Mettre à zéro la vitesse&#xa0;: %1</translation>
    </message>
    <message>
        <source>Press Restart (R) to change the start, or start a new run from here (Ctrl+Shift+R)</source>
        <translation>Appuyez sur «&#xa0;Recommencer&#xa0;» (R) pour changer le départ, ou démarrez une nouvelle exécution d&apos;ici (Ctrl+Maj+R)</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer&#xa0;: %1</translation>
    </message>
    <message>
        <source>Paste a circle</source>
        <translation>Coller un cercle</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n circles</source>
        <translation>
            <numerusform>Coller %n cercle</numerusform>
            <numerusform>Coller %n cercles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cradle::SceneForm</name>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Kind of the scenes</source>
        <translation>Type des scènes</translation>
    </message>
</context>
<context>
    <name>cradle::SceneTab</name>
    <message>
        <source>Add the scene that passes</source>
        <translation>Ajouter la scène qui réussit</translation>
    </message>
    <message>
        <source>Remove the scene that passes</source>
        <translation>Supprimer la scène qui réussit</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>Modèles</translation>
    </message>
    <message>
        <source>Scenes to begin with; the one that is here is replaced</source>
        <translation>Des scènes pour commencer&#xa0;; celle qui est là est remplacée</translation>
    </message>
    <message>
        <source>Start from this moment</source>
        <translation>Démarrer de cet instant</translation>
    </message>
    <message>
        <source>The circles start where, and as fast as, they are at the moment shown</source>
        <translation>Les cercles démarrent là où ils sont à l&apos;instant affiché, et aussi vite</translation>
    </message>
    <message>
        <source>What the student may not change in this step</source>
        <translation>Ce que l&apos;étudiant ne peut pas changer dans cette étape</translation>
    </message>
    <message>
        <source>Back to the step&apos;s scene</source>
        <translation>Revenir à la scène de l&apos;étape</translation>
    </message>
    <message>
        <source>Remove this scene</source>
        <translation>Supprimer cette scène</translation>
    </message>
    <message>
        <source>Students may also pass without a program, by setting the scene and its laws. This step has no scene yet that passes its checks so; with one, the proof looks after it, too.</source>
        <translation>Les étudiants peuvent aussi réussir sans programme, en réglant la scène et ses lois. Cette étape n&apos;a pas encore de scène qui réussisse ainsi ses vérifications&#xa0;; avec une telle scène, la preuve s&apos;en occupe aussi.</translation>
    </message>
    <message>
        <source>Make it from what the student finds</source>
        <translation>La faire à partir de ce que trouve l&apos;étudiant</translation>
    </message>
    <message>
        <source>What the student finds</source>
        <translation>Ce que trouve l&apos;étudiant</translation>
    </message>
    <message>
        <source>What passes without a program</source>
        <translation>Ce qui réussit sans programme</translation>
    </message>
    <message>
        <source>Which scene of the step</source>
        <translation>Quelle scène de l&apos;étape</translation>
    </message>
    <message>
        <source>Moved by the scene&apos;s laws</source>
        <translation>Déplacés par les lois de la scène</translation>
    </message>
    <message>
        <source>Moved by solution.lua</source>
        <translation>Déplacés par solution.lua</translation>
    </message>
    <message>
        <source>What moves the circles here</source>
        <translation>Ce qui déplace ici les cercles</translation>
    </message>
    <message>
        <source>Take the template %1</source>
        <translation>Prendre le modèle %1</translation>
    </message>
    <message>
        <source>Lock…</source>
        <translation>Verrouiller…</translation>
    </message>
    <message>
        <source>Locked: %1</source>
        <translation>Verrouillé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Lock a field</source>
        <translation>Verrouiller un champ</translation>
    </message>
    <message>
        <source>Unlock a field</source>
        <translation>Déverrouiller un champ</translation>
    </message>
    <message>
        <source>&amp;Rack…</source>
        <translation>&amp;Triangle…</translation>
    </message>
    <message>
        <source>Gr&amp;id…</source>
        <translation>&amp;Grille…</translation>
    </message>
    <message>
        <source>Ri&amp;ng…</source>
        <translation>&amp;Anneau…</translation>
    </message>
    <message>
        <source>As text</source>
        <translation>En texte</translation>
    </message>
    <message>
        <source>The file of this scene, in which numbers may be expressions</source>
        <translation>Le fichier de cette scène, où les nombres peuvent être des expressions</translation>
    </message>
    <message>
        <source>Add a circle: + Add circle</source>
        <translation>Aucun cercle encore&#xa0;: + Ajouter un cercle</translation>
    </message>
</context>
<context>
    <name>cradle::SceneText</name>
    <message>
        <source>Write the scene</source>
        <translation>Écrire la scène</translation>
    </message>
    <message>
        <source>Numbers may be expressions, in quotes: &quot;1 + 0.42*cos(pi/6)&quot;, &quot;20 cm&quot;, or with the lab&apos;s values, &quot;-e*v&quot;. What cannot be read stays here and is not in the lab yet.</source>
        <translation>Les nombres peuvent être des expressions, entre guillemets&#xa0;: &quot;1 + 0.42*cos(pi/6)&quot;, &quot;20 cm&quot;, ou avec les valeurs du TP, &quot;-e*v&quot;. Ce qui ne peut pas être lu reste ici et n&apos;est pas encore dans le TP.</translation>
    </message>
    <message>
        <source>The scene as text</source>
        <translation>La scène en texte</translation>
    </message>
</context>
<context>
    <name>cradle::SceneView</name>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>No hit at this moment: N goes on to the next one</source>
        <translation>Aucun choc à cet instant&#xa0;: N passe au suivant</translation>
    </message>
    <message>
        <source>Add circle here</source>
        <translation>Ajouter un cercle ici</translation>
    </message>
    <message>
        <source>Start a new run from here</source>
        <translation>Démarrer une nouvelle exécution d&apos;ici</translation>
    </message>
    <message>
        <source>Fit view</source>
        <translation>Ajuster la vue</translation>
    </message>
    <message>
        <source>ghost: %1 · %2 m apart</source>
        <translation>fantôme&#xa0;: %1 · à %2 m</translation>
    </message>
    <message>
        <source>No exact motion beside more than %1 circles</source>
        <translation>Pas de mouvement exact pour plus de %1 cercles</translation>
    </message>
    <message>
        <source>No exact motion: the circles overlap or lie outside at the start</source>
        <translation>Pas de mouvement exact&#xa0;: au départ, les cercles se chevauchent ou sont dehors</translation>
    </message>
    <message>
        <source>Exact motion; the run is %1 m off</source>
        <translation>Mouvement exact&#xa0;; l&apos;exécution s&apos;en écarte de %1 m</translation>
    </message>
    <message>
        <source>contacts merged from %1 s on</source>
        <translation>contacts fusionnés à partir de %1 s</translation>
    </message>
    <message>
        <source>first %1 s dropped</source>
        <translation>premières %1 s abandonnées</translation>
    </message>
    <message>
        <source>first %1 min dropped</source>
        <translation>premières %1 min abandonnées</translation>
    </message>
    <message>
        <source>Add a circle: Edit → Add circle (Ctrl+Shift+N)</source>
        <translation>Ajoutez un cercle&#xa0;: Édition → Ajouter un cercle (Ctrl+Maj+N)</translation>
    </message>
    <message>
        <source>%1 at %2 m with %3 m/s, radius %4 m</source>
        <translation>%1 en %2 m avec %3 m/s, rayon %4 m</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n autre</numerusform>
            <numerusform>et %n autres</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n sélectionné</numerusform>
            <numerusform>%n sélectionnés</numerusform>
        </translation>
    </message>
    <message>
        <source>selected: %1</source>
        <translation>sélection&#xa0;: %1</translation>
    </message>
    <message>
        <source>No circles</source>
        <translation>Aucun cercle</translation>
    </message>
</context>
<context>
    <name>cradle::ShareDialog</name>
    <message>
        <source>Share with git</source>
        <translation>Partager avec git</translation>
    </message>
    <message>
        <source>Your work is a git repository in %1. Its commits and versions can be sent to one of yours elsewhere; who may read that, reads all of them.</source>
        <translation>Votre travail est un dépôt git dans %1. Ses commits et ses versions peuvent être envoyés à un autre de vos dépôts&#xa0;; qui peut lire celui-ci les lit tous.</translation>
    </message>
    <message>
        <source>&amp;Address:</source>
        <translation>&amp;Adresse&#xa0;:</translation>
    </message>
    <message>
        <source>Sent so far:</source>
        <translation>Envoyé jusqu&apos;ici&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Send</source>
        <translation>&amp;Envoyer</translation>
    </message>
    <message>
        <source>All is sent.</source>
        <translation>Tout est envoyé.</translation>
    </message>
    <message>
        <source>Sending…</source>
        <translation>Envoi…</translation>
    </message>
    <message>
        <source>up to the commit of %1</source>
        <translation>jusqu&apos;au commit du %1</translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>rien encore</translation>
    </message>
</context>
<context>
    <name>cradle::SolutionView</name>
    <message>
        <source>Reference solution</source>
        <translation>Corrigé</translation>
    </message>
    <message>
        <source>Close the reference solution (Esc)</source>
        <translation>Fermer le corrigé (Échap)</translation>
    </message>
    <message>
        <source>Close the reference solution</source>
        <translation>Fermer le corrigé</translation>
    </message>
</context>
<context>
    <name>cradle::Sounds</name>
    <message>
        <source>There is no sound here: no sound server (PulseAudio or PipeWire) could be reached. Everything else goes on.</source>
        <translation>Il n&apos;y a pas de son ici&#xa0;: aucun serveur de son (PulseAudio ou PipeWire) n&apos;a pu être joint. Tout le reste continue.</translation>
    </message>
</context>
<context>
    <name>cradle::SpeedHistogram</name>
    <message>
        <source>Speeds</source>
        <translation>Vitesses</translation>
    </message>
    <message>
        <source>A distribution of speeds takes %1 circles or more: Lab → Example scenes → Gas has 1000</source>
        <translation>Une distribution des vitesses demande au moins %1 cercles&#xa0;: TP → Scènes d&apos;exemple → Gaz en a 1000</translation>
    </message>
    <message>
        <source>Nothing moves yet: press Run</source>
        <translation>Rien ne bouge encore&#xa0;: appuyez sur «&#xa0;Lancer&#xa0;»</translation>
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
        <translation>part par %1 m/s, moyenne sur 1 s</translation>
    </message>
    <message>
        <source>Maxwell–Boltzmann</source>
        <translation>Maxwell–Boltzmann</translation>
    </message>
    <message>
        <source>In equilibrium: distance from the curve %1, chance allows %2.</source>
        <translation>À l&apos;équilibre&#xa0;: distance à la courbe %1, le hasard admet %2.</translation>
    </message>
    <message>
        <source>Not in equilibrium: distance from the curve %1, chance allows %2.</source>
        <translation>Pas à l&apos;équilibre&#xa0;: distance à la courbe %1, le hasard admet %2.</translation>
    </message>
    <message>
        <source>Histogram of the speeds, m/s</source>
        <translation>Histogramme des vitesses, m/s</translation>
    </message>
    <message>
        <source>Distance from equilibrium</source>
        <translation>Distance à l&apos;équilibre</translation>
    </message>
    <message>
        <source>The distance of Kolmogorov and Smirnov, at the moment shown: the greatest difference between the share of circles slower than a speed and what the curve says. Of a hundred gases in equilibrium one is further away by chance.</source>
        <translation>La distance de Kolmogorov et Smirnov, à l&apos;instant affiché&#xa0;: la plus grande différence entre la part des cercles plus lents qu&apos;une vitesse et ce que dit la courbe. De cent gaz à l&apos;équilibre, un seul en est plus loin par hasard.</translation>
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
        <translation>%1&#xa0;% plus rapides</translation>
    </message>
    <message>
        <source>%1 to %2 m/s: %3 %, the curve %4 %</source>
        <translation>%1 à %2 m/s&#xa0;: %3&#xa0;%, la courbe %4&#xa0;%</translation>
    </message>
</context>
<context>
    <name>cradle::StepDesk</name>
    <message>
        <source># %1

This scene belongs to no step: play with it. Choose a step above to go back to the lab.</source>
        <translation># %1

Cette scène n&apos;appartient à aucune étape&#xa0;: jouez avec. Choisissez une étape ci-dessus pour revenir au TP.</translation>
    </message>
    <message>
        <source>A scene of your own</source>
        <translation>Votre propre scène</translation>
    </message>
    <message>
        <source>Explore</source>
        <translation>Explorer</translation>
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
        <translation>réussie</translation>
    </message>
    <message>
        <source>current</source>
        <translation>actuelle</translation>
    </message>
    <message>
        <source>open</source>
        <translation>à faire</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
</context>
<context>
    <name>cradle::StepFields</name>
    <message>
        <source>Rename the step&apos;s folder</source>
        <translation>Renommer le dossier de l&apos;étape</translation>
    </message>
    <message>
        <source>Edit the step</source>
        <translation>Modifier l&apos;étape</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Id of the step, and its folder</source>
        <translation>Id de l&apos;étape, et son dossier</translation>
    </message>
    <message>
        <source>Letters, digits, dots and dashes; also the name of the folder</source>
        <translation>Lettres, chiffres, points et traits d&apos;union&#xa0;; c&apos;est aussi le nom du dossier</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Title of the step</source>
        <translation>Titre de l&apos;étape</translation>
    </message>
    <message>
        <source>In the language that is open; also in the list of steps (F2)</source>
        <translation>Dans la langue ouverte&#xa0;; aussi dans la liste des étapes (F2)</translation>
    </message>
    <message>
        <source>Commit message</source>
        <translation>Message de commit</translation>
    </message>
    <message>
        <source>What a student writes into the history after passing</source>
        <translation>Ce qu&apos;un étudiant écrit dans l&apos;historique après avoir réussi</translation>
    </message>
    <message>
        <source>Extra step</source>
        <translation>Étape facultative</translation>
    </message>
    <message>
        <source>Outside the lab&apos;s own count</source>
        <translation>Hors du décompte du TP</translation>
    </message>
    <message>
        <source>Moved by program or laws</source>
        <translation>Mû par programme ou lois</translation>
    </message>
    <message>
        <source>Moved by a program</source>
        <translation>Mû par un programme</translation>
    </message>
    <message>
        <source>Moved by the laws</source>
        <translation>Mû par les lois</translation>
    </message>
    <message>
        <source>Who may move the circles</source>
        <translation>Qui peut déplacer les cercles</translation>
    </message>
    <message>
        <source>What passes the step: a program of the student, the laws of the scene, or either</source>
        <translation>Ce qui réussit l&apos;étape&#xa0;: un programme de l&apos;étudiant, les lois de la scène, ou l&apos;un ou l&apos;autre</translation>
    </message>
</context>
<context>
    <name>cradle::StepsList</name>
    <message>
        <source>extra</source>
        <translation>facultative</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>réussie</translation>
    </message>
    <message>
        <source>current</source>
        <translation>actuelle</translation>
    </message>
    <message>
        <source>open</source>
        <translation>à faire</translation>
    </message>
    <message>
        <source>Steps · %1 of %2</source>
        <translation>Étapes · %1 sur %2</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>Steps passed</source>
        <translation>Étapes réussies</translation>
    </message>
    <message>
        <source>Close ▴</source>
        <translation>Fermer ▴</translation>
    </message>
    <message>
        <source>All steps ▾</source>
        <translation>Toutes ▾</translation>
    </message>
    <message>
        <source>Close the list of steps</source>
        <translation>Fermer la liste des étapes</translation>
    </message>
    <message>
        <source>All steps, %1</source>
        <translation>Toutes les étapes, %1</translation>
    </message>
    <message>
        <source>Search the steps</source>
        <translation>Rechercher parmi les étapes</translation>
    </message>
    <message>
        <source>1 file of this lab could not be read</source>
        <translation>1 fichier de ce TP n&apos;a pas pu être lu</translation>
    </message>
    <message>
        <source>%1 files of this lab could not be read</source>
        <translation>%1 fichiers de ce TP n&apos;ont pas pu être lus</translation>
    </message>
</context>
<context>
    <name>cradle::StepsPanel</name>
    <message>
        <source>Steps · %1</source>
        <translation>Étapes · %1</translation>
    </message>
    <message>
        <source>Steps of the lab</source>
        <translation>Étapes du TP</translation>
    </message>
    <message>
        <source>Title, version and id of the lab</source>
        <translation>Titre, version et id du TP</translation>
    </message>
    <message>
        <source>Add a step</source>
        <translation>Ajouter une étape</translation>
    </message>
    <message>
        <source>Duplicate the step</source>
        <translation>Dupliquer l&apos;étape</translation>
    </message>
    <message>
        <source>Remove the step</source>
        <translation>Supprimer l&apos;étape</translation>
    </message>
    <message>
        <source>Move the step up</source>
        <translation>Monter l&apos;étape</translation>
    </message>
    <message>
        <source>Move the step down</source>
        <translation>Descendre l&apos;étape</translation>
    </message>
    <message>
        <source>New step</source>
        <translation>Nouvelle étape</translation>
    </message>
    <message>
        <source>Files that the step did not use stay: %1</source>
        <translation>Des fichiers que l&apos;étape n&apos;utilisait pas restent&#xa0;: %1</translation>
    </message>
    <message>
        <source>Rename the step</source>
        <translation>Renommer l&apos;étape</translation>
    </message>
    <message>
        <source>Move the step</source>
        <translation>Déplacer l&apos;étape</translation>
    </message>
</context>
<context>
    <name>cradle::TextTab</name>
    <message>
        <source>No text in this language yet: students read it in the lab&apos;s own.</source>
        <translation>Pas encore de texte dans cette langue&#xa0;: les étudiants le lisent dans celle du TP.</translation>
    </message>
    <message>
        <source>No hint yet: add one with the plus above.</source>
        <translation>Pas encore d&apos;indice&#xa0;: ajoutez-en un avec le plus ci-dessus.</translation>
    </message>
    <message>
        <source>Line %1: nothing here is called “%2”</source>
        <translation>Ligne %1&#xa0;: rien ne s&apos;appelle ici «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>%1, and %2 more</source>
        <translation>%1, et %2 autres</translation>
    </message>
    <message>
        <source>Instructions</source>
        <translation>Instructions</translation>
    </message>
    <message>
        <source>Hints without a program</source>
        <translation>Indices sans programme</translation>
    </message>
    <message>
        <source>Hints for a program</source>
        <translation>Indices pour un programme</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>Prédiction</translation>
    </message>
    <message>
        <source>Questions that count</source>
        <translation>Questions qui comptent</translation>
    </message>
    <message>
        <source>As seen in Code mode</source>
        <translation>Vu en mode Code</translation>
    </message>
    <message>
        <source>As seen in Explore mode</source>
        <translation>Vu en mode Explorer</translation>
    </message>
    <message>
        <source>Which text</source>
        <translation>Quel texte</translation>
    </message>
    <message>
        <source>Mode of the preview</source>
        <translation>Mode de l&apos;aperçu</translation>
    </message>
    <message>
        <source>Insert the scene as a figure</source>
        <translation>Insérer la scène comme figure</translation>
    </message>
    <message>
        <source>Draws the moment that the Scene tab shows, with its arrows, as an SVG in the step&apos;s folder</source>
        <translation>Dessine l&apos;instant que montre l&apos;onglet Scène, avec ses flèches, en SVG dans le dossier de l&apos;étape</translation>
    </message>
    <message>
        <source>Text in Markdown</source>
        <translation>Texte en Markdown</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Names in backticks that neither the scene nor the programs have</source>
        <translation>Noms entre accents graves que n&apos;ont ni la scène ni les programmes</translation>
    </message>
    <message>
        <source>Edit the text</source>
        <translation>Modifier le texte</translation>
    </message>
    <message>
        <source>Edit a hint</source>
        <translation>Modifier un indice</translation>
    </message>
    <message>
        <source>Change the hints</source>
        <translation>Changer les indices</translation>
    </message>
    <message>
        <source>Edit the prediction</source>
        <translation>Modifier la prédiction</translation>
    </message>
    <message>
        <source>Edit the questions</source>
        <translation>Modifier les questions</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
</context>
<context>
    <name>cradle::Timeline</name>
    <message>
        <source>Timeline</source>
        <translation>Ligne de temps</translation>
    </message>
    <message>
        <source>The step shown. Left and Right go a step, Page Up and Page Down to the previous and the next hit.</source>
        <translation>Le pas affiché. Gauche et Droite vont d&apos;un pas, Page préc. et Page suiv. au choc précédent et au suivant.</translation>
    </message>
    <message>
        <source>Drag to any moment</source>
        <translation>Glisser jusqu&apos;à n&apos;importe quel instant</translation>
    </message>
    <message>
        <source>program stopped in line %1</source>
        <translation>programme arrêté à la ligne %1</translation>
    </message>
    <message>
        <source>program stopped</source>
        <translation>programme arrêté</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>hit %1</source>
        <translation>choc %1</translation>
    </message>
    <message>
        <source>hits %1–%2</source>
        <translation>chocs %1–%2</translation>
    </message>
</context>
<context>
    <name>cradle::Tour</name>
    <message>
        <source>End the tour</source>
        <translation>Terminer la visite</translation>
    </message>
    <message>
        <source>Tour of the window</source>
        <translation>Visite de la fenêtre</translation>
    </message>
    <message>
        <source>%1 of %2 · %3</source>
        <translation>%1 sur %2 · %3</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Commencer</translation>
    </message>
    <message>
        <source>Next ▸</source>
        <translation>Suivant ▸</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
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
        <translation>Lancer</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Stop the check</source>
        <translation>Arrêter la vérification</translation>
    </message>
    <message>
        <source>Check this step</source>
        <translation>Vérifier cette étape</translation>
    </message>
    <message>
        <source>Stop</source>
        <comment>search</comment>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Next hit</source>
        <translation>Choc suivant</translation>
    </message>
    <message>
        <source>End the search and go back to where it began</source>
        <translation>Arrêter la recherche et revenir là où elle a commencé</translation>
    </message>
    <message>
        <source>Run on to the next collision</source>
        <translation>Continuer jusqu&apos;au prochain choc</translation>
    </message>
    <message>
        <source>t = %1 s</source>
        <translation>t = %1 s</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>pas %1</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Recommencer</translation>
    </message>
    <message>
        <source>Back to the start of the run</source>
        <translation>Revenir au début de l&apos;exécution</translation>
    </message>
    <message>
        <source>Step back</source>
        <translation>Pas en arrière</translation>
    </message>
    <message>
        <source>Step</source>
        <comment>back</comment>
        <translation>Pas</translation>
    </message>
    <message>
        <source>One step back</source>
        <translation>Un pas en arrière</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>One step on</source>
        <translation>Un pas en avant</translation>
    </message>
    <message>
        <source>Run or pause</source>
        <translation>Lancer ou mettre en pause</translation>
    </message>
    <message>
        <source>Previous hit</source>
        <translation>Choc précédent</translation>
    </message>
    <message>
        <source>Back to the collision before, or to the start</source>
        <translation>Revenir au choc précédent, ou au début</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Ralentir</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Accélérer</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Allure</translation>
    </message>
    <message>
        <source>Speed now</source>
        <translation>Allure actuelle</translation>
    </message>
    <message>
        <source>How fast it goes now: slower around a hit, if that is chosen</source>
        <translation>À quelle allure cela va maintenant&#xa0;: plus lentement autour d&apos;un choc, si c&apos;est choisi</translation>
    </message>
    <message>
        <source>Simulated time per real time ([ slower, ] faster)</source>
        <translation>Temps simulé par temps réel ([ ralentir, ] accélérer)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Steps since the start</source>
        <translation>Pas depuis le début</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Progression de la vérification</translation>
    </message>
    <message>
        <source>Progress of the search for a hit</source>
        <translation>Progression de la recherche d&apos;un choc</translation>
    </message>
</context>
<context>
    <name>cradle::UndoActions</name>
    <message>
        <source>typing</source>
        <translation>la frappe</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
</context>
<context>
    <name>cradle::ValuesEditor</name>
    <message>
        <source>Values · %1</source>
        <translation>Valeurs · %1</translation>
    </message>
    <message>
        <source>%1: from %2 to %3, drawn</source>
        <translation>%1&#xa0;: de %2 à %3, tirée</translation>
    </message>
    <message>
        <source>%1 (whole lab)</source>
        <translation>%1 (tout le TP)</translation>
    </message>
    <message>
        <source>Write {{%1}} in texts, programs and checks; in scenes and other values %1 alone.</source>
        <translation>Écrivez {{%1}} dans les textes, programmes et vérifications&#xa0;; dans les scènes et d&apos;autres valeurs, %1 seul.</translation>
    </message>
    <message numerus="yes">
        <source>Each student gets one of %n number(s): %1. You, and who gives no number, have the first.</source>
        <translation>
            <numerusform>Chaque étudiant reçoit %n nombre&#xa0;: %1. Vous, et qui ne donne pas de numéro, avez le premier.</numerusform>
            <numerusform>Chaque étudiant reçoit l&apos;un de %n nombres&#xa0;: %1. Vous, et qui ne donne pas de numéro, avez le premier.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing uses it yet.</source>
        <translation>Rien ne l&apos;utilise encore.</translation>
    </message>
    <message>
        <source>Used in %1.</source>
        <translation>Utilisée dans %1.</translation>
    </message>
    <message>
        <source>Student %1 has %2 = %3</source>
        <translation>L&apos;étudiant %1 a %2 = %3</translation>
    </message>
    <message>
        <source>Edit a value</source>
        <translation>Modifier une valeur</translation>
    </message>
    <message>
        <source>A name of letters, digits and underscores that means nothing else, as sin does, is right</source>
        <translation>Il faut un nom de lettres, chiffres et tirets bas qui ne signifie rien d&apos;autre, comme le fait sin</translation>
    </message>
    <message>
        <source>Another value has this name already</source>
        <translation>Une autre valeur porte déjà ce nom</translation>
    </message>
    <message>
        <source>There is a value %1 already</source>
        <translation>Il y a déjà une valeur %1</translation>
    </message>
    <message>
        <source>Edit the draw</source>
        <translation>Modifier le tirage</translation>
    </message>
    <message>
        <source>Add a value</source>
        <translation>Ajouter une valeur</translation>
    </message>
    <message>
        <source>Remove a value</source>
        <translation>Supprimer une valeur</translation>
    </message>
    <message>
        <source>Values of the lab and of the step</source>
        <translation>Valeurs du TP et de l&apos;étape</translation>
    </message>
    <message>
        <source>Remove the value</source>
        <translation>Supprimer la valeur</translation>
    </message>
    <message>
        <source>No number has a name yet. Add one with the plus, and write it in braces, as {{e}}, where texts, programs and checks need it: then it stands in one place, and may be another for each student.</source>
        <translation>Aucun nombre n&apos;a encore de nom. Ajoutez-en un avec le plus, et écrivez-le entre accolades, comme {{e}}, là où textes, programmes et vérifications en ont besoin&#xa0;: il se trouve alors à un seul endroit, et peut être différent pour chaque étudiant.</translation>
    </message>
    <message>
        <source>The same for all</source>
        <translation>La même pour tous</translation>
    </message>
    <message>
        <source>Drawn for each student</source>
        <translation>Tirée pour chaque étudiant</translation>
    </message>
    <message>
        <source>In the whole lab</source>
        <translation>Dans tout le TP</translation>
    </message>
    <message>
        <source>In this step</source>
        <translation>Dans cette étape</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Whether the value is drawn</source>
        <translation>Si la valeur est tirée</translation>
    </message>
    <message>
        <source>Known</source>
        <translation>Connue</translation>
    </message>
    <message>
        <source>Where the value is known</source>
        <translation>Où la valeur est connue</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Letters, digits and underscores</source>
        <translation>Lettres, chiffres et tirets bas</translation>
    </message>
    <message>
        <source>A number, or an expression like 2*k or sqrt(2*9.81*5), in the unit that its uses want</source>
        <translation>Un nombre, ou une expression comme 2*k ou sqrt(2*9.81*5), dans l&apos;unité que demandent ses usages</translation>
    </message>
    <message>
        <source>From one number to the next</source>
        <translation>D&apos;un nombre au suivant</translation>
    </message>
    <message>
        <source>Student number</source>
        <translation>Numéro d&apos;étudiant</translation>
    </message>
    <message>
        <source>Student number to try the draw with</source>
        <translation>Numéro d&apos;étudiant pour essayer le tirage</translation>
    </message>
    <message>
        <source>To see what that student gets; it is kept nowhere</source>
        <translation>Pour voir ce que reçoit cet étudiant&#xa0;; il n&apos;est conservé nulle part</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Tirage</translation>
    </message>
    <message>
        <source>Draw of the lab</source>
        <translation>Tirage du TP</translation>
    </message>
    <message>
        <source>Another text draws other values: change it every year</source>
        <translation>Un autre texte tire d&apos;autres valeurs&#xa0;: changez-le chaque année</translation>
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
        <translation>Position à droite du milieu</translation>
    </message>
    <message>
        <source>Position above the middle</source>
        <translation>Position au-dessus du milieu</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Velocity to the right</source>
        <translation>Vitesse vers la droite</translation>
    </message>
    <message>
        <source>Velocity upwards</source>
        <translation>Vitesse vers le haut</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse (norme)</translation>
    </message>
    <message>
        <source>kg m/s</source>
        <translation>kg m/s</translation>
    </message>
    <message>
        <source>Momentum to the right</source>
        <translation>Quantité de mouvement vers la droite</translation>
    </message>
    <message>
        <source>Momentum upwards</source>
        <translation>Quantité de mouvement vers le haut</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>cinétique</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>Kinetic energy</source>
        <translation>Énergie cinétique</translation>
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
        <source>Distance from the exact motion</source>
        <translation>Distance au mouvement exact</translation>
    </message>
    <message>
        <source>Total energy more than in the exact motion</source>
        <translation>Énergie totale de plus que dans le mouvement exact</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>number unit</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>quantity, unit</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>All circles together</source>
        <translation>Tous les cercles ensemble</translation>
    </message>
</context>
<context>
    <name>cradle::ValuesPane</name>
    <message>
        <source>%1 •</source>
        <comment>a tab with news</comment>
        <translation>%1 •</translation>
    </message>
    <message>
        <source>Hits %1</source>
        <translation>Chocs %1</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>Chocs</translation>
    </message>
    <message>
        <source>number</source>
        <translation>numéro</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Values and hits</source>
        <translation>Valeurs et chocs</translation>
    </message>
    <message>
        <source>Hits; Enter shows the moment</source>
        <translation>Chocs&#xa0;; Entrée montre l&apos;instant</translation>
    </message>
    <message>
        <source>No hits yet: press Run or Next hit</source>
        <translation>Pas encore de chocs&#xa0;: appuyez sur «&#xa0;Lancer&#xa0;» ou sur «&#xa0;Choc suivant&#xa0;»</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Tout copier</translation>
    </message>
</context>
<context>
    <name>cradle::ValuesTab</name>
    <message>
        <source>No hit so far.</source>
        <translation>Pas de choc jusqu&apos;ici.</translation>
    </message>
    <message>
        <source>Values of the circles at the moment shown</source>
        <translation>Valeurs des cercles à l&apos;instant affiché</translation>
    </message>
    <message>
        <source>Last hit</source>
        <translation>Dernier choc</translation>
    </message>
    <message>
        <source>Distance from the exact motion</source>
        <translation>Distance au mouvement exact</translation>
    </message>
</context>
<context>
    <name>cradle::VerdictDesk</name>
    <message>
        <source>Not yet: %1</source>
        <translation>Pas encore&#xa0;: %1</translation>
    </message>
    <message>
        <source>Check passed.</source>
        <translation>Vérification réussie.</translation>
    </message>
</context>
<context>
    <name>cradle::VersionsList</name>
    <message>
        <source>Written</source>
        <translation>Écrite</translation>
    </message>
    <message>
        <source>Before it was replaced</source>
        <translation>Avant son remplacement</translation>
    </message>
    <message>
        <source>By another program</source>
        <translation>Par un autre programme</translation>
    </message>
    <message>
        <source>From another window</source>
        <translation>D&apos;une autre fenêtre</translation>
    </message>
    <message>
        <source>✓ passed</source>
        <translation>✓ réussie</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>non réussie</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>without: %1</source>
        <translation>sans&#xa0;: %1</translation>
    </message>
    <message>
        <source>the same program</source>
        <translation>le même programme</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Quand</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>First difference</source>
        <translation>Première différence</translation>
    </message>
    <message>
        <source>Versions of this step&apos;s program</source>
        <translation>Versions du programme de cette étape</translation>
    </message>
</context>
<context>
    <name>cradle::VersionsPane</name>
    <message>
        <source>Versions</source>
        <translation>Versions</translation>
    </message>
    <message>
        <source>Every Check keeps a version of your program here, and so do ten minutes of writing.</source>
        <translation>Chaque vérification garde ici une version de votre programme, de même que dix minutes d&apos;écriture.</translation>
    </message>
    <message>
        <source>The version</source>
        <translation>La version</translation>
    </message>
    <message>
        <source>Your program now</source>
        <translation>Votre programme maintenant</translation>
    </message>
    <message>
        <source>&amp;Go back to this</source>
        <translation>&amp;Revenir à celle-ci</translation>
    </message>
    <message>
        <source>Your program now becomes a version, so nothing is lost</source>
        <translation>Votre programme actuel devient une version, rien n&apos;est donc perdu</translation>
    </message>
    <message>
        <source>Back to what &amp;passed</source>
        <translation>Revenir à ce qui a ré&amp;ussi</translation>
    </message>
    <message>
        <source>To the newest version that passed this step</source>
        <translation>À la version la plus récente qui a réussi cette étape</translation>
    </message>
</context>
<context>
    <name>cradle::WaysBack</name>
    <message>
        <source>Back to the scene that passed</source>
        <translation>Revenir à la scène qui a réussi</translation>
    </message>
</context>
<context>
    <name>cradle::WorkDialogs</name>
    <message>
        <source>Nothing of this work is kept on a disk.</source>
        <translation>Rien de ce travail n&apos;est conservé sur un disque.</translation>
    </message>
    <message>
        <source>Open a step of a lab first.</source>
        <translation>Ouvrez d&apos;abord une étape d&apos;un TP.</translation>
    </message>
</context>
<context>
    <name>cradle::WorkJob</name>
    <message>
        <source>What you typed last could not be saved; on the disk your work is older. Save it first: the window says what is in the way.</source>
        <translation>Ce que vous avez tapé en dernier n&apos;a pas pu être enregistré&#xa0;; sur le disque, votre travail est plus ancien. Enregistrez-le d&apos;abord&#xa0;: la fenêtre dit ce qui l&apos;empêche.</translation>
    </message>
</context>
<context>
    <name>cradle::WorkNotices</name>
    <message>
        <source>Another program has changed your program. Its text is shown now; yours is among the versions of this step.</source>
        <translation>Un autre programme a modifié votre programme. Son texte est affiché maintenant&#xa0;; le vôtre est parmi les versions de cette étape.</translation>
    </message>
    <message>
        <source>Another program has changed your program while you typed. Yours stays; the other is among the versions of this step.</source>
        <translation>Un autre programme a modifié votre programme pendant que vous tapiez. Le vôtre reste&#xa0;; l&apos;autre est parmi les versions de cette étape.</translation>
    </message>
    <message>
        <source>Another program has made %1 a file that is no program. It is kept as %2; what can be read of it is among the versions of this step.</source>
        <translation>Un autre programme a fait de %1 un fichier qui n&apos;est pas un programme. Il est gardé sous %2&#xa0;; ce qu&apos;on peut en lire est parmi les versions de cette étape.</translation>
    </message>
    <message>
        <source>Your number</source>
        <translation>Votre numéro</translation>
    </message>
    <message>
        <source>This lab draws its values for each student by the number that you hand in with.
Your number:</source>
        <translation>Ce TP tire ses valeurs pour chaque étudiant selon le numéro avec lequel vous rendez.
Votre numéro&#xa0;:</translation>
    </message>
    <message>
        <source>The values of this lab are those of nobody until you give your number: open the lab again for that.</source>
        <translation>Les valeurs de ce TP ne sont celles de personne tant que vous ne donnez pas votre numéro&#xa0;: pour cela, rouvrez le TP.</translation>
    </message>
    <message>
        <source>Work that %1 handed in. Run it, check it, read its versions and notes: nothing of it is changed, and nothing of what it says about itself is believed.</source>
        <translation>Travail rendu par %1. Lancez-le, vérifiez-le, lisez ses versions et ses remarques&#xa0;: rien n&apos;y est modifié, et rien de ce qu&apos;il dit de lui-même n&apos;est cru.</translation>
    </message>
    <message>
        <source>somebody</source>
        <translation>quelqu&apos;un</translation>
    </message>
    <message>
        <source>They write: “%1”</source>
        <translation>Le message joint&#xa0;: «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Make a program of it</source>
        <translation>En faire un programme</translation>
    </message>
    <message>
        <source>Back to the newest version</source>
        <translation>Revenir à la version la plus récente</translation>
    </message>
    <message>
        <source>Begin this step anew</source>
        <translation>Recommencer cette étape</translation>
    </message>
    <message>
        <source>The file of your program is no program, and is left as it is. %1 Whatever you choose, the file is kept beside it.</source>
        <translation>Le fichier de votre programme n&apos;est pas un programme, et est laissé tel quel. %1 Quoi que vous choisissiez, ce fichier est gardé à côté.</translation>
    </message>
    <message>
        <source>This step goes on from the one before, which you have not done. You begin with your own program.</source>
        <translation>Cette étape prolonge la précédente, que vous n&apos;avez pas faite. Vous commencez avec votre propre programme.</translation>
    </message>
    <message>
        <source>Begin with the solution of “%1”</source>
        <translation>Commencer avec le corrigé de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Read the step on the left, write your program in the middle, press Run to watch, and Check when you are done.</source>
        <translation>Lisez l&apos;étape à gauche, écrivez votre programme au milieu, appuyez sur «&#xa0;Lancer&#xa0;» pour observer, et sur «&#xa0;Vérifier&#xa0;» quand vous avez fini.</translation>
    </message>
    <message>
        <source>Read the step on the left, set the values beside the scene, press Run to watch, and Check when you are done.</source>
        <translation>Lisez l&apos;étape à gauche, réglez les valeurs à côté de la scène, appuyez sur «&#xa0;Lancer&#xa0;» pour observer, et sur «&#xa0;Vérifier&#xa0;» quand vous avez fini.</translation>
    </message>
    <message>
        <source>Show me around</source>
        <translation>Faire la visite</translation>
    </message>
    <message>
        <source>Got it</source>
        <translation>Compris</translation>
    </message>
    <message>
        <source>Another window works on this lab (process %1 on %2, since %3). In this one you can look, but nothing is saved.</source>
        <translation>Une autre fenêtre travaille sur ce TP (processus %1 sur %2, depuis %3). Dans celle-ci vous pouvez regarder, mais rien n&apos;est enregistré.</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>Prendre la main</translation>
    </message>
    <message>
        <source>What you pass is kept in your history, signed “Student”. It can be signed with your name.</source>
        <translation>Ce que vous réussissez est conservé dans votre historique, signé «&#xa0;Student&#xa0;». Il peut être signé de votre nom.</translation>
    </message>
    <message>
        <source>Give your name…</source>
        <translation>Donner votre nom…</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Votre nom</translation>
    </message>
    <message>
        <source>Your name:</source>
        <translation>Votre nom&#xa0;:</translation>
    </message>
    <message>
        <source>Your program is not saved</source>
        <translation>Votre programme n&apos;est pas enregistré</translation>
    </message>
    <message>
        <source>What you typed since it was last saved is lost if you close the window.</source>
        <translation>Ce que vous avez tapé depuis le dernier enregistrement est perdu si vous fermez la fenêtre.</translation>
    </message>
</context>
<context>
    <name>cradle::Workbench</name>
    <message>
        <source>this is work in the lab %1, which is not here; open that lab once, and then the work</source>
        <translation>c&apos;est un travail du TP %1, qui n&apos;est pas ici&#xa0;; ouvrez ce TP une fois, puis le travail</translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation>Ouvrir une scène</translation>
    </message>
</context>
<context>
    <name>cradle::WorldGroup</name>
    <message>
        <source>World</source>
        <translation>Monde</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Pesanteur</translation>
    </message>
    <message>
        <source>Restitution e</source>
        <translation>Restitution e</translation>
    </message>
    <message>
        <source>Timestep</source>
        <translation>Pas de temps</translation>
    </message>
    <message>
        <source>Half width</source>
        <translation>Demi-largeur</translation>
    </message>
    <message>
        <source>Acceleration of every circle, to the right and upward</source>
        <translation>Accélération de chaque cercle, vers la droite et vers le haut</translation>
    </message>
    <message>
        <source>From 0, no rebound, to 1, elastic</source>
        <translation>De 0, aucun rebond, à 1, élastique</translation>
    </message>
    <message>
        <source>Up doubles it, Down halves it; 1/240 can be typed</source>
        <translation>Haut le double, Bas le divise par deux&#xa0;; on peut taper 1/240</translation>
    </message>
    <message>
        <source>From the middle of the square to a wall</source>
        <translation>Du milieu du carré à une paroi</translation>
    </message>
    <message>
        <source>Gravity to the right, m/s²</source>
        <translation>Pesanteur vers la droite, m/s²</translation>
    </message>
    <message>
        <source>Gravity upward, m/s²</source>
        <translation>Pesanteur vers le haut, m/s²</translation>
    </message>
    <message>
        <source>Timestep, s</source>
        <translation>Pas de temps, s</translation>
    </message>
    <message>
        <source>Half width of the square, m</source>
        <translation>Demi-largeur du carré, m</translation>
    </message>
    <message>
        <source>= %1 s</source>
        <translation>= %1 s</translation>
    </message>
    <message>
        <source>Change gravity</source>
        <translation>Changer la pesanteur</translation>
    </message>
    <message>
        <source>Change restitution</source>
        <translation>Changer la restitution</translation>
    </message>
    <message>
        <source>Change timestep</source>
        <translation>Changer le pas de temps</translation>
    </message>
    <message>
        <source>Change half width</source>
        <translation>Changer la demi-largeur</translation>
    </message>
</context>
</TS>
