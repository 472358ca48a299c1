from symbalance.pages.moving_page import Page as Page
from symbalance.pages.moving_page import page as page
