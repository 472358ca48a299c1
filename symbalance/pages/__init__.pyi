from symbalance.pages.moving_page import Page as Page
from symbalance.pages.moving_page import page as page
from symbalance.pages.sheets import Sheet as Sheet
from symbalance.pages.sheets import sheet as sheet
