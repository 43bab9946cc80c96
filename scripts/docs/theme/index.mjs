// Without the web font, so that the site contains nothing but its own code.
import DefaultTheme from 'vitepress/theme-without-fonts';
import './style.css';

export default DefaultTheme;
