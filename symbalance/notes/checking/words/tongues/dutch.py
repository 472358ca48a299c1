"""Dutch terms of engines, shafts and vibrations."""

OF = r"(?:van\s+de\s+|van\s+het\s+|van\s+een\s+|van\s+)"
TERMS = r"""
mean piston speed: gemiddelde zuigersnelheid
largest piston speed: (?:maximale|grootste|hoogste) zuigersnelheid
piston velocity: zuigersnelheid|snelheid §zuiger
largest piston acceleration: (?:maximale|grootste) zuigerversnelling
piston acceleration: zuigerversnelling|versnelling §zuiger
piston displacement: zuigerverplaatsing|verplaatsing §zuiger|zuigerweg
piston area: zuigeroppervlak(?:te)?|oppervlak(?:te)? §zuiger
swept volume: slagvolume|cilinderinhoud
compression ratio: compressieverhouding
clearance volume: compressievolume|schadelijke ruimte
gas force: gaskracht|kracht §gas(?:sen)?
side thrust: leibaan(?:kracht|druk)|zijdelingse kracht|zijkracht|normaalkracht op de cilinderwand
connecting rod force: drijfstangkracht|kracht in de drijfstang
tangential force: tangenti[aë]+le kracht|tangentiaalkracht|omtrekskracht
radial force: radiale kracht|radiaalkracht
piston force: zuigerkracht|kracht op de zuiger
mean torque: gemiddelde? koppel
inertia torque: massakoppel|traagheidskoppel|koppel §massakrachten
engine torque: motorkoppel|koppel §(?:motor|krukas)
equivalent bending moment: (?:ideëel|equivalent) buigend moment
equivalent twisting moment: (?:ideëel|equivalent) wringend moment
bending moment: buigend moment|buigmoment
torque: koppel|draaimoment|wringend moment|torsiemoment
inertia force: massakracht(?:en)?|traagheidskracht(?:en)?
inertia couple: massamoment(?:en)?(?! van traagheid)
first order: (?:eerste|1e) orde|orde (?:1|een)
second order: (?:tweede|2e) orde|orde (?:2|twee)
fourth order: (?:vierde|4e) orde|orde (?:4|vier)
centrifugal force: centrifugale? krachte?n?|middelpuntvliedende krachte?n?|centrifugaalkracht(?:en)?
reciprocating mass: (?:heen-? en weer ?gaande|oscillerende) massa(?:'s)?
rotating mass: (?:roterende|draaiende) massa(?:'s)?
rod mass: drijfstangmassa|massa §drijfstang
piston mass: zuigermassa|massa §zuiger
degree of irregularity: ongelijkmatigheids?graad|graad van ongelijkmatigheid
fluctuation of energy: arbeidsoverschot|energieschommeling|energiefluctuatie
kinetic energy: kinetische energie|bewegingsenergie
flywheel: vliegwiel
polar second moment of area: polair (?:oppervlakte)?traagheidsmoment|polaire oppervlaktetraagheidsmoment
second moment of area: oppervlaktetraagheidsmoment|kwadratisch oppervlaktemoment
moment of inertia: massatraagheidsmoment|traagheidsmoment(?:en)?|massatraagheid
polar section modulus: (?:polair )?weerstandsmoment tegen (?:wringing|torsie)|polair weerstandsmoment
section modulus in bending: weerstandsmoment tegen buiging
section modulus: weerstandsmoment
shear modulus: glijdingsmodulus|schuifmodulus|afschuivingsmodulus
bending stress: buigspanning
torsional stress: (?:wring|torsie)spanning
equivalent stress: vergelijkspanning|(?:ideële|equivalente) spanning
torsional stiffness: torsiestijfheid|wringstijfheid|torsieveerconstante
angle of twist: torsiehoek|verdraaiingshoek|wringingshoek
natural angular frequency: eigenhoek(?:frequentie|snelheid)|eigencirkelfrequentie
natural frequency: eigenfrequenties?
amplitude ratio: amplitudeverhouding|verhouding §amplitudes
position of the node: (?:plaats|ligging|afstand) §knooppunt
node: knooppunt|knoop
critical speed: kritische toerental(?:len)?|kritieke? toerental(?:len)?|kritisch toerental
magnification factor: (?:opslinger|versterkings|vergrotings)factor
damping ratio: dempingsgraad|dempingsverhouding|relatieve demping
logarithmic decrement: logaritmisch decrement
critical damping: kritische demping
damping: demping
undamped: ongedempte?
damped: gedempte?
period: trillingstijd|periode
firing interval: ontstekings(?:interval|afstand)
firing frequency: ontstekingsfrequentie
counterweight: contragewicht(?:en)?|tegengewicht(?:en)?
balance shaft: balansas
balance shafts: balansassen
crank radius: krukstraal|krukradius|straal §kruk
connecting rod length: drijfstanglengte|lengte §drijfstang
crank angle: krukhoek|krukashoek
rod angle: drijfstanghoek|hoek §drijfstang
angular velocity of the rod: hoeksnelheid §drijfstang
angular acceleration of the rod: hoekversnelling §drijfstang
angular velocity: hoeksnelheid
angular acceleration: hoekversnelling
rotational speed: toerental|draaisnelheid
circumferential speed: omtreksnelheid
mean effective pressure: gemiddelde effectieve druk
mechanical efficiency: mechanisch rendement
efficiency: rendement
brake power: effectief vermogen
indicated power: geïndiceerd vermogen
power: vermogen
four-stroke: vier-?takt|4-?takt
two-stroke: twee-?takt|2-?takt
stroke: slaglengte|zuigerslag|slag
bore: boring
top dead centre: bovenste dode punt|BDP
bottom dead centre: onderste dode punt|ODP
dead centre: dode punt
radius of gyration: traagheidsstraal
radius: straal
diameter: diameter|middellijn
density: dichtheid
mass: massa
length: lengte
thickness: dikte
force: kracht
forces: krachten
pressure: druk
area: oppervlakte?
couple: koppel(?= van de (?:eerste|tweede))
stiffness: stijfheid
speed: snelheid
acceleration: versnelling
frequency: frequentie
energy: energie
work of one cycle: arbeid (?:per|van een|per) (?:cyclus|kringproces)
work: arbeid
two discs: twee (?:schijven|vliegwielen|massa's)
thin ring: dunne ring
solid disc: massieve schijf
disc: schijf
rim: velg|krans
shaft: as
hollow: holle?|buis\w*
fixed: ingeklemde?
offset: desax\w*|excentrisch\w*
piston: zuiger
crankshaft: krukas
crank: kruk
connecting rod: drijfstang
engine: motor
cylinder: cilinder
cylinders: cilinders
single-cylinder: ééncilinder\w*|eencilinder\w*
four cylinders: (?:vier|4) cilinders
six cylinders: (?:zes|6) cilinders
three cylinders: (?:drie|3) cilinders
two cylinders: (?:twee|2) cilinders
both: beide
each: elke?|iedere?
half: helft|halve?
total: totale?|gezamenlijke?
sum: som
resultant: resulterende?|resultante
relative: relatieve?
difference: verschil
component: component(?:en)?
ratio: verhouding
parallel: parallel|evenwijdig
series: serie
largest: grootste|maximale?|hoogste
smallest: kleinste|minimale?
mean: gemiddelde?
approximately: bij benadering|ongeveer
wrong: foute?|verkeerde?
not: niet
from the: vanaf (?:de|het)|vanuit (?:de|het)
is: bedraagt|wordt
are: zijn
the: de|het
a: een
of: van
and: en
with: met
where: waarin|waarbij
between: tussen
for: voor
by: door
on: op
at: bij
two: twee
three: drie
four: vier
six: zes
centre of gravity: zwaartepunt|massamiddelpunt
pair: paar
proportional: evenredig\w*
unit: eenheid
specific: specifieke?
divided: gedeeld
squared: kwadraat|in het kwadraat
square section: vierkante doorsnede
rectangular: rechthoekige?
annular: ringvormige?
solid: massieve?
amplitude: amplitude
harmonic: harmonische?
coefficient: coëfficiënt
distance: afstand
height: hoogte
width: breedte
gear: tandwiel\w*
pendulum: slinger
spring: veer
springs: veren
friction: wrijving\w*
belt: riem
notch: kerf
thin-walled: dunwandig\w*
rotating: roterende?|draaiende?
uneven: ongelijkmatig\w*
dead centres: dode punten
if: als|indien
when: wanneer
another: een andere?
case: geval
whereas: terwijl
static deflection: statische (?:doorbuiging|doorzakking|indrukking)
deflection: doorbuiging
in the middle: in het midden|halverwege
bearings: lagers
mass per length: massa per (?:lengte-?eenheid|eenheid van lengte)
angular frequency: hoekfrequentie|cirkelfrequentie
three discs: drie (?:schijven|massa's|vliegwielen)
two-node mode: trillingsvorm met twee knopen
absorber: (?:dynamische )?trillingsdemper|absorber
mass ratio: massaverhouding
transmissibility: overdrachtsverhouding|transmissibiliteit
frequency ratio: frequentieverhouding
simple harmonic motion: harmonische (?:beweging|trilling)
"""
