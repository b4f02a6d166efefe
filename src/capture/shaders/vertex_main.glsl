void main()
{
    mirrorballCapture_hostMain();
    mirrorballCapture_place(MIRRORBALL_POSITION);
}
