from symbalance.drawing.crank_star import draw_star as draw_star
from symbalance.drawing.firing_diagram import draw_firing as draw_firing
from symbalance.drawing.oblique import draw_oblique as draw_oblique
from symbalance.drawing.plan import draw_plan as draw_plan
from symbalance.drawing.section import draw_section as draw_section
