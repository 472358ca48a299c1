from symbalance.page.page import Page as Page
