"""Italian terms of engines, shafts and vibrations."""

OF = r"(?:della\s+|dello\s+|dell'|del\s+|dei\s+|delle\s+|degli\s+|d'|di\s+)"
TERMS = r"""
mean piston speed: velocità media §(?:pistone|stantuffo)
largest piston speed: velocità massima §(?:pistone|stantuffo)
piston velocity: velocità (?:istantanea )?§(?:pistone|stantuffo)
largest piston acceleration: accelerazione massima §(?:pistone|stantuffo)
piston acceleration: accelerazione (?:istantanea )?§(?:pistone|stantuffo)
piston displacement: (?:spostamento|discesa|cammino|abbassamento) §(?:pistone|stantuffo)
piston displacement: (?:corsa|cammino) percors[ao] dal(?:lo)? (?:pistone|stantuffo)
piston position: posizione §(?:pistone|stantuffo)
piston area: (?:area|superficie|sezione) §(?:pistone|stantuffo)
swept volume: cilindrata(?: unitaria)?
compression ratio: rapporto (?:volumetrico )?§compressione|rapporto volumetrico
clearance volume: volume morto|volume nocivo|volume §camera di combustione
gas force: forza (?:dovuta alla pressione )?§gas|forza dovuta ai gas
side thrust: (?:spinta|forza|reazione) laterale|spinta normale
connecting rod force: (?:forza|sforzo) (?:nella |sulla |lungo la |§)biella
tangential force: forza tangenziale|sforzo tangenziale
radial force: forza radiale|sforzo radiale
piston force: forza (?:sul |§)(?:pistone|stantuffo)
mean torque: coppia (?:motrice )?media|momento (?:motore )?medio
inertia torque: coppia (?:d'inerzia|§forze d'inerzia)
engine torque: coppia motrice|momento motore|coppia §motore
equivalent twisting moment: momento torcente (?:equivalente|ideale)|momento torcente ideale
equivalent bending moment: momento flettente (?:equivalente|ideale)
bending moment: momento flettente
torque: coppia (?:istantanea|torcente)|coppia(?! di (?!torsione|serraggio))|momento torcente
couple: coppi[ae](?= (?:del |di )?(?:primo|secondo))
pair: coppi[ae] di (?:cilindri|pistoni|dischi|ruote|masse|alberi)
inertia couple: (?:coppi[ae]|momenti?) d'inerzia(?= (?:del |di )?(?:primo|secondo|1|2))
inertia force: (?:forz[ae]|sforz[oi]) (?:d'|di )inerzia
primary force: forz[ae] primari[ae]
secondary force: forz[ae] secondari[ae]
first order: (?:primo|1°|1º) ordine|ordine (?:1|uno)
second order: (?:secondo|2°|2º) ordine|ordine (?:2|due)
fourth order: (?:quarto|4°|4º) ordine|ordine (?:4|quattro)
centrifugal force: forz[ae] centrifug[ae]|forze centrifughe
reciprocating mass: mass[ae] (?:alternativ[ae]|alterne?|alterna|oscillant[ei]|in moto alterno)
rotating mass: mass[ae] (?:rotant[ei]|rotativ[ae]|in rotazione)
rod mass: massa §biella
piston mass: massa §(?:pistone|stantuffo)
to the big end: (?:dalla|alla|fino alla) testa(?: di biella| della biella)?
to the small end: (?:dal|al|fino al) piede(?: di biella| della biella)?
big end: testa di biella|testa della biella
small end: piede di biella|piede della biella
gudgeon pin: spinotto|perno del pistone
crank pin: perno di (?:manovella|biella)|bottone di manovella
degree of irregularity: (?:grado|coefficiente) (?:d'|di )(?:irregolarità(?: periodica)?|fluttuazione)
degree of irregularity: irregolarità periodica
fluctuation of energy: fluttuazione (?:di|dell') ?energia|variazione (?:massima )?(?:di|dell') ?energia
fluctuation of energy: eccesso di lavoro
kinetic energy: energia cinetica
flywheel: volano
polar moment of inertia: momento (?:d'|di )inerzia polare|momento polare d'inerzia
moment of inertia: moment[oi] (?:d'|di )inerzia
inertia: inerzia
polar second moment of area: momento quadratico polare
second moment of area: momento quadratico(?: assiale)?
polar section modulus: modulo di resistenza (?:polare|a torsione)
section modulus in bending: modulo di resistenza a flessione
section modulus: modulo di resistenza
shear modulus: modulo di (?:elasticità tangenziale|taglio|scorrimento)|modulo di elasticità a taglio
shear stress: tensione (?:tangenziale|di taglio)(?: massima)?
bending stress: (?:tensione|sollecitazione) (?:normale )?(?:di|da|a) flessione
torsional stress: (?:tensione|sollecitazione) (?:tangenziale )?(?:di|da|a) torsione
equivalent stress: (?:tensione|sollecitazione) (?:equivalente|ideale)
torsional stiffness: rigidezza (?:torsionale|a torsione)|rigidità (?:torsionale|a torsione)
angle of twist: angolo di torsione
damped natural angular frequency: pulsazione (?:propria |naturale )?smorzata
natural angular frequency: pulsazion[ei] (?:propri[ae]|natural[ei])
natural frequency: frequenz[ae] (?:propri[ae]|natural[ei])
amplitude ratio: rapporto (?:tra le|delle|fra le) ampiezze
position of the node: (?:posizione|distanza) §nodo
node: nodo
critical speed: velocità critic(?:a|he)|regime critico
magnification factor: (?:fattore|coefficiente) di amplificazione
damping ratio: (?:fattore|rapporto) di smorzamento|smorzamento relativo
damping ratio: coefficiente di smorzamento relativo
logarithmic decrement: decremento logaritmico
critical damping: smorzamento critico
damping: smorzamento
undamped: non smorzat\w*|senza smorzamento
damped: smorzat\w*
period: periodo
firing interval: intervallo (?:angolare )?di accensione
firing interval: intervallo (?:tra|fra) (?:due )?(?:accensioni|scoppi)(?: successiv\w*| consecutiv\w*)?
firing frequency: frequenza (?:di accensione|degli scoppi)
power strokes per revolution: fasi (?:utili|attive|motrici) (?:per|a|ad ogni) giro
power strokes per revolution: (?:scoppi|accensioni|combustioni) (?:per|a|ad ogni) giro
counterweight: contrappes[oi]
balance shaft: albero (?:di equilibratura|equilibratore|controrotante)
balance shafts: alberi (?:di equilibratura|equilibratori|controrotanti)
crank radius: raggio §(?:manovella|albero a gomiti)
connecting rod length: lunghezza §biella
crank angle: angolo §(?:prima )?manovella
rod angle: (?:angolo|obliquità|inclinazione) §biella
angular velocity of the rod: velocità angolare §biella
angular acceleration of the rod: accelerazione angolare §biella
angular velocity: velocità angolare
angular acceleration: accelerazione angolare
rotational speed: velocità di rotazione|numero di giri|regime(?: di rotazione)?
circumferential speed: velocità periferica
mean effective pressure: pressione media effettiva
indicated mean effective pressure: pressione media indicata
mechanical efficiency: rendimento meccanico
efficiency: rendimento
brake power: potenza effettiva
indicated power: potenza indicata
power: potenza
four-stroke: (?:a )?(?:quattro|4) tempi
two-stroke: (?:a )?(?:due|2) tempi
stroke: corsa
bore: alesaggio
top dead centre: punto morto superiore|PMS|p\.\s?m\.\s?s\.?
bottom dead centre: punto morto inferiore|PMI|p\.\s?m\.\s?i\.?
dead centre: punto morto
radius of gyration: raggio (?:d'inerzia|giratore|di girazione)
friction mean effective pressure: pressione media (?:effettiva )?(?:di |d'|degli )attrit[oi]
angle: angol[oi]
radius: raggio
diameter: diametro
density: densità
mass: massa
length: lunghezza
thickness: spessore
force: forza
forces: forze
pressure: pressione
area: area|superficie
stiffness: rigidezza|rigidità
speed: velocità
acceleration: accelerazione
frequency: frequenza
energy: energia
work of one cycle: lavoro (?:per|di un|§) ?ciclo
work: lavoro
two discs: due (?:dischi|volani|inerzie)
thin ring: anello sottile|corona sottile
solid disc: disco pieno
disc: disco
rim: corona
shaft: albero
hollow: cav[oa]|tubolare|forat\w*
fixed: incastrat\w*
offset: disassat\w*|disassamento|eccentric\w*
piston: pistone|stantuffo
crankshaft: albero a (?:gomiti|manovelle)
crank: manovella
connecting rod: biella
engine: motore
cylinder: cilindro
cylinders: cilindri
single-cylinder: monocilindric\w*|monocilindro
four cylinders: (?:quattro|4) cilindri
six cylinders: (?:sei|6) cilindri
three cylinders: (?:tre|3) cilindri
two cylinders: (?:due|2) cilindri
both: entramb[ie]|ambedue|i due|le due
each: ogni|ciascun[oa]?
half: metà|mezz[oa]
per: per(?= (?:cilindro|giro|unità|metro|secondo))
total: totale|complessiv[oa]
sum: somma
resultant: risultante
relative: relativ[oa]
difference: differenza
component: componente
ratio: rapporto
parallel: parallelo
series: serie
largest: massim[oa]|maggiore
smallest: minim[oa]|minore
mean: medi[oa]
approximately: circa|approssimativamente
wrong: errat\w*|sbagliat\w*
is not: non è
from the: a partire d\w*|dal|dalla
about its diameter: rispetto a un diametro|attorno a un diametro
is: è|vale|risulta
are: sono|valgono
at the: al
the: il|lo|la|gli|le|l'|i(?= \w{3,}i\b)
a: una|uno|un
of: della|dello|dell'|del|dei|delle|degli|di|d'
and: ed
with: con
where: dove
in: nel|nella|nell'
between: tra|fra
for: per
by: da
on: su|sul|sulla
two: due
three: tre
four: quattro
six: sei
residual force along the line of stroke: forza residua (?:lungo|secondo) l'asse(?: del cilindro)?
residual force perpendicular to it: forza residua (?:perpendicolare|trasversale)(?: all'asse)?
centre of gravity: baricentro|centro di (?:gravità|massa)
proportional: proporzional\w*
unit: unità|unitari[oa]
specific: specific[oa]
divided: divis[oa]
squared: al quadrato|quadrato
square section: sezione quadrata
rectangular: rettangolare
annular: anulare
solid: pien[oa]
amplitude: ampiezza
harmonic: armonic[oa]
coefficient: coefficiente
distance: distanza
height: altezza
width: larghezza
gear: ingranaggio|ruota dentata
pendulum: pendolo
spring: molla
springs: molle
friction: attrito
belt: cinghia
notch: intaglio
thin-walled: parete sottile
rotating: rotant[ei]|rotativ[oaei]
uneven: irregolar[ei]
dead centres: punti morti
at the: alla|all'
if: se
when: quando
another: un altro|un'altra
case: caso
whereas: mentre
static deflection: (?:freccia|inflessione|deflessione) statica
deflection: freccia|inflessione
critical speed of bending: velocità critica (?:flessionale|di flessione|a flessione)
in the middle: a metà(?= d)|in mezzeria|al centro|nel mezzo
simply supported: (?:semplicemente )?appoggiat\w*
bearings: cuscinetti|supporti
bearing: cuscinetto|supporto
mass per length: massa per unità di lunghezza|massa lineica
angular frequency: pulsazion[ei](?! (?:propri|natural|smorzat))
diametrically opposite: diametralmente oppost\w*
vibrates freely: oscilla liberamente|vibra liberamente
three discs: tre (?:dischi|volani|masse|inerzie)
two-node mode: modo (?:a|con) due nodi
absorber: assorbitore(?: dinamico)?|smorzatore dinamico
mass ratio: rapporto (?:di|delle|fra le|tra le) masse
transmissibility: trasmissibilità
frequency ratio: rapporto (?:di|delle|fra le|tra le) (?:frequenze|pulsazioni)
simple harmonic motion: moto armonico(?: semplice)?
bifilar suspension: (?:sospensione|pendolo) bifilare
trifilar suspension: (?:sospensione|pendolo) trifilare
small oscillations: piccole oscillazioni
lag: ritardo(?: di fase)?
with their signs: col (?:loro|proprio) segno|con segno
"""
