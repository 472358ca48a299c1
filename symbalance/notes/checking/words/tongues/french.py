"""French terms of engines, shafts and vibrations."""

OF = r"(?:d'|de\s+l'|de\s+la\s+|du\s+|des\s+|de\s+)"
TERMS = r"""
mean piston speed: vitesse (?:linéaire )?moyenne §pistons?
largest piston speed: vitesse max(?:imale|imum|\.)? §piston
piston velocity: vitesse (?:instantanée )?§pistons?
largest piston acceleration: accélération max(?:imale|imum|\.)? §piston
piston acceleration: accélération (?:instantanée )?§pistons?
piston displacement: (?:déplacement|descente|chemin(?: parcouru)?|abaissement) §pistons?
piston displacement: (?:course|chemin) parcourue? par (?:le|chaque) piston
piston position: position §piston
piston area: (?:surface|section|aire) §piston
swept volume: cylindrée(?: unitaire)?
compression ratio: rapport volumétrique(?: §compression)?|rapport §compression|taux §compression
clearance volume: volume mort|volume §chambre de combustion
gas force: (?:force|effort) (?:due? à la pression )?§gaz|effort dû aux gaz|force due aux gaz
side thrust: (?:poussée|force|réaction|pression) latérale|effort latéral
connecting rod force: (?:effort|force) (?:dans la |sur la |§)bielle
tangential force: force tangentielle|effort tangentiel
radial force: force radiale|effort radial
piston force: (?:force|effort) (?:sur le |§)piston
mean torque: couple moyen
inertia torque: couple §(?:forces d')?inertie
inertia couple: (?:couple|moment)s? d'inertie(?= (?:du |de )?(?:premier|second|deuxième|1er|2e))
engine torque: couple moteur|couple §(?:moteur|vilebrequin)
equivalent twisting moment: moment de torsion (?:équivalent|idéal)|moment idéal de torsion
equivalent bending moment: moment (?:de flexion|fléchissant) (?:équivalent|idéal)
equivalent bending moment: moment idéal de flexion
bending moment: moment (?:de flexion|fléchissant)
torque: couple (?:instantané|de torsion)|couple(?! de (?!torsion|serrage|rappel))|moment de torsion
couple: couples?(?= (?:du |de )?(?:premier|second|deuxième))
torques: couples
inertia force: (?:force|effort)s? §inertie
primary force: (?:force|effort)s? primaires?
secondary force: (?:force|effort)s? secondaires?
first order: (?:premier|1er) ordre|ordre (?:1|un)
second order: (?:second|deuxième|2e|2ème) ordre|ordre (?:2|deux)
fourth order: (?:quatrième|4e|4ème) ordre|ordre (?:4|quatre)
centrifugal force: (?:force|effort)s? centrifuges?
reciprocating mass: masses? (?:alternatives?|oscillantes?|en mouvement alternatif)
rotating mass: masses? (?:tournantes?|rotatives?|en rotation)
rod mass: masse §bielle
piston mass: masse §piston
to the big end: (?:à|depuis|jusqu'à) la tête(?: de bielle)?
to the small end: (?:au|depuis le|jusqu'au) pied(?: de bielle)?
big end: tête de bielle
small end: pied de bielle
gudgeon pin: axe §piston
crank pin: maneton
degree of irregularity: (?:coefficient|degré) d'irrégularité|irrégularité cyclique
degree of irregularity: coefficient de fluctuation(?: de (?:la )?vitesse)?
fluctuation of energy: fluctuation d'énergie|variation (?:maximale )?d'énergie|excédent de travail
kinetic energy: énergie cinétique
flywheel: volant(?: (?:d'inertie|moteur))?
polar moment of inertia: moment d'inertie polaire
moment of inertia: moments? d'inertie
inertia: inertie
polar second moment of area: moment quadratique polaire|moment polaire
second moment of area: moment quadratique(?: axial)?
polar section modulus: module de résistance (?:polaire|(?:à la|en|de) torsion)
section modulus in bending: module de résistance (?:à la|en|de) flexion
section modulus: module de (?:résistance|flexion)
shear modulus: module de (?:cisaillement|glissement|Coulomb)
shear stress: contrainte (?:tangentielle|de cisaillement|de torsion)(?: maximale)?
bending stress: contraintes? (?:normale )?(?:de|en) flexion
torsional stress: contraintes? (?:de cisaillement )?(?:de|en) torsion
equivalent stress: contrainte équivalente
torsional stiffness: (?:raideur|rigidité) (?:torsionnelle|(?:de|en|à la) torsion)
angle of twist: angle de torsion
damped natural angular frequency: pseudo-?pulsation|pulsation (?:propre )?amortie
natural angular frequency: pulsations? propres?|pulsation naturelle
natural frequency: fréquences? propres?|fréquence naturelle
amplitude ratio: rapport §amplitudes
position of the node: (?:position|distance|abscisse) §n(?:œ|oe)ud
node: n(?:œ|oe)ud
critical speed: vitesses? critiques?|régime critique
magnification factor: (?:facteur|coefficient) d'amplification
damping ratio: (?:taux|facteur) d'amortissement|(?:coefficient d')?amortissement réduit
logarithmic decrement: décrément logarithmique
critical damping: amortissement critique
damping: amortissement
undamped: non amorti\w*|sans amortissement
damped: amorti(?:e|s|es)?
period: période
firing interval: intervalle (?:angulaire )?d'allumage
firing interval: intervalle entre (?:deux )?(?:allumages|explosions)(?: successi\w*)?
firing frequency: fréquence (?:d'allumage|§explosions)
power strokes per revolution: temps moteurs? par tour(?: (?:de|du) (?:vilebrequin|manivelle))?
power strokes per revolution: (?:explosions|allumages|combustions) (?:par|à chaque) (?:tour|révolution)
counterweight: contre-?poids
balance shaft: arbre (?:d'équilibrage|équilibreur)
balance shafts: arbres (?:d'équilibrage|équilibreurs)
crank radius: rayon §(?:manivelle|vilebrequin)
connecting rod length: longueur §bielle|entraxe §bielle
crank angle: angle §(?:première )?(?:manivelle|vilebrequin)
rod angle: (?:angle|obliquité|inclinaison) §bielle
angular velocity of the rod: vitesse angulaire §bielle
angular acceleration of the rod: accélération angulaire §bielle
angular velocity: vitesse angulaire
angular acceleration: accélération angulaire
rotational speed: vitesse de rotation|régime(?: (?:moteur|de rotation))?
circumferential speed: vitesse (?:périphérique|circonférentielle)
mean effective pressure: pression moyenne effective
indicated mean effective pressure: pression moyenne indiquée
mechanical efficiency: rendement mécanique
efficiency: rendement
brake power: puissance effective
indicated power: puissance indiquée
power: puissance
four-stroke: (?:à )?(?:quatre|4) temps
two-stroke: (?:à )?(?:deux|2) temps
stroke: course
bore: alésage
top dead centre: point mort haut|PMH|p\.\s?m\.\s?h\.?
bottom dead centre: point mort bas|PMB|p\.\s?m\.\s?b\.?
dead centre: point mort
radius of gyration: rayon (?:de giration|d'inertie)
friction mean effective pressure: pression moyenne (?:effective )?(?:de|des) (?:frottements?|pertes)
radius: rayon
diameter: diamètre
density: masse volumique
mass: masse
length: longueur
thickness: épaisseur
force: force|effort
forces: efforts
pressure: pression
area: surface|aire
stress: contrainte
stiffness: raideur|rigidité
speed: vitesse
acceleration: accélération
frequency: fréquence
energy: énergie
work of one cycle: travail (?:par|d'un|§) ?cycle
work: travail
two discs: deux (?:disques|volants|inerties)
thin ring: (?:anneau|couronne) mince
thin rim: jante mince
solid disc: disque plein
disc: disque
rim: jante|couronne
shaft: arbre
hollow: creu(?:x|se)|tubulaire|alésé
fixed: encastrée?s?
offset: désax\w*|excentré\w*|déport
piston: piston
crankshaft: vilebrequin
crank: manivelle
connecting rod: bielle
engine: moteur
cylinder: cylindre
cylinders: cylindres
single-cylinder: monocylindre
four cylinders: (?:quatre|4) cylindres
six cylinders: (?:six|6) cylindres
three cylinders: (?:trois|3) cylindres
two cylinders: (?:deux|2) cylindres
both: les deux
each: chaque|chacune?
half: moitié|demi
per: par(?= (?:cylindre|tour|unité|mètre|seconde))
total: totale?|totaux|globale?
sum: somme
resultant: résultante?
relative: relati(?:f|ve)
difference: différence
component: composante
ratio: rapport
parallel: parallèle
series: série
largest: max(?:imale|imum)|plus grande?
smallest: min(?:imale|imum)|plus petite?
mean: moyenne?
approximately: environ|approximativement|à peu près
wrong: erroné\w*|fausse
is not: n'est pas
from the: à partir §|depuis (?:le |la )?
about its diameter: par rapport à (?:un|son) diamètre|autour d'un diamètre
is: est|vaut|s'écrit|vaut donc
are: sont
at the: au
the: le|la|les|l'
a: une?
of: d'|de|du|des
and: et
with: avec
where: où
in: dans
between: entre
for: pour
by: par
on: sur
two: deux
three: trois
four: quatre
six: six
residual force along the line of stroke: force résiduelle (?:suivant|selon|dans) (?:l'axe|la direction)
residual force along the line of stroke: force résiduelle suivant l'axe du cylindre
residual force perpendicular to it: force résiduelle (?:perpendiculaire|transversale)
centre of gravity: centre (?:de gravité|de masse|d'inertie)
pair: paire
proportional: proportionnel\w*
unit: unités?|unitaires?
specific: spécifique
divided: divisée?s?
squared: au carré|carré
square section: section carrée
rectangular: rectangulaire
annular: annulaire
solid: pleine?|massi(?:f|ve)
amplitude: amplitude
harmonic: harmonique
coefficient: coefficient
distance: distance
height: hauteur
width: largeur
gear: engrenage|roue dentée
pendulum: pendule
spring: ressort
springs: ressorts
friction: frottement
belt: courroie
notch: entaille|congé
thin-walled: paroi mince
rotating: tournante?s?|rotati(?:f|ve)s?
uneven: irréguli(?:er|ère)s?
dead centres: points morts
at: à|aux
if: si
when: quand|lorsqu(?:e|')
another: une? autre
case: cas
whereas: tandis qu(?:e|')|alors que
static deflection: flèche statique|fléchissement statique
deflection: flèche
critical speed of bending: (?:vitesse|régime) critique de flexion|vitesse critique (?:en|de) flexion
in the middle: (?:au|en son) milieu|à mi-(?:portée|longueur)
simply supported: (?:simplement )?(?:appuyé\w*|sur deux appuis)
bearings: paliers|roulements
bearing: palier|roulement
mass per length: masse (?:linéique|par unité de longueur)
angular frequency: pulsations?(?! propres?| naturelle| amortie)
diametrically opposite: diamétralement opposé\w*
apart: distante?s? (?:de|l'une? de l'autre)
along the axis: (?:le long|suivant la direction) de l'axe
vibrates freely: oscille librement|vibre librement
three discs: trois (?:disques|volants|masses)
two-node mode: mode à deux nœuds
absorber: amortisseur dynamique|amortisseur accordé|absorbeur(?: dynamique)?
mass ratio: rapport des masses
transmissibility: transmissibilité|facteur de transmission
frequency ratio: rapport (?:des|de) (?:fréquences|pulsations)
simple harmonic motion: mouvement (?:vibratoire )?(?:harmonique|sinusoïdal)(?: simple)?
bifilar suspension: (?:suspension|pendule) bifilaire
trifilar suspension: (?:suspension|pendule) trifilaire
small oscillations: petites oscillations
lag: retard de phase|déphasage en retard
with their signs: avec leurs? signes?
"""
