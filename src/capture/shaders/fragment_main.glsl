void main()
{
    mirrorballCapture_begin();
    mirrorballCapture_readVaryings();
    mirrorballCapture_hostMain();
    mirrorballCapture_end();
}
