"use strict";(()=>{function Nm(i,e,t){for(let[n,s]of Object.entries(e))typeof s=="function"?i.addEventListener(n,s):s!=null&&s!==!1&&i.setAttribute(n,s===!0?"":String(s));return i.append(...t.filter(n=>n!=null&&n!==!1)),i}var _=(i,e={},...t)=>Nm(document.createElement(i),e,t),ie=(i,e={},...t)=>Nm(document.createElementNS("http://www.w3.org/2000/svg",i),e,t);function Ve(i,e){i.textContent!==e&&(i.textContent=e)}var Dm=new WeakMap;function Mn(i,e){let[t,n]=[Dm.get(i),JSON.stringify(e)];return Dm.set(i,n),t!==n}var rr=i=>_("ul",{class:"w-sentences"},...i.map(e=>_("li",{},String(e)))),Jn=(i,e,t="")=>_("table",{},t&&_("caption",{},t),_("thead",{},_("tr",{},...i.map(n=>_("th",{scope:"col"},n)))),_("tbody",{},...e)),Ml=(i,e)=>_("tr",{},_("th",{scope:"row"},i),...e.map(t=>_("td",{},t))),or=(i,e=null)=>_("ul",{"aria-label":e},...i.map(({colour:t,label:n})=>_("li",{},_("i",{"aria-hidden":"true",style:`background:var(--${t})`}),n))),Yt=(i,e,t,n="start",s={})=>ie("text",{x:i,y:e,"text-anchor":n,fill:"var(--ink)","font-size":11.5,...s},t),nb="\u2212",Fe=(i,e)=>{let n=(Math.abs(i*2**(e+1)%2)===1?2*Math.round(i*10**e/2)/10**e:i).toFixed(e);return/^-0(\.0*)?$/.test(n)?n.slice(1):n.replace("-",nb)};function Sl(i){let e=new Map;for(let t of i)e.set(t,(e.get(t)??0)+1);return[...e].map(([t,n])=>`${n}\xA0\xD7\xA0${t}`).join(", ")}var $n=i=>i.charAt(0).toUpperCase()+i.slice(1),Ts=i=>i==="transfer"?"free motion":i,_e=(i,e=0)=>`${Fe(100*i,e)}\u202F%`,Gt=({mean:i,low:e,high:t},n=0,s=_e(i,n))=>`${s} (90\u202F%: ${_e(e,n)} to ${_e(t,n)})`,nn="\u2013",sn=(i,e)=>typeof i=="number"?e(i):nn;function Je(i,e=1){let t=Fe(i,e),n=Number(t);if(!(n>=60))return`${t} s`;let[s,r]=[Math.floor(n/3600),Math.floor(n/60)%60],o=(n%60).toFixed(e).padStart(e?e+3:2,"0");return s?`${s}:${String(r).padStart(2,"0")}:${o}`:`${r}:${o}`}var ib=0,hi=()=>`w${++ib}`;var Ro=class{data=[];least=1/0;largest=-1/0;push(e){this.data.push(e),e<this.least&&(this.least=e),e>this.largest&&(this.largest=e)}range(e,t){let[n,s]=[1/0,-1/0];for(let r=Math.max(0,e),o=Math.min(t,this.data.length);r<o;r++){let a=this.data[r];a<n&&(n=a),a>s&&(s=a)}return n<=s?[n,s]:null}};function Co(i,e){let[t,n]=[0,i];for(;t<n;){let s=t+n>>1;e(s)?t=s+1:n=s}return t-1}var ui=(i,e)=>Co(i.length,t=>i[t]<=e);function Es(i){let e=new WeakMap;return t=>(e.has(t)||e.set(t,i(t)),e.get(t))}var di=i=>typeof i=="number"?i:NaN;/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var rs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},os={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Eg=0,nf=1,Ag=2;var zs=1,Rg=2,Xr=3,as=0,xn=1,yn=2,Vs=0,qr=1,sf=2,rf=3,of=4,Cg=5;var Gs=100,Pg=101,Ig=102,Lg=103,Dg=104,Ng=200,kg=201,Og=202,Ug=203,af=204,lf=205,Fg=206,Bg=207,zg=208,Vg=209,Gg=210,Hg=211,Wg=212,$g=213,Xg=214,ac=0,lc=1,cc=2,Pr=3,hc=4,uc=5,dc=6,fc=7,Da=0,qg=1,Yg=2,xi=0,cf=1,hf=2,uf=3,df=4,ff=5,pf=6,mf=7;var gf=300,Hs=301,Yr=302,Wc=303,$c=304,Is=1e3,mi=1001,pc=1002,Wt=1003,Zg=1004;var Na=1005;var mn=1006,Xc=1007;var Ui=1008;var En=1009,xf=1010,yf=1011,Zr=1012,qc=1013,si=1014,Zn=1015,ri=1016,Yc=1017,Zc=1018,Ws=1020,vf=35902,bf=35899,_f=1021,wf=1022,oi=1023,Di=1026,Fi=1027,jc=1028,Kc=1029,ls=1030,Jc=1031;var Qc=1033,ka=33776,Oa=33777,Ua=33778,Fa=33779,eh=35840,th=35841,nh=35842,ih=35843,sh=36196,rh=37492,oh=37496,ah=37488,lh=37489,Ba=37490,ch=37491,hh=37808,uh=37809,dh=37810,fh=37811,ph=37812,mh=37813,gh=37814,xh=37815,yh=37816,vh=37817,bh=37818,_h=37819,wh=37820,Mh=37821,Sh=36492,Th=36494,Eh=36495,Ah=36283,Rh=36284,za=36285,Ch=36286;var $o=2300,mc=2301,rc=2302,$d=2303,Xd=2400,qd=2401,Yd=2402;var jg=3200;var jr=0,Kg=1,Bi="",Zt="srgb",Xo="srgb-linear",qo="linear",ht="srgb";var oc=7680,Mf=7681;var Sf=517;var Jg=519,Qg=512,e0=513,t0=514,Tf=515,n0=516,i0=517,Ef=518,Af=519,Rf=35044;var Cf="300 es",qn=2e3,Ir=2001;function sb(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function rb(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Yo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function s0(){let i=Yo("canvas");return i.style.display="block",i}var km={},Lr=null;function Zo(...i){let e="THREE."+i.shift();Lr?Lr("log",e,...i):console.log(e,...i)}function r0(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ne(...i){i=r0(i);let e="THREE."+i.shift();if(Lr)Lr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function ze(...i){i=r0(i);let e="THREE."+i.shift();if(Lr)Lr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Vo(...i){let e=i.join(" ");e in km||(km[e]=!0,Ne(...i))}function o0(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var a0={[ac]:ac,[cc]:dc,[hc]:hc,[Pr]:uc,[lc]:lc,[dc]:cc,[fc]:fc,[uc]:Pr},ni=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},rn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Om=1234567,Ar=Math.PI/180,Dr=180/Math.PI;function zi(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(rn[i&255]+rn[i>>8&255]+rn[i>>16&255]+rn[i>>24&255]+"-"+rn[e&255]+rn[e>>8&255]+"-"+rn[e>>16&15|64]+rn[e>>24&255]+"-"+rn[t&63|128]+rn[t>>8&255]+"-"+rn[t>>16&255]+rn[t>>24&255]+rn[n&255]+rn[n>>8&255]+rn[n>>16&255]+rn[n>>24&255]).toLowerCase()}function Ge(i,e,t){return Math.max(e,Math.min(t,i))}function Pf(i,e){return(i%e+e)%e}function ob(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function ab(i,e,t){return i!==e?(t-i)/(e-i):0}function Go(i,e,t){return(1-t)*i+t*e}function lb(i,e,t,n){return Go(i,e,1-Math.exp(-t*n))}function cb(i,e=1){return e-Math.abs(Pf(i,e*2)-e)}function hb(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function ub(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function db(i,e){return i+Math.floor(Math.random()*(e-i+1))}function fb(i,e){return i+Math.random()*(e-i)}function pb(i){return i*(.5-Math.random())}function mb(i){i!==void 0&&(Om=i);let e=Om+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function gb(i){return i*Ar}function xb(i){return i*Dr}function yb(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function vb(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function If(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function bb(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),p=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*f,a*h,a*c);break;default:Ne("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Ph(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Lf(i,e){if(e.constructor===Float32Array)return i;let t=Ph(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Df(i,e){if(e.constructor===Float32Array)return i;let t=Ph(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Kr={DEG2RAD:Ar,RAD2DEG:Dr,generateUUID:zi,clamp:Ge,euclideanModulo:Pf,mapLinear:ob,inverseLerp:ab,lerp:Go,damp:lb,pingpong:cb,smoothstep:hb,smootherstep:ub,randInt:db,randFloat:fb,randFloatSpread:pb,seededRandom:mb,degToRad:gb,radToDeg:xb,isPowerOfTwo:yb,ceilPowerOfTwo:vb,floorPowerOfTwo:If,setQuaternionFromProperEuler:bb,normalize:Df,denormalize:Lf},ee=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ge(this.x,e.x,t.x),this.y=Ge(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ge(this.x,e,t),this.y=Ge(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ge(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Ge(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Rt=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(u!==x||l!==d||c!==f||h!==p){let m=l*d+c*f+h*p+u*x;m<0&&(d=-d,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let y=Math.acos(m),S=Math.sin(y);g=Math.sin(g*y)/S,a=Math.sin(a*y)/S,l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+x*a}else{l=l*g+d*a,c=c*g+f*a,h=h*g+p*a,u=u*g+x*a;let y=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=y,c*=y,h*=y,u*=y}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+h*u+l*f-c*d,e[t+1]=l*p+h*d+c*u-a*f,e[t+2]=c*p+h*f+a*d-l*u,e[t+3]=h*p-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:Ne("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ge(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},E=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Um.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Um.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ge(this.x,e.x,t.x),this.y=Ge(this.y,e.y,t.y),this.z=Ge(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ge(this.x,e,t),this.y=Ge(this.y,e,t),this.z=Ge(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ge(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return yd.copy(this).projectOnVector(e),this.sub(yd)}reflect(e){return this.sub(yd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Ge(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},yd=new E,Um=new Rt,He=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],x=s[0],m=s[3],g=s[6],y=s[1],S=s[4],b=s[7],A=s[2],R=s[5],v=s[8];return r[0]=o*x+a*y+l*A,r[3]=o*m+a*S+l*R,r[6]=o*g+a*b+l*v,r[1]=c*x+h*y+u*A,r[4]=c*m+h*S+u*R,r[7]=c*g+h*b+u*v,r[2]=d*x+f*y+p*A,r[5]=d*m+f*S+p*R,r[8]=d*g+f*b+p*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=t*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return e[0]=u*x,e[1]=(s*c-h*n)*x,e[2]=(a*n-s*o)*x,e[3]=d*x,e[4]=(h*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=f*x,e[7]=(n*l-c*t)*x,e[8]=(o*t-n*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Vo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(vd.makeScale(e,t)),this}rotate(e){return Vo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(vd.makeRotation(-e)),this}translate(e,t){return Vo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(vd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},vd=new He,Fm=new He().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Bm=new He().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function _b(){let i={enabled:!0,workingColorSpace:Xo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===ht&&(s.r=Li(s.r),s.g=Li(s.g),s.b=Li(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===ht&&(s.r=Rr(s.r),s.g=Rr(s.g),s.b=Rr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Bi?qo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Xo]:{primaries:e,whitePoint:n,transfer:qo,toXYZ:Fm,fromXYZ:Bm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Zt},outputColorSpaceConfig:{drawingBufferColorSpace:Zt}},[Zt]:{primaries:e,whitePoint:n,transfer:ht,toXYZ:Fm,fromXYZ:Bm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Zt}}}),i}var it=_b();function Li(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Rr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var ar,gc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{ar===void 0&&(ar=Yo("canvas")),ar.width=e.width,ar.height=e.height;let s=ar.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=ar}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Yo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Li(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Li(t[n]/255)*255):t[n]=Li(t[n]);return{data:t,width:e.width,height:e.height}}else return Ne("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},wb=0,Nr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:wb++}),this.uuid=zi(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(bd(s[o].image)):r.push(bd(s[o]))}else r=bd(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function bd(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?gc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ne("Texture: Unable to serialize Texture."),{})}var Mb=0,_d=new E,gn=class i extends ni{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=mi,s=mi,r=mn,o=Ui,a=oi,l=En,c=i.DEFAULT_ANISOTROPY,h=Bi){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Mb++}),this.uuid=zi(),this.name="",this.source=new Nr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ee(0,0),this.repeat=new ee(1,1),this.center=new ee(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new He,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(_d).x}get height(){return this.source.getSize(_d).y}get depth(){return this.source.getSize(_d).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ne(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ne(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==gf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Is:e.x=e.x-Math.floor(e.x);break;case mi:e.x=e.x<0?0:1;break;case pc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Is:e.y=e.y-Math.floor(e.y);break;case mi:e.y=e.y<0?0:1;break;case pc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};gn.DEFAULT_IMAGE=null;gn.DEFAULT_MAPPING=gf;gn.DEFAULT_ANISOTROPY=1;var ut=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let S=(c+1)/2,b=(f+1)/2,A=(g+1)/2,R=(h+d)/4,v=(u+x)/4,T=(p+m)/4;return S>b&&S>A?S<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(S),s=R/n,r=v/n):b>A?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=R/s,r=T/s):A<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),n=v/r,s=T/r),this.set(n,s,r,t),this}let y=Math.sqrt((m-p)*(m-p)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(y)<.001&&(y=1),this.x=(m-p)/y,this.y=(u-x)/y,this.z=(d-h)/y,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ge(this.x,e.x,t.x),this.y=Ge(this.y,e.y,t.y),this.z=Ge(this.z,e.z,t.z),this.w=Ge(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ge(this.x,e,t),this.y=Ge(this.y,e,t),this.z=Ge(this.z,e,t),this.w=Ge(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ge(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},xc=class extends ni{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:mn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new ut(0,0,e,t),this.scissorTest=!1,this.viewport=new ut(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new gn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:mn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Nr(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Nn=class extends xc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},jo=class extends gn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Wt,this.minFilter=Wt,this.wrapR=mi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var yc=class extends gn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Wt,this.minFilter=Wt,this.wrapR=mi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Ie=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,p,x,m)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,p,x,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/lr.setFromMatrixColumn(e,0).length(),r=1/lr.setFromMatrixColumn(e,1).length(),o=1/lr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,p=a*h,x=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+p*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,p=c*h,x=c*u;t[0]=d+x*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-p,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,p=c*h,x=c*u;t[0]=d-x*a,t[4]=-o*u,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*h,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,p=a*h,x=a*u;t[0]=l*h,t[4]=p*c-f,t[8]=d*c+x,t[1]=l*u,t[5]=x*c+d,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*h,t[4]=x-d*u,t[8]=p*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+p,t[10]=d-x*u}else if(e.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+x,t[5]=o*h,t[9]=f*u-p,t[2]=p*u-f,t[6]=a*h,t[10]=x*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Sb,e,Tb)}lookAt(e,t,n){let s=this.elements;return In.subVectors(e,t),In.lengthSq()===0&&(In.z=1),In.normalize(),qi.crossVectors(n,In),qi.lengthSq()===0&&(Math.abs(n.z)===1?In.x+=1e-4:In.z+=1e-4,In.normalize(),qi.crossVectors(n,In)),qi.normalize(),Tl.crossVectors(In,qi),s[0]=qi.x,s[4]=Tl.x,s[8]=In.x,s[1]=qi.y,s[5]=Tl.y,s[9]=In.y,s[2]=qi.z,s[6]=Tl.z,s[10]=In.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],x=n[6],m=n[10],g=n[14],y=n[3],S=n[7],b=n[11],A=n[15],R=s[0],v=s[4],T=s[8],D=s[12],P=s[1],k=s[5],O=s[9],V=s[13],I=s[2],G=s[6],$=s[10],H=s[14],ne=s[3],X=s[7],Q=s[11],te=s[15];return r[0]=o*R+a*P+l*I+c*ne,r[4]=o*v+a*k+l*G+c*X,r[8]=o*T+a*O+l*$+c*Q,r[12]=o*D+a*V+l*H+c*te,r[1]=h*R+u*P+d*I+f*ne,r[5]=h*v+u*k+d*G+f*X,r[9]=h*T+u*O+d*$+f*Q,r[13]=h*D+u*V+d*H+f*te,r[2]=p*R+x*P+m*I+g*ne,r[6]=p*v+x*k+m*G+g*X,r[10]=p*T+x*O+m*$+g*Q,r[14]=p*D+x*V+m*H+g*te,r[3]=y*R+S*P+b*I+A*ne,r[7]=y*v+S*k+b*G+A*X,r[11]=y*T+S*O+b*$+A*Q,r[15]=y*D+S*V+b*H+A*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],p=e[3],x=e[7],m=e[11],g=e[15],y=l*f-c*d,S=a*f-c*u,b=a*d-l*u,A=o*f-c*h,R=o*d-l*h,v=o*u-a*h;return t*(x*y-m*S+g*b)-n*(p*y-m*A+g*R)+s*(p*S-x*A+g*v)-r*(p*b-x*R+m*v)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],p=e[12],x=e[13],m=e[14],g=e[15],y=t*a-n*o,S=t*l-s*o,b=t*c-r*o,A=n*l-s*a,R=n*c-r*a,v=s*c-r*l,T=h*x-u*p,D=h*m-d*p,P=h*g-f*p,k=u*m-d*x,O=u*g-f*x,V=d*g-f*m,I=y*V-S*O+b*k+A*P-R*D+v*T;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/I;return e[0]=(a*V-l*O+c*k)*G,e[1]=(s*O-n*V-r*k)*G,e[2]=(x*v-m*R+g*A)*G,e[3]=(d*R-u*v-f*A)*G,e[4]=(l*P-o*V-c*D)*G,e[5]=(t*V-s*P+r*D)*G,e[6]=(m*b-p*v-g*S)*G,e[7]=(h*v-d*b+f*S)*G,e[8]=(o*O-a*P+c*T)*G,e[9]=(n*P-t*O-r*T)*G,e[10]=(p*R-x*b+g*y)*G,e[11]=(u*b-h*R-f*y)*G,e[12]=(a*D-o*k-l*T)*G,e[13]=(t*k-n*D+s*T)*G,e[14]=(x*S-p*A-m*y)*G,e[15]=(h*A-u*S+d*y)*G,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,x=o*h,m=o*u,g=a*u,y=l*c,S=l*h,b=l*u,A=n.x,R=n.y,v=n.z;return s[0]=(1-(x+g))*A,s[1]=(f+b)*A,s[2]=(p-S)*A,s[3]=0,s[4]=(f-b)*R,s[5]=(1-(d+g))*R,s[6]=(m+y)*R,s[7]=0,s[8]=(p+S)*v,s[9]=(m-y)*v,s[10]=(1-(d+x))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=lr.set(s[0],s[1],s[2]).length(),a=lr.set(s[4],s[5],s[6]).length(),l=lr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Qn.copy(this);let c=1/o,h=1/a,u=1/l;return Qn.elements[0]*=c,Qn.elements[1]*=c,Qn.elements[2]*=c,Qn.elements[4]*=h,Qn.elements[5]*=h,Qn.elements[6]*=h,Qn.elements[8]*=u,Qn.elements[9]*=u,Qn.elements[10]*=u,t.setFromRotationMatrix(Qn),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=qn,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===qn)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Ir)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=qn,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===qn)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===Ir)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},lr=new E,Qn=new Ie,Sb=new E(0,0,0),Tb=new E(1,1,1),qi=new E,Tl=new E,In=new E,zm=new Ie,Vm=new Rt,ii=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(Ge(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ge(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ge(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ge(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ge(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ge(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ne("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return zm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(zm,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Vm.setFromEuler(this),this.setFromQuaternion(Vm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ii.DEFAULT_ORDER="XYZ";var Ko=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Eb=0,Gm=new E,cr=new Rt,Ai=new Ie,El=new E,Po=new E,Ab=new E,Rb=new Rt,Hm=new E(1,0,0),Wm=new E(0,1,0),$m=new E(0,0,1),Xm={type:"added"},Cb={type:"removed"},hr={type:"childadded",child:null},wd={type:"childremoved",child:null},kt=class i extends ni{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Eb++}),this.uuid=zi(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new E,t=new ii,n=new Rt,s=new E(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ie},normalMatrix:{value:new He}}),this.matrix=new Ie,this.matrixWorld=new Ie,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ko,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return cr.setFromAxisAngle(e,t),this.quaternion.multiply(cr),this}rotateOnWorldAxis(e,t){return cr.setFromAxisAngle(e,t),this.quaternion.premultiply(cr),this}rotateX(e){return this.rotateOnAxis(Hm,e)}rotateY(e){return this.rotateOnAxis(Wm,e)}rotateZ(e){return this.rotateOnAxis($m,e)}translateOnAxis(e,t){return Gm.copy(e).applyQuaternion(this.quaternion),this.position.add(Gm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Hm,e)}translateY(e){return this.translateOnAxis(Wm,e)}translateZ(e){return this.translateOnAxis($m,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ai.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?El.copy(e):El.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Po.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ai.lookAt(Po,El,this.up):Ai.lookAt(El,Po,this.up),this.quaternion.setFromRotationMatrix(Ai),s&&(Ai.extractRotation(s.matrixWorld),cr.setFromRotationMatrix(Ai),this.quaternion.premultiply(cr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ze("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Xm),hr.child=e,this.dispatchEvent(hr),hr.child=null):ze("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Cb),wd.child=e,this.dispatchEvent(wd),wd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ai.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ai.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ai),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Xm),hr.child=e,this.dispatchEvent(hr),hr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Po,e,Ab),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Po,Rb,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};kt.DEFAULT_UP=new E(0,1,0);kt.DEFAULT_MATRIX_AUTO_UPDATE=!0;kt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var rt=class extends kt{constructor(){super(),this.isGroup=!0,this.type="Group"}},Pb={type:"move"},kr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new rt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new rt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new E,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new E),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new rt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new E,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new E,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let m=t.getJointPose(x,n),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Pb)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new rt;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},l0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Yi={h:0,s:0,l:0},Al={h:0,s:0,l:0};function Md(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Ae=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Zt){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,it.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=it.workingColorSpace){return this.r=e,this.g=t,this.b=n,it.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=it.workingColorSpace){if(e=Pf(e,1),t=Ge(t,0,1),n=Ge(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Md(o,r,e+1/3),this.g=Md(o,r,e),this.b=Md(o,r,e-1/3)}return it.colorSpaceToWorking(this,s),this}setStyle(e,t=Zt){function n(r){r!==void 0&&parseFloat(r)<1&&Ne("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ne("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ne("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Zt){let n=l0[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ne("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Li(e.r),this.g=Li(e.g),this.b=Li(e.b),this}copyLinearToSRGB(e){return this.r=Rr(e.r),this.g=Rr(e.g),this.b=Rr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Zt){return it.workingToColorSpace(on.copy(this),e),Math.round(Ge(on.r*255,0,255))*65536+Math.round(Ge(on.g*255,0,255))*256+Math.round(Ge(on.b*255,0,255))}getHexString(e=Zt){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=it.workingColorSpace){it.workingToColorSpace(on.copy(this),t);let n=on.r,s=on.g,r=on.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=it.workingColorSpace){return it.workingToColorSpace(on.copy(this),t),e.r=on.r,e.g=on.g,e.b=on.b,e}getStyle(e=Zt){it.workingToColorSpace(on.copy(this),e);let t=on.r,n=on.g,s=on.b;return e!==Zt?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Yi),this.setHSL(Yi.h+e,Yi.s+t,Yi.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Yi),e.getHSL(Al);let n=Go(Yi.h,Al.h,t),s=Go(Yi.s,Al.s,t),r=Go(Yi.l,Al.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},on=new Ae;Ae.NAMES=l0;var Jo=class extends kt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ii,this.environmentIntensity=1,this.environmentRotation=new ii,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},ei=new E,Ri=new E,Sd=new E,Ci=new E,ur=new E,dr=new E,qm=new E,Td=new E,Ed=new E,Ad=new E,Rd=new ut,Cd=new ut,Pd=new ut,pi=class i{constructor(e=new E,t=new E,n=new E){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),ei.subVectors(e,t),s.cross(ei);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){ei.subVectors(s,t),Ri.subVectors(n,t),Sd.subVectors(e,t);let o=ei.dot(ei),a=ei.dot(Ri),l=ei.dot(Sd),c=Ri.dot(Ri),h=Ri.dot(Sd),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Ci)===null?!1:Ci.x>=0&&Ci.y>=0&&Ci.x+Ci.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Ci)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ci.x),l.addScaledVector(o,Ci.y),l.addScaledVector(a,Ci.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Rd.setScalar(0),Cd.setScalar(0),Pd.setScalar(0),Rd.fromBufferAttribute(e,t),Cd.fromBufferAttribute(e,n),Pd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Rd,r.x),o.addScaledVector(Cd,r.y),o.addScaledVector(Pd,r.z),o}static isFrontFacing(e,t,n,s){return ei.subVectors(n,t),Ri.subVectors(e,t),ei.cross(Ri).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ei.subVectors(this.c,this.b),Ri.subVectors(this.a,this.b),ei.cross(Ri).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;ur.subVectors(s,n),dr.subVectors(r,n),Td.subVectors(e,n);let l=ur.dot(Td),c=dr.dot(Td);if(l<=0&&c<=0)return t.copy(n);Ed.subVectors(e,s);let h=ur.dot(Ed),u=dr.dot(Ed);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(ur,o);Ad.subVectors(e,r);let f=ur.dot(Ad),p=dr.dot(Ad);if(p>=0&&f<=p)return t.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(n).addScaledVector(dr,a);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return qm.subVectors(r,s),a=(u-h)/(u-h+(f-p)),t.copy(s).addScaledVector(qm,a);let g=1/(m+x+d);return o=x*g,a=d*g,t.copy(n).addScaledVector(ur,o).addScaledVector(dr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ct=class{constructor(e=new E(1/0,1/0,1/0),t=new E(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(ti.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(ti.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=ti.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,ti):ti.fromBufferAttribute(r,o),ti.applyMatrix4(e.matrixWorld),this.expandByPoint(ti);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Rl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Rl.copy(n.boundingBox)),Rl.applyMatrix4(e.matrixWorld),this.union(Rl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ti),ti.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Io),Cl.subVectors(this.max,Io),fr.subVectors(e.a,Io),pr.subVectors(e.b,Io),mr.subVectors(e.c,Io),Zi.subVectors(pr,fr),ji.subVectors(mr,pr),As.subVectors(fr,mr);let t=[0,-Zi.z,Zi.y,0,-ji.z,ji.y,0,-As.z,As.y,Zi.z,0,-Zi.x,ji.z,0,-ji.x,As.z,0,-As.x,-Zi.y,Zi.x,0,-ji.y,ji.x,0,-As.y,As.x,0];return!Id(t,fr,pr,mr,Cl)||(t=[1,0,0,0,1,0,0,0,1],!Id(t,fr,pr,mr,Cl))?!1:(Pl.crossVectors(Zi,ji),t=[Pl.x,Pl.y,Pl.z],Id(t,fr,pr,mr,Cl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ti).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ti).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Pi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Pi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Pi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Pi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Pi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Pi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Pi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Pi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Pi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Pi=[new E,new E,new E,new E,new E,new E,new E,new E],ti=new E,Rl=new Ct,fr=new E,pr=new E,mr=new E,Zi=new E,ji=new E,As=new E,Io=new E,Cl=new E,Pl=new E,Rs=new E;function Id(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Rs.fromArray(i,r);let a=s.x*Math.abs(Rs.x)+s.y*Math.abs(Rs.y)+s.z*Math.abs(Rs.z),l=e.dot(Rs),c=t.dot(Rs),h=n.dot(Rs);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Lt=new E,Il=new ee,Ib=0,yt=class extends ni{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ib++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Rf,this.updateRanges=[],this.gpuType=Zn,this.version=0,this._normalizationScale=e!==void 0?Ph(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Il.fromBufferAttribute(this,t),Il.applyMatrix3(e),this.setXY(t,Il.x,Il.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Lt.fromBufferAttribute(this,t),Lt.applyMatrix3(e),this.setXYZ(t,Lt.x,Lt.y,Lt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Lt.fromBufferAttribute(this,t),Lt.applyMatrix4(e),this.setXYZ(t,Lt.x,Lt.y,Lt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Lt.fromBufferAttribute(this,t),Lt.applyNormalMatrix(e),this.setXYZ(t,Lt.x,Lt.y,Lt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Lt.fromBufferAttribute(this,t),Lt.transformDirection(e),this.setXYZ(t,Lt.x,Lt.y,Lt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Lf(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Df(e,this.array)}};var Qo=class extends yt{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var ea=class extends yt{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Pe=class extends yt{constructor(e,t,n){super(new Float32Array(e),t,n)}},Lb=new Ct,Lo=new E,Ld=new E,an=class{constructor(e=new E,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Lb.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Lo.subVectors(e,this.center);let t=Lo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Lo,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ld.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Lo.copy(e.center).add(Ld)),this.expandByPoint(Lo.copy(e.center).sub(Ld))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Db=0,Xn=new Ie,Dd=new kt,gr=new E,Ln=new Ct,Do=new Ct,Ht=new E,Ze=class i extends ni{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Db++}),this.uuid=zi(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(sb(e)?ea:Qo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new He().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Xn.makeRotationFromQuaternion(e),this.applyMatrix4(Xn),this}rotateX(e){return Xn.makeRotationX(e),this.applyMatrix4(Xn),this}rotateY(e){return Xn.makeRotationY(e),this.applyMatrix4(Xn),this}rotateZ(e){return Xn.makeRotationZ(e),this.applyMatrix4(Xn),this}translate(e,t,n){return Xn.makeTranslation(e,t,n),this.applyMatrix4(Xn),this}scale(e,t,n){return Xn.makeScale(e,t,n),this.applyMatrix4(Xn),this}lookAt(e){return Dd.lookAt(e),Dd.updateMatrix(),this.applyMatrix4(Dd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(gr).negate(),this.translate(gr.x,gr.y,gr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Pe(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ne("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ct);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ze("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new E(-1/0,-1/0,-1/0),new E(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];Ln.setFromBufferAttribute(r),this.morphTargetsRelative?(Ht.addVectors(this.boundingBox.min,Ln.min),this.boundingBox.expandByPoint(Ht),Ht.addVectors(this.boundingBox.max,Ln.max),this.boundingBox.expandByPoint(Ht)):(this.boundingBox.expandByPoint(Ln.min),this.boundingBox.expandByPoint(Ln.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ze('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new an);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ze("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new E,1/0);return}if(e){let n=this.boundingSphere.center;if(Ln.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Do.setFromBufferAttribute(a),this.morphTargetsRelative?(Ht.addVectors(Ln.min,Do.min),Ln.expandByPoint(Ht),Ht.addVectors(Ln.max,Do.max),Ln.expandByPoint(Ht)):(Ln.expandByPoint(Do.min),Ln.expandByPoint(Do.max))}Ln.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Ht.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Ht));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Ht.fromBufferAttribute(a,c),l&&(gr.fromBufferAttribute(e,c),Ht.add(gr)),s=Math.max(s,n.distanceToSquared(Ht))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ze('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ze("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new yt(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let D=0;D<n.count;D++)a[D]=new E,l[D]=new E;let h=new E,u=new E,d=new E,f=new ee,p=new ee,x=new ee,m=new E,g=new E;function y(D,P,k){c[D]=c[P]=c[k]=1,h.fromBufferAttribute(n,D),u.fromBufferAttribute(n,P),d.fromBufferAttribute(n,k),f.fromBufferAttribute(r,D),p.fromBufferAttribute(r,P),x.fromBufferAttribute(r,k),u.sub(h),d.sub(h),p.sub(f),x.sub(f);let O=1/(p.x*x.y-x.x*p.y);isFinite(O)&&(m.copy(u).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(O),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(O),a[D].add(m),a[P].add(m),a[k].add(m),l[D].add(g),l[P].add(g),l[k].add(g))}let S=this.groups;S.length===0&&(S=[{start:0,count:e.count}]);for(let D=0,P=S.length;D<P;++D){let k=S[D],O=k.start,V=k.count;for(let I=O,G=O+V;I<G;I+=3)y(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let b=new E,A=new E,R=new E,v=new E;function T(D){R.fromBufferAttribute(s,D),v.copy(R);let P=a[D];b.copy(P),b.sub(R.multiplyScalar(R.dot(P))).normalize(),A.crossVectors(v,P);let O=A.dot(l[D])<0?-1:1;o.setXYZW(D,b.x,b.y,b.z,O)}for(let D=0,P=n.count;D<P;++D)c[D]&&T(D);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new yt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new E,r=new E,o=new E,a=new E,l=new E,c=new E,h=new E,u=new E;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),x=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Ht.fromBufferAttribute(e,t),Ht.normalize(),e.setXYZ(t,Ht.x,Ht.y,Ht.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*h;for(let g=0;g<h;g++)d[p++]=c[f++]}return new yt(d,h,u)}if(this.index===null)return Ne("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Or=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Rf,this.updateRanges=[],this.version=0,this.uuid=zi()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Ym(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Ym(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Ym(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=zi()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var fn=new E,Sn=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?Ph(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)fn.fromBufferAttribute(this,t),fn.applyMatrix4(e),this.setXYZ(t,fn.x,fn.y,fn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)fn.fromBufferAttribute(this,t),fn.applyNormalMatrix(e),this.setXYZ(t,fn.x,fn.y,fn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)fn.fromBufferAttribute(this,t),fn.transformDirection(e),this.setXYZ(t,fn.x,fn.y,fn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Zo("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new yt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Zo("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Lf(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Df(e,this.data.array)}},Nd=new E,Nb=new E,kb=new He,Dn=class{constructor(e=new E(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Nd.subVectors(n,t).cross(Nb.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Nd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||kb.getNormalMatrix(e),s=this.coplanarPoint(Nd).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Ob=0,Tn=class extends ni{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ob++}),this.uuid=zi(),this.name="",this.type="Material",this.blending=qr,this.side=as,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=af,this.blendDst=lf,this.blendEquation=Gs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ae(0,0,0),this.blendAlpha=0,this.depthFunc=Pr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Jg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=oc,this.stencilZFail=oc,this.stencilZPass=oc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ne(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ne(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ae().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Dn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new ee().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ee().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},Ur=class extends Tn{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new Ae(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},xr,No=new E,yr=new E,vr=new E,br=new ee,ko=new ee,c0=new Ie,Ll=new E,Oo=new E,Dl=new E,Zm=new ee,kd=new ee,jm=new ee,ta=class extends kt{constructor(e=new Ur){if(super(),this.isSprite=!0,this.type="Sprite",xr===void 0){xr=new Ze;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new Or(t,5);xr.setIndex([0,1,2,0,2,3]),xr.setAttribute("position",new Sn(n,3,0,!1)),xr.setAttribute("uv",new Sn(n,2,3,!1))}this.geometry=xr,this.material=e,this.center=new ee(.5,.5),this.count=1}intersectsFrustum(e){return e.intersectsSprite(this)}raycast(e,t){e.camera===null&&ze('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),yr.setFromMatrixScale(this.matrixWorld),c0.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),vr.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&yr.multiplyScalar(-vr.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Nl(Ll.set(-.5,-.5,0),vr,o,yr,s,r),Nl(Oo.set(.5,-.5,0),vr,o,yr,s,r),Nl(Dl.set(.5,.5,0),vr,o,yr,s,r),Zm.set(0,0),kd.set(1,0),jm.set(1,1);let a=e.ray.intersectTriangle(Ll,Oo,Dl,!1,No);if(a===null&&(Nl(Oo.set(-.5,.5,0),vr,o,yr,s,r),kd.set(0,1),a=e.ray.intersectTriangle(Ll,Dl,Oo,!1,No),a===null))return;let l=e.ray.origin.distanceTo(No);l<e.near||l>e.far||t.push({distance:l,point:No.clone(),uv:pi.getInterpolation(No,Ll,Oo,Dl,Zm,kd,jm,new ee),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}toJSON(e){let t=super.toJSON(e);return t.object.center=this.center.toArray(),t}};function Nl(i,e,t,n,s,r){br.subVectors(i,t).addScalar(.5).multiply(n),s!==void 0?(ko.x=r*br.x-s*br.y,ko.y=s*br.x+r*br.y):ko.copy(br),i.copy(e),i.x+=ko.x,i.y+=ko.y,i.applyMatrix4(c0)}var Ii=new E,Od=new E,kl=new E,Ol=new E,gi=class{constructor(e=new E,t=new E(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ii)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ii.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ii.copy(this.origin).addScaledVector(this.direction,t),Ii.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Od.copy(e).add(t).multiplyScalar(.5),kl.copy(t).sub(e).normalize(),Ol.copy(this.origin).sub(Od);let r=e.distanceTo(t)*.5,o=-this.direction.dot(kl),a=Ol.dot(this.direction),l=-Ol.dot(kl),c=Ol.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let x=1/h;u*=x,d*=x,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Od).addScaledVector(kl,d),f}intersectSphere(e,t){if(e.radius<0)return null;Ii.subVectors(e.center,this.origin);let n=Ii.dot(this.direction),s=Ii.dot(Ii)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Ii)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,p=t.x-o.x,x=t.y-o.y,m=t.z-o.z,g=n.x-o.x,y=n.y-o.y,S=n.z-o.z,b=Math.abs(l),A=Math.abs(c),R=Math.abs(h),v,T,D,P,k,O,V,I,G,$,H,ne;if(b>=A&&b>=R?(D=l,O=u,G=p,ne=g,l>=0?(v=c,T=h,P=d,k=f,V=x,I=m,$=y,H=S):(v=h,T=c,P=f,k=d,V=m,I=x,$=S,H=y)):A>=R?(D=c,O=d,G=x,ne=y,c>=0?(v=h,T=l,P=f,k=u,V=m,I=p,$=S,H=g):(v=l,T=h,P=u,k=f,V=p,I=m,$=g,H=S)):(D=h,O=f,G=m,ne=S,h>=0?(v=l,T=c,P=u,k=d,V=p,I=x,$=g,H=y):(v=c,T=l,P=d,k=u,V=x,I=p,$=y,H=g)),D===0)return null;let X=v/D,Q=T/D,te=1/D,we=P-X*O,Be=k-Q*O,Z=V-X*G,xe=I-Q*G,Se=$-X*ne,ke=H-Q*ne,ve=Se*xe-ke*Z,Ye=we*ke-Be*Se,Pt=Z*Be-xe*we;if(s){if(ve<0||Ye<0||Pt<0)return null}else if((ve<0||Ye<0||Pt<0)&&(ve>0||Ye>0||Pt>0))return null;let Ue=ve+Ye+Pt;if(Ue===0)return null;let dt=te*(ve*O+Ye*G+Pt*ne);return(Ue>0?dt<0:dt>0)?null:this.at(dt/Ue,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ln=class extends Tn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ae(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ii,this.combine=Da,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Km=new Ie,Cs=new gi,Ul=new an,Jm=new E,Fl=new E,Bl=new E,zl=new E,Ud=new E,Vl=new E,Qm=new E,Gl=new E,ot=class extends kt{constructor(e=new Ze,t=new ln){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Vl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Ud.fromBufferAttribute(u,e),o?Vl.addScaledVector(Ud,h):Vl.addScaledVector(Ud.sub(t),h))}t.add(Vl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Ul.copy(n.boundingSphere),Ul.applyMatrix4(r),Cs.copy(e.ray).recast(e.near),!(Ul.containsPoint(Cs.origin)===!1&&(Cs.intersectSphere(Ul,Jm)===null||Cs.origin.distanceToSquared(Jm)>(e.far-e.near)**2))&&(Km.copy(r).invert(),Cs.copy(e.ray).applyMatrix4(Km),!(n.boundingBox!==null&&Cs.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Cs)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],y=Math.max(m.start,f.start),S=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=y,A=S;b<A;b+=3){let R=a.getX(b),v=a.getX(b+1),T=a.getX(b+2);s=Hl(this,g,e,n,c,h,u,R,v,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let y=a.getX(m),S=a.getX(m+1),b=a.getX(m+2);s=Hl(this,o,e,n,c,h,u,y,S,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],y=Math.max(m.start,f.start),S=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=y,A=S;b<A;b+=3){let R=b,v=b+1,T=b+2;s=Hl(this,g,e,n,c,h,u,R,v,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let y=m,S=m+1,b=m+2;s=Hl(this,o,e,n,c,h,u,y,S,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Ub(i,e,t,n,s,r,o,a){let l;if(e.side===xn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===as,a),l===null)return null;Gl.copy(a),Gl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Gl);return c<t.near||c>t.far?null:{distance:c,point:Gl.clone(),object:i}}function Hl(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Fl),i.getVertexPosition(l,Bl),i.getVertexPosition(c,zl);let h=Ub(i,e,t,n,Fl,Bl,zl,Qm);if(h){let u=new E;pi.getBarycoord(Qm,Fl,Bl,zl,u),s&&(h.uv=pi.getInterpolatedAttribute(s,a,l,c,u,new ee)),r&&(h.uv1=pi.getInterpolatedAttribute(r,a,l,c,u,new ee)),o&&(h.normal=pi.getInterpolatedAttribute(o,a,l,c,u,new E),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new E,materialIndex:0};pi.getNormal(Fl,Bl,zl,d.normal),h.face=d,h.barycoord=u}return h}var na=class extends gn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Wt,h=Wt,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Fr=class extends yt{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},_r=new Ie,eg=new Ie,Wl=[],tg=new Ct,Fb=new Ie,Uo=new ot,Fo=new an,ia=class extends ot{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Fr(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Fb)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Ct),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,_r),tg.copy(e.boundingBox).applyMatrix4(_r),this.boundingBox.union(tg)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new an),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,_r),Fo.copy(e.boundingSphere).applyMatrix4(_r),this.boundingSphere.union(Fo)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(Uo.geometry=this.geometry,Uo.material=this.material,Uo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Fo.copy(this.boundingSphere),Fo.applyMatrix4(n),e.ray.intersectsSphere(Fo)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,_r),eg.multiplyMatrices(n,_r),Uo.matrixWorld=eg,Uo.raycast(e,Wl);for(let o=0,a=Wl.length;o<a;o++){let l=Wl[o];l.instanceId=r,l.object=this,t.push(l)}Wl.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Fr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new na(new Float32Array(s*this.count),s,this.count,jc,Zn));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Ps=new an,Bb=new ee(.5,.5),$l=new E,Ji=class{constructor(e=new Dn,t=new Dn,n=new Dn,s=new Dn,r=new Dn,o=new Dn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=qn,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],x=r[9],m=r[10],g=r[11],y=r[12],S=r[13],b=r[14],A=r[15];if(s[0].setComponents(c-o,f-h,g-p,A-y).normalize(),s[1].setComponents(c+o,f+h,g+p,A+y).normalize(),s[2].setComponents(c+a,f+u,g+x,A+S).normalize(),s[3].setComponents(c-a,f-u,g-x,A-S).normalize(),n)s[4].setComponents(l,d,m,b).normalize(),s[5].setComponents(c-l,f-d,g-m,A-b).normalize();else if(s[4].setComponents(c-l,f-d,g-m,A-b).normalize(),t===qn)s[5].setComponents(c+l,f+d,g+m,A+b).normalize();else if(t===Ir)s[5].setComponents(l,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Ps.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Ps.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Ps)}intersectsSprite(e){Ps.center.set(0,0,0);let t=Bb.distanceTo(e.center);return Ps.radius=.7071067811865476+t,Ps.applyMatrix4(e.matrixWorld),this.intersectsSphere(Ps)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if($l.x=s.normal.x>0?e.max.x:e.min.x,$l.y=s.normal.y>0?e.max.y:e.min.y,$l.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint($l)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},ng=new Ie,vc=class i{constructor(){this.coordinateSystem=qn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];ng.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Ji),n[s].setFromProjectionMatrix(ng,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Ji),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Ls=class extends Tn{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ae(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},bc=new E,_c=new E,ig=new Ie,Bo=new gi,Xl=new an,Fd=new E,sg=new E,wc=class extends kt{constructor(e=new Ze,t=new Ls){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)bc.fromBufferAttribute(t,s-1),_c.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=bc.distanceTo(_c);e.setAttribute("lineDistance",new Pe(n,1))}else Ne("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Xl.copy(n.boundingSphere),Xl.applyMatrix4(s),Xl.radius+=r,e.ray.intersectsSphere(Xl)===!1)return;ig.copy(s).invert(),Bo.copy(e.ray).applyMatrix4(ig);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=h.getX(x),y=h.getX(x+1),S=ql(this,e,Bo,l,g,y,x);S&&t.push(S)}if(this.isLineLoop){let x=h.getX(p-1),m=h.getX(f),g=ql(this,e,Bo,l,x,m,p-1);g&&t.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=ql(this,e,Bo,l,x,x+1,x);g&&t.push(g)}if(this.isLineLoop){let x=ql(this,e,Bo,l,p-1,f,p-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ql(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(bc.fromBufferAttribute(a,s),_c.fromBufferAttribute(a,r),t.distanceSqToSegment(bc,_c,Fd,sg)>n)return;Fd.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Fd);if(!(c<e.near||c>e.far))return{distance:c,point:sg.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var rg=new E,og=new E,Br=class extends wc{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)rg.fromBufferAttribute(t,s),og.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+rg.distanceTo(og);e.setAttribute("lineDistance",new Pe(n,1))}else Ne("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var zr=class extends Tn{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Ae(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},ag=new Ie,Zd=new gi,Yl=new an,Zl=new E,sa=class extends kt{constructor(e=new Ze,t=new zr){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Yl.copy(n.boundingSphere),Yl.applyMatrix4(s),Yl.radius+=r,e.ray.intersectsSphere(Yl)===!1)return;ag.copy(s).invert(),Zd.copy(e.ray).applyMatrix4(ag);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,x=f;p<x;p++){let m=c.getX(p);Zl.fromBufferAttribute(u,m),lg(Zl,m,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let p=d,x=f;p<x;p++)Zl.fromBufferAttribute(u,p),lg(Zl,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function lg(i,e,t,n,s,r,o){let a=Zd.distanceSqToPoint(i);if(a<t){let l=new E;Zd.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var ra=class extends gn{constructor(e=[],t=Hs,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},oa=class extends gn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ni=class extends gn{constructor(e,t,n=si,s,r,o,a=Wt,l=Wt,c,h=Di,u=1){if(h!==Di&&h!==Fi)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Nr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},aa=class extends Ni{constructor(e,t=si,n=Hs,s,r,o=Wt,a=Wt,l,c=Di){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},la=class extends gn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},kn=class i extends Ze{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Pe(c,3)),this.setAttribute("normal",new Pe(h,3)),this.setAttribute("uv",new Pe(u,2));function p(x,m,g,y,S,b,A,R,v,T,D){let P=b/v,k=A/T,O=b/2,V=A/2,I=R/2,G=v+1,$=T+1,H=0,ne=0,X=new E;for(let Q=0;Q<$;Q++){let te=Q*k-V;for(let we=0;we<G;we++){let Be=we*P-O;X[x]=Be*y,X[m]=te*S,X[g]=I,c.push(X.x,X.y,X.z),X[x]=0,X[m]=0,X[g]=R>0?1:-1,h.push(X.x,X.y,X.z),u.push(we/v),u.push(1-Q/T),H+=1}}for(let Q=0;Q<T;Q++)for(let te=0;te<v;te++){let we=d+te+G*Q,Be=d+te+G*(Q+1),Z=d+(te+1)+G*(Q+1),xe=d+(te+1)+G*Q;l.push(we,Be,xe),l.push(Be,Z,xe),ne+=6}a.addGroup(f,ne,D),f+=ne,d+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}},Ds=class i extends Ze{constructor(e=1,t=1,n=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:e,height:t,capSegments:n,radialSegments:s,heightSegments:r},t=Math.max(0,t),n=Math.max(1,Math.floor(n)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],h=t/2,u=Math.PI/2*e,d=t,f=2*u+d,p=n*2+r,x=s+1,m=new E,g=new E;for(let y=0;y<=p;y++){let S=0,b=0,A=0,R=0;if(y<=n){let D=y/n,P=D*Math.PI/2;b=-h-e*Math.cos(P),A=e*Math.sin(P),R=-e*Math.cos(P),S=D*u}else if(y<=n+r){let D=(y-n)/r;b=-h+D*t,A=e,R=0,S=u+D*d}else{let D=(y-n-r)/n,P=D*Math.PI/2;b=h+e*Math.sin(P),A=e*Math.cos(P),R=e*Math.sin(P),S=u+d+D*u}let v=Math.max(0,Math.min(1,S/f)),T=0;y===0?T=.5/s:y===p&&(T=-.5/s);for(let D=0;D<=s;D++){let P=D/s,k=P*Math.PI*2,O=Math.sin(k),V=Math.cos(k);g.x=-A*V,g.y=b,g.z=A*O,a.push(g.x,g.y,g.z),m.set(-A*V,R,A*O),m.normalize(),l.push(m.x,m.y,m.z),c.push(P+T,v)}if(y>0){let D=(y-1)*x;for(let P=0;P<s;P++){let k=D+P,O=D+P+1,V=y*x+P,I=y*x+P+1;o.push(k,O,V),o.push(O,I,V)}}}this.setIndex(o),this.setAttribute("position",new Pe(a,3)),this.setAttribute("normal",new Pe(l,3)),this.setAttribute("uv",new Pe(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.height,e.capSegments,e.radialSegments,e.heightSegments)}},Qi=class i extends Ze{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],l=[],c=new E,h=new ee;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let u=0,d=3;u<=t;u++,d+=3){let f=n+u/t*s;c.x=e*Math.cos(f),c.y=e*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),h.x=(o[d]/e+1)/2,h.y=(o[d+1]/e+1)/2,l.push(h.x,h.y)}for(let u=1;u<=t;u++)r.push(u,u+1,0);this.setIndex(r),this.setAttribute("position",new Pe(o,3)),this.setAttribute("normal",new Pe(a,3)),this.setAttribute("uv",new Pe(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},es=class i extends Ze{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,x=[],m=n/2,g=0;y(),o===!1&&(e>0&&S(!0),t>0&&S(!1)),this.setIndex(h),this.setAttribute("position",new Pe(u,3)),this.setAttribute("normal",new Pe(d,3)),this.setAttribute("uv",new Pe(f,2));function y(){let b=new E,A=new E,R=0,v=(t-e)/n;for(let T=0;T<=r;T++){let D=[],P=T/r,k=P*(t-e)+e;for(let O=0;O<=s;O++){let V=O/s,I=V*l+a,G=Math.sin(I),$=Math.cos(I);A.x=k*G,A.y=-P*n+m,A.z=k*$,u.push(A.x,A.y,A.z),b.set(G,v,$).normalize(),d.push(b.x,b.y,b.z),f.push(V,1-P),D.push(p++)}x.push(D)}for(let T=0;T<s;T++)for(let D=0;D<r;D++){let P=x[D][T],k=x[D+1][T],O=x[D+1][T+1],V=x[D][T+1];(e>0||D!==0)&&(h.push(P,k,V),R+=3),(t>0||D!==r-1)&&(h.push(k,O,V),R+=3)}c.addGroup(g,R,0),g+=R}function S(b){let A=p,R=new ee,v=new E,T=0,D=b===!0?e:t,P=b===!0?1:-1;for(let O=1;O<=s;O++)u.push(0,m*P,0),d.push(0,P,0),f.push(.5,.5),p++;let k=p;for(let O=0;O<=s;O++){let I=O/s*l+a,G=Math.cos(I),$=Math.sin(I);v.x=D*$,v.y=m*P,v.z=D*G,u.push(v.x,v.y,v.z),d.push(0,P,0),R.x=G*.5+.5,R.y=$*.5*P+.5,f.push(R.x,R.y),p++}for(let O=0;O<s;O++){let V=A+O,I=k+O;b===!0?h.push(I,I+1,V):h.push(I+1,I,V),T+=3}c.addGroup(g,T,b===!0?1:2),g+=T}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Ns=class i extends es{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var jl=new E,Kl=new E,Bd=new E,Jl=new pi,ca=class extends Ze{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(Ar*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:x,b:m,c:g}=Jl;if(x.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),Jl.getNormal(Bd),u[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,u[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,u[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let y=0;y<3;y++){let S=(y+1)%3,b=u[y],A=u[S],R=Jl[h[y]],v=Jl[h[S]],T=`${b}_${A}`,D=`${A}_${b}`,P=d.get(D);P?(Bd.dot(P.normal)<=r&&(f.push(R.x,R.y,R.z),f.push(v.x,v.y,v.z)),d.set(D,null)):d.has(T)||d.set(T,{index0:c[y],index1:c[S],normal:Bd.clone()})}}for(let p of d.values())if(p){let{index0:x,index1:m}=p;jl.fromBufferAttribute(a,x),Kl.fromBufferAttribute(a,m),f.push(jl.x,jl.y,jl.z),f.push(Kl.x,Kl.y,Kl.z)}this.setAttribute("position",new Pe(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}},On=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Ne("Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],d=n[s+1]-h,f=(o-h)/d;return(s+f)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new ee:new E);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new E,s=[],r=[],o=[],a=new E,l=new Ie;for(let f=0;f<=e;f++){let p=f/e;s[f]=this.getTangentAt(p,new E)}r[0]=new E,o[0]=new E;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),d<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=e;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(Ge(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,p))}o[f].crossVectors(s[f],r[f])}if(t===!0){let f=Math.acos(Ge(r[0].dot(r[e]),-1,1));f/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(f=-f);for(let p=1;p<=e;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],f*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}},Vr=class extends On{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new ee){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},Mc=class extends Vr{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Nf(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let d=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+u)+(l-a)/u;d*=h,f*=h,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var cg=new E,hg=new E,zd=new Nf,Vd=new Nf,Gd=new Nf,Sc=class extends On{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new E){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(hg.subVectors(s[0],s[1]).add(s[0]),c=hg);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(cg.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=cg),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),f),x=Math.pow(u.distanceToSquared(d),f),m=Math.pow(d.distanceToSquared(h),f);x<1e-4&&(x=1),p<1e-4&&(p=x),m<1e-4&&(m=x),zd.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,p,x,m),Vd.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,p,x,m),Gd.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,p,x,m)}else this.curveType==="catmullrom"&&(zd.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),Vd.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),Gd.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return n.set(zd.calc(l),Vd.calc(l),Gd.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new E().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function ug(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function zb(i,e){let t=1-i;return t*t*e}function Vb(i,e){return 2*(1-i)*i*e}function Gb(i,e){return i*i*e}function Ho(i,e,t,n){return zb(i,e)+Vb(i,t)+Gb(i,n)}function Hb(i,e){let t=1-i;return t*t*t*e}function Wb(i,e){let t=1-i;return 3*t*t*i*e}function $b(i,e){return 3*(1-i)*i*i*e}function Xb(i,e){return i*i*i*e}function Wo(i,e,t,n,s){return Hb(i,e)+Wb(i,t)+$b(i,n)+Xb(i,s)}var ha=class extends On{constructor(e=new ee,t=new ee,n=new ee,s=new ee){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new ee){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Wo(e,s.x,r.x,o.x,a.x),Wo(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Tc=class extends On{constructor(e=new E,t=new E,n=new E,s=new E){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new E){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Wo(e,s.x,r.x,o.x,a.x),Wo(e,s.y,r.y,o.y,a.y),Wo(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},ua=class extends On{constructor(e=new ee,t=new ee){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new ee){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new ee){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Ec=class extends On{constructor(e=new E,t=new E){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new E){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new E){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},da=class extends On{constructor(e=new ee,t=new ee,n=new ee){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new ee){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(Ho(e,s.x,r.x,o.x),Ho(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Ac=class extends On{constructor(e=new E,t=new E,n=new E){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new E){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(Ho(e,s.x,r.x,o.x),Ho(e,s.y,r.y,o.y),Ho(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},fa=class extends On{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new ee){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(ug(a,l.x,c.x,h.x,u.x),ug(a,l.y,c.y,h.y,u.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new ee().fromArray(s))}return this}},dg=Object.freeze({__proto__:null,ArcCurve:Mc,CatmullRomCurve3:Sc,CubicBezierCurve:ha,CubicBezierCurve3:Tc,EllipseCurve:Vr,LineCurve:ua,LineCurve3:Ec,QuadraticBezierCurve:da,QuadraticBezierCurve3:Ac,SplineCurve:fa}),Rc=class extends On{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(e){this.curves.push(e)}closePath(){let e=this.curves[0].getPoint(0),t=this.curves[this.curves.length-1].getPoint(1);if(!e.equals(t)){let n=e.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new dg[n](t,e))}return this}getPoint(e,t){let n=e*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,t)}r++}return null}getLength(){let e=this.getCurveLengths();return e[e.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let e=[],t=0;for(let n=0,s=this.curves.length;n<s;n++)t+=this.curves[n].getLength(),e.push(t);return this.cacheLengths=e,e}getSpacedPoints(e=40){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return this.autoClose&&t.push(t[0]),t}getPoints(e=12){let t=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?e*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?e*o.points.length:e,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(t.push(h),n=h)}}return this.autoClose&&t.length>1&&!t[t.length-1].equals(t[0])&&t.push(t[0]),t}copy(e){super.copy(e),this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(s.clone())}return this.autoClose=e.autoClose,this.cacheLengths=null,this}toJSON(){let e=super.toJSON();e.autoClose=this.autoClose,e.curves=[];for(let t=0,n=this.curves.length;t<n;t++){let s=this.curves[t];e.curves.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.autoClose=e.autoClose,this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(new dg[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},pa=class extends Rc{constructor(e){super(),this.type="Path",this.currentPoint=new ee,e&&this.setFromPoints(e)}setFromPoints(e){this.moveTo(e[0].x,e[0].y);for(let t=1,n=e.length;t<n;t++)this.lineTo(e[t].x,e[t].y);return this}moveTo(e,t){return this.currentPoint.set(e,t),this}lineTo(e,t){let n=new ua(this.currentPoint.clone(),new ee(e,t));return this.curves.push(n),this.currentPoint.set(e,t),this}quadraticCurveTo(e,t,n,s){let r=new da(this.currentPoint.clone(),new ee(e,t),new ee(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(e,t,n,s,r,o){let a=new ha(this.currentPoint.clone(),new ee(e,t),new ee(n,s),new ee(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(e){let t=[this.currentPoint.clone()].concat(e),n=new fa(t);return this.curves.push(n),this.currentPoint.copy(e[e.length-1]),this}arc(e,t,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(e+a,t+l,n,s,r,o),this}absarc(e,t,n,s,r,o){return this.absellipse(e,t,n,n,s,r,o),this}ellipse(e,t,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(e+c,t+h,n,s,r,o,a,l),this}absellipse(e,t,n,s,r,o,a,l){let c=new Vr(e,t,n,s,r,o,a,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(e){return super.copy(e),this.currentPoint.copy(e.currentPoint),this}toJSON(){let e=super.toJSON();return e.currentPoint=this.currentPoint.toArray(),e}fromJSON(e){return super.fromJSON(e),this.currentPoint.fromArray(e.currentPoint),this}},ki=class extends pa{constructor(e){super(e),this.uuid=zi(),this.type="Shape",this.holes=[]}getPointsHoles(e){let t=[];for(let n=0,s=this.holes.length;n<s;n++)t[n]=this.holes[n].getPoints(e);return t}extractPoints(e){return{shape:this.getPoints(e),holes:this.getPointsHoles(e)}}copy(e){super.copy(e),this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.uuid=this.uuid,e.holes=[];for(let t=0,n=this.holes.length;t<n;t++){let s=this.holes[t];e.holes.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.uuid=e.uuid,this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(new pa().fromJSON(s))}return this}};function qb(i,e,t=2){let n=e&&e.length,s=n?e[0]*t:i.length,r=h0(i,0,s,t,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=Jb(i,e,r,t)),i.length>80*t){a=i[0],l=i[1];let h=a,u=l;for(let d=t;d<s;d+=t){let f=i[d],p=i[d+1];f<a&&(a=f),p<l&&(l=p),f>h&&(h=f),p>u&&(u=p)}c=Math.max(h-a,u-l),c=c!==0?32767/c:0}return ma(r,o,t,a,l,c,0),o}function h0(i,e,t,n,s){let r;if(s===c_(i,e,t,n)>0)for(let o=e;o<t;o+=n)r=fg(o/n|0,i[o],i[o+1],r);else for(let o=t-n;o>=e;o-=n)r=fg(o/n|0,i[o],i[o+1],r);return r&&Gr(r,r.next)&&(xa(r),r=r.next),r}function ks(i,e){if(!i)return i;e||(e=i);let t=i,n;do if(n=!1,!t.steiner&&(Gr(t,t.next)||Tt(t.prev,t,t.next)===0)){if(xa(t),t=e=t.prev,t===t.next)break;n=!0}else t=t.next;while(n||t!==e);return e}function ma(i,e,t,n,s,r,o){if(!i)return;!o&&r&&i_(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?Zb(i,n,s,r):Yb(i)){e.push(l.i,i.i,c.i),xa(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=jb(ks(i),e),ma(i,e,t,n,s,r,2)):o===2&&Kb(i,e,t,n,s,r):ma(ks(i),e,t,n,s,r,1);break}}}function Yb(i){let e=i.prev,t=i,n=i.next;if(Tt(e,t,n)>=0)return!1;let s=e.x,r=t.x,o=n.x,a=e.y,l=t.y,c=n.y,h=Math.min(s,r,o),u=Math.min(a,l,c),d=Math.max(s,r,o),f=Math.max(a,l,c),p=n.next;for(;p!==e;){if(p.x>=h&&p.x<=d&&p.y>=u&&p.y<=f&&zo(s,a,r,l,o,c,p.x,p.y)&&Tt(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function Zb(i,e,t,n){let s=i.prev,r=i,o=i.next;if(Tt(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,h=s.y,u=r.y,d=o.y,f=Math.min(a,l,c),p=Math.min(h,u,d),x=Math.max(a,l,c),m=Math.max(h,u,d),g=jd(f,p,e,t,n),y=jd(x,m,e,t,n),S=i.prevZ,b=i.nextZ;for(;S&&S.z>=g&&b&&b.z<=y;){if(S.x>=f&&S.x<=x&&S.y>=p&&S.y<=m&&S!==s&&S!==o&&zo(a,h,l,u,c,d,S.x,S.y)&&Tt(S.prev,S,S.next)>=0||(S=S.prevZ,b.x>=f&&b.x<=x&&b.y>=p&&b.y<=m&&b!==s&&b!==o&&zo(a,h,l,u,c,d,b.x,b.y)&&Tt(b.prev,b,b.next)>=0))return!1;b=b.nextZ}for(;S&&S.z>=g;){if(S.x>=f&&S.x<=x&&S.y>=p&&S.y<=m&&S!==s&&S!==o&&zo(a,h,l,u,c,d,S.x,S.y)&&Tt(S.prev,S,S.next)>=0)return!1;S=S.prevZ}for(;b&&b.z<=y;){if(b.x>=f&&b.x<=x&&b.y>=p&&b.y<=m&&b!==s&&b!==o&&zo(a,h,l,u,c,d,b.x,b.y)&&Tt(b.prev,b,b.next)>=0)return!1;b=b.nextZ}return!0}function jb(i,e){let t=i;do{let n=t.prev,s=t.next.next;!Gr(n,s)&&d0(n,t,t.next,s)&&ga(n,s)&&ga(s,n)&&(e.push(n.i,t.i,s.i),xa(t),xa(t.next),t=i=s),t=t.next}while(t!==i);return ks(t)}function Kb(i,e,t,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&o_(o,a)){let l=f0(o,a);o=ks(o,o.next),l=ks(l,l.next),ma(o,e,t,n,s,r,0),ma(l,e,t,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function Jb(i,e,t,n){let s=[];for(let r=0,o=e.length;r<o;r++){let a=e[r]*n,l=r<o-1?e[r+1]*n:i.length,c=h0(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(r_(c))}s.sort(Qb);for(let r=0;r<s.length;r++)t=e_(s[r],t);return t}function Qb(i,e){let t=i.x-e.x;if(t===0&&(t=i.y-e.y,t===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(e.next.y-e.y)/(e.next.x-e.x);t=n-s}return t}function e_(i,e){let t=t_(i,e);if(!t)return e;let n=f0(t,i);return ks(n,n.next),ks(t,t.next)}function t_(i,e){let t=e,n=i.x,s=i.y,r=-1/0,o;if(Gr(i,t))return t;do{if(Gr(i,t.next))return t.next;if(s<=t.y&&s>=t.next.y&&t.next.y!==t.y){let u=t.x+(s-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(u<=n&&u>r&&(r=u,o=t.x<t.next.x?t:t.next,u===n))return o}t=t.next}while(t!==e);if(!o)return null;let a=o,l=o.x,c=o.y,h=1/0;t=o;do{if(n>=t.x&&t.x>=l&&n!==t.x&&u0(s<c?n:r,s,l,c,s<c?r:n,s,t.x,t.y)){let u=Math.abs(s-t.y)/(n-t.x);ga(t,i)&&(u<h||u===h&&(t.x>o.x||t.x===o.x&&n_(o,t)))&&(o=t,h=u)}t=t.next}while(t!==a);return o}function n_(i,e){return Tt(i.prev,i,e.prev)<0&&Tt(e.next,i,i.next)<0}function i_(i,e,t,n){let s=i;do s.z===0&&(s.z=jd(s.x,s.y,e,t,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,s_(s)}function s_(i){let e,t=1;do{let n=i,s;i=null;let r=null;for(e=0;n;){e++;let o=n,a=0;for(let c=0;c<t&&(a++,o=o.nextZ,!!o);c++);let l=t;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,t*=2}while(e>1);return i}function jd(i,e,t,n,s){return i=(i-t)*s|0,e=(e-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,i|e<<1}function r_(i){let e=i,t=i;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==i);return t}function u0(i,e,t,n,s,r,o,a){return(s-o)*(e-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(t-o)*(e-a)&&(t-o)*(r-a)>=(s-o)*(n-a)}function zo(i,e,t,n,s,r,o,a){return!(i===o&&e===a)&&u0(i,e,t,n,s,r,o,a)}function o_(i,e){return i.next.i!==e.i&&i.prev.i!==e.i&&!a_(i,e)&&(ga(i,e)&&ga(e,i)&&l_(i,e)&&(Tt(i.prev,i,e.prev)||Tt(i,e.prev,e))||Gr(i,e)&&Tt(i.prev,i,i.next)>0&&Tt(e.prev,e,e.next)>0)}function Tt(i,e,t){return(e.y-i.y)*(t.x-e.x)-(e.x-i.x)*(t.y-e.y)}function Gr(i,e){return i.x===e.x&&i.y===e.y}function d0(i,e,t,n){let s=ec(Tt(i,e,t)),r=ec(Tt(i,e,n)),o=ec(Tt(t,n,i)),a=ec(Tt(t,n,e));return!!(s!==r&&o!==a||s===0&&Ql(i,t,e)||r===0&&Ql(i,n,e)||o===0&&Ql(t,i,n)||a===0&&Ql(t,e,n))}function Ql(i,e,t){return e.x<=Math.max(i.x,t.x)&&e.x>=Math.min(i.x,t.x)&&e.y<=Math.max(i.y,t.y)&&e.y>=Math.min(i.y,t.y)}function ec(i){return i>0?1:i<0?-1:0}function a_(i,e){let t=i;do{if(t.i!==i.i&&t.next.i!==i.i&&t.i!==e.i&&t.next.i!==e.i&&d0(t,t.next,i,e))return!0;t=t.next}while(t!==i);return!1}function ga(i,e){return Tt(i.prev,i,i.next)<0?Tt(i,e,i.next)>=0&&Tt(i,i.prev,e)>=0:Tt(i,e,i.prev)<0||Tt(i,i.next,e)<0}function l_(i,e){let t=i,n=!1,s=(i.x+e.x)/2,r=(i.y+e.y)/2;do t.y>r!=t.next.y>r&&t.next.y!==t.y&&s<(t.next.x-t.x)*(r-t.y)/(t.next.y-t.y)+t.x&&(n=!n),t=t.next;while(t!==i);return n}function f0(i,e){let t=Kd(i.i,i.x,i.y),n=Kd(e.i,e.x,e.y),s=i.next,r=e.prev;return i.next=e,e.prev=i,t.next=s,s.prev=t,n.next=t,t.prev=n,r.next=n,n.prev=r,n}function fg(i,e,t,n){let s=Kd(i,e,t);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function xa(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function Kd(i,e,t){return{i,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function c_(i,e,t,n){let s=0;for(let r=e,o=t-n;r<t;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var Jd=class{static triangulate(e,t,n=2){return qb(e,t,n)}},Cr=class i{static area(e){let t=e.length,n=0;for(let s=t-1,r=0;r<t;s=r++)n+=e[s].x*e[r].y-e[r].x*e[s].y;return n*.5}static isClockWise(e){return i.area(e)<0}static triangulateShape(e,t){let n=[],s=[],r=[];pg(e),mg(n,e);let o=e.length;t.forEach(pg);for(let l=0;l<t.length;l++)s.push(o),o+=t[l].length,mg(n,t[l]);let a=Jd.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function pg(i){let e=i.length;e>2&&i[e-1].equals(i[0])&&i.pop()}function mg(i,e){for(let t=0;t<e.length;t++)i.push(e[t].x),i.push(e[t].y)}var ya=class i extends Ze{constructor(e=[new ee(0,-.5),new ee(.5,0),new ee(0,.5)],t=12,n=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:e,segments:t,phiStart:n,phiLength:s},t=Math.floor(t),s=Ge(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],h=1/t,u=new E,d=new ee,f=new E,p=new E,x=new E,m=0,g=0;for(let y=0;y<=e.length-1;y++)switch(y){case 0:m=e[y+1].x-e[y].x,g=e[y+1].y-e[y].y,f.x=g*1,f.y=-m,f.z=g*0,x.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case e.length-1:x.normalize(),l.push(x.x,x.y,x.z);break;default:m=e[y+1].x-e[y].x,g=e[y+1].y-e[y].y,f.x=g*1,f.y=-m,f.z=g*0,p.copy(f),f.x+=x.x,f.y+=x.y,f.z+=x.z,f.normalize(),l.push(f.x,f.y,f.z),x.copy(p)}for(let y=0;y<=t;y++){let S=n+y*h*s,b=Math.sin(S),A=Math.cos(S);for(let R=0;R<=e.length-1;R++){u.x=e[R].x*b,u.y=e[R].y,u.z=e[R].x*A,o.push(u.x,u.y,u.z),d.x=y/t,d.y=R/(e.length-1),a.push(d.x,d.y);let v=l[3*R+0]*b,T=l[3*R+1],D=l[3*R+0]*A;c.push(v,T,D)}}for(let y=0;y<t;y++)for(let S=0;S<e.length-1;S++){let b=S+y*e.length,A=b,R=b+e.length,v=b+e.length+1,T=b+1;r.push(A,R,T),r.push(v,T,R)}this.setIndex(r),this.setAttribute("position",new Pe(o,3)),this.setAttribute("uv",new Pe(a,2)),this.setAttribute("normal",new Pe(c,3))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.points,e.segments,e.phiStart,e.phiLength)}};var Os=class i extends Ze{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],p=[],x=[],m=[];for(let g=0;g<h;g++){let y=g*d-o;for(let S=0;S<c;S++){let b=S*u-r;p.push(b,-y,0),x.push(0,0,1),m.push(S/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let y=0;y<a;y++){let S=y+c*g,b=y+c*(g+1),A=y+1+c*(g+1),R=y+1+c*g;f.push(S,b,R),f.push(b,A,R)}this.setIndex(f),this.setAttribute("position",new Pe(p,3)),this.setAttribute("normal",new Pe(x,3)),this.setAttribute("uv",new Pe(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}},Us=class i extends Ze{constructor(e=.5,t=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],u=e,d=(t-e)/s,f=new E,p=new ee;for(let x=0;x<=s;x++){for(let m=0;m<=n;m++){let g=r+m/n*o;f.x=u*Math.cos(g),f.y=u*Math.sin(g),l.push(f.x,f.y,f.z),c.push(0,0,1),p.x=(f.x/t+1)/2,p.y=(f.y/t+1)/2,h.push(p.x,p.y)}u+=d}for(let x=0;x<s;x++){let m=x*(n+1);for(let g=0;g<n;g++){let y=g+m,S=y,b=y+n+1,A=y+n+2,R=y+1;a.push(S,b,R),a.push(b,A,R)}}this.setIndex(a),this.setAttribute("position",new Pe(l,3)),this.setAttribute("normal",new Pe(c,3)),this.setAttribute("uv",new Pe(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}},Fs=class i extends Ze{constructor(e=new ki([new ee(0,.5),new ee(-.5,-.5),new ee(.5,-.5)]),t=12){super(),this.type="ShapeGeometry",this.parameters={shapes:e,curveSegments:t};let n=[],s=[],r=[],o=[],a=0,l=0;if(Array.isArray(e)===!1)c(e);else for(let h=0;h<e.length;h++)c(e[h]),this.addGroup(a,l,h),a+=l,l=0;this.setIndex(n),this.setAttribute("position",new Pe(s,3)),this.setAttribute("normal",new Pe(r,3)),this.setAttribute("uv",new Pe(o,2));function c(h){let u=s.length/3,d=h.extractPoints(t),f=d.shape,p=d.holes;Cr.isClockWise(f)===!1&&(f=f.reverse());for(let m=0,g=p.length;m<g;m++){let y=p[m];Cr.isClockWise(y)===!0&&(p[m]=y.reverse())}let x=Cr.triangulateShape(f,p);for(let m=0,g=p.length;m<g;m++){let y=p[m];f=f.concat(y)}for(let m=0,g=f.length;m<g;m++){let y=f[m];s.push(y.x,y.y,0),r.push(0,0,1),o.push(y.x,y.y)}for(let m=0,g=x.length;m<g;m++){let y=x[m],S=y[0]+u,b=y[1]+u,A=y[2]+u;n.push(S,b,A),l+=3}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes;return h_(t,e)}static fromJSON(e,t){let n=[];for(let s=0,r=e.shapes.length;s<r;s++){let o=t[e.shapes[s]];n.push(o)}return new i(n,e.curveSegments)}};function h_(i,e){if(e.shapes=[],Array.isArray(i))for(let t=0,n=i.length;t<n;t++){let s=i[t];e.shapes.push(s.uuid)}else e.shapes.push(i.uuid);return e}var Oi=class i extends Ze{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new E,d=new E,f=[],p=[],x=[],m=[];for(let g=0;g<=n;g++){let y=[],S=g/n,b=o+S*a,A=e*Math.cos(b),R=Math.sqrt(e*e-A*A),v=0;g===0&&o===0?v=.5/t:g===n&&l===Math.PI&&(v=-.5/t);for(let T=0;T<=t;T++){let D=T/t,P=s+D*r;u.x=-R*Math.cos(P),u.y=A,u.z=R*Math.sin(P),p.push(u.x,u.y,u.z),d.copy(u).normalize(),x.push(d.x,d.y,d.z),m.push(D+v,1-S),y.push(c++)}h.push(y)}for(let g=0;g<n;g++)for(let y=0;y<t;y++){let S=h[g][y+1],b=h[g][y],A=h[g+1][y],R=h[g+1][y+1];(g!==0||o>0)&&f.push(S,b,R),(g!==n-1||l<Math.PI)&&f.push(b,A,R)}this.setIndex(f),this.setAttribute("position",new Pe(p,3)),this.setAttribute("normal",new Pe(x,3)),this.setAttribute("uv",new Pe(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var va=class extends Ze{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new E,r=new E;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,h=l.length;c<h;++c){let u=l[c],d=u.start,f=u.count;for(let p=d,x=d+f;p<x;p+=3)for(let m=0;m<3;m++){let g=a.getX(p+m),y=a.getX(p+(m+1)%3);s.fromBufferAttribute(o,g),r.fromBufferAttribute(o,y),gg(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let h=3*a+c,u=3*a+(c+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,u),gg(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new Pe(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function gg(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}var ba=class extends Tn{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new Ae(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function $s(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(xg(s))s.isRenderTargetTexture?(Ne("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(xg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function cn(i){let e={};for(let t=0;t<i.length;t++){let n=$s(i[t]);for(let s in n)e[s]=n[s]}return e}function xg(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function u_(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function kf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:it.workingColorSpace}var Va={clone:$s,merge:cn},d_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,f_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Yn=class extends Tn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=d_,this.fragmentShader=f_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=$s(e.uniforms),this.uniformsGroups=u_(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Ae().setHex(s.value);break;case"v2":this.uniforms[n].value=new ee().fromArray(s.value);break;case"v3":this.uniforms[n].value=new E().fromArray(s.value);break;case"v4":this.uniforms[n].value=new ut().fromArray(s.value);break;case"m3":this.uniforms[n].value=new He().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ie().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Cc=class extends Yn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},_a=class extends Tn{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Ae(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ae(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=jr,this.normalScale=new ee(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ii,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var wa=class extends Tn{constructor(e){super(),this.isMeshPhongMaterial=!0,this.type="MeshPhongMaterial",this.color=new Ae(16777215),this.specular=new Ae(1118481),this.shininess=30,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ae(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=jr,this.normalScale=new ee(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ii,this.combine=Da,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.specular.copy(e.specular),this.shininess=e.shininess,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Un=class extends Tn{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ae(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ae(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=jr,this.normalScale=new ee(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ii,this.combine=Da,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Pc=class extends Tn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=jg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Ic=class extends Tn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function wr(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function tc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var ts=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Lc=class extends ts{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Xd,endingEnd:Xd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case qd:r=e,a=2*t-n;break;case Yd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case qd:o=e,l=2*n-t;break;case Yd:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-t)/(s-t),x=p*p,m=x*p,g=-d*m+2*d*x-d*p,y=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*p+1,S=(-1-f)*m+(1.5+f)*x+.5*p,b=f*m-f*x;for(let A=0;A!==a;++A)r[A]=g*o[h+A]+y*o[c+A]+S*o[l+A]+b*o[u+A];return r}},Dc=class extends ts{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Nc=class extends ts{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},kc=class extends ts{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-t)/(s-t),x=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=f*d+p*2,y=u[g],S=u[g+1],b=e*d+p*2,A=h[b],R=h[b+1],v=m_(n,t,y,A,s);r[p]=p0(v,x,S,R,m)}return r}};function p0(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function p_(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function m_(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=p0(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=p_(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Fn=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=wr(t,this.TimeBufferType),this.values=wr(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:wr(e.times,Array),values:wr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),tc(e.settings)&&(n.settings={inTangents:wr(e.settings.inTangents,Array),outTangents:wr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Nc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Dc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Lc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new kc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case $o:t=this.InterpolantFactoryMethodDiscrete;break;case mc:t=this.InterpolantFactoryMethodLinear;break;case rc:t=this.InterpolantFactoryMethodSmooth;break;case $d:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ne("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return $o;case this.InterpolantFactoryMethodLinear:return mc;case this.InterpolantFactoryMethodSmooth:return rc;case this.InterpolantFactoryMethodBezier:return $d}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;tc(this.settings)&&(yg(this.settings.inTangents,e),yg(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;tc(this.settings)&&(vg(this.settings.inTangents,e),vg(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(ze("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ze("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ze("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){ze("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&rb(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ze("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===rc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let x=t[u+p];if(x!==t[d+p]||x!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,tc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function yg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function vg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Fn.prototype.ValueTypeName="";Fn.prototype.TimeBufferType=Float32Array;Fn.prototype.ValueBufferType=Float32Array;Fn.prototype.DefaultInterpolation=mc;var ns=class extends Fn{constructor(e,t,n){super(e,t,n)}};ns.prototype.ValueTypeName="bool";ns.prototype.ValueBufferType=Array;ns.prototype.DefaultInterpolation=$o;ns.prototype.InterpolantFactoryMethodLinear=void 0;ns.prototype.InterpolantFactoryMethodSmooth=void 0;var Oc=class extends Fn{constructor(e,t,n,s){super(e,t,n,s)}};Oc.prototype.ValueTypeName="color";var Uc=class extends Fn{constructor(e,t,n,s){super(e,t,n,s)}};Uc.prototype.ValueTypeName="number";var Fc=class extends ts{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)Rt.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ma=class extends Fn{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Fc(this.times,this.values,this.getValueSize(),e)}};Ma.prototype.ValueTypeName="quaternion";Ma.prototype.InterpolantFactoryMethodSmooth=void 0;var is=class extends Fn{constructor(e,t,n){super(e,t,n)}};is.prototype.ValueTypeName="string";is.prototype.ValueBufferType=Array;is.prototype.DefaultInterpolation=$o;is.prototype.InterpolantFactoryMethodLinear=void 0;is.prototype.InterpolantFactoryMethodSmooth=void 0;var Bc=class extends Fn{constructor(e,t,n,s){super(e,t,n,s)}};Bc.prototype.ValueTypeName="vector";var zc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},m0=new zc,Vc=class{constructor(e){this.manager=e!==void 0?e:m0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Vc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Hr=class extends kt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Ae(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Sa=class extends Hr{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(kt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ae(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Hd=new Ie,bg=new E,_g=new E,Gc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ee(512,512),this.mapType=En,this.map=null,this.mapPass=null,this.matrix=new Ie,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Ji,this._frameExtents=new ee(1,1),this._viewportCount=1,this._viewports=[new ut(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;bg.setFromMatrixPosition(e.matrixWorld),t.position.copy(bg),_g.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(_g),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Hd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Hd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Ir||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Hd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},nc=new E,ic=new Rt,fi=new E,Ta=class extends kt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ie,this.projectionMatrix=new Ie,this.projectionMatrixInverse=new Ie,this.coordinateSystem=qn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(nc,ic,fi),fi.x===1&&fi.y===1&&fi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(nc,ic,fi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(nc,ic,fi),fi.x===1&&fi.y===1&&fi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(nc,ic,fi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ki=new E,wg=new ee,Mg=new ee,pn=class extends Ta{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Dr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ar*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Dr*2*Math.atan(Math.tan(Ar*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Ki.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ki.x,Ki.y).multiplyScalar(-e/Ki.z),Ki.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ki.x,Ki.y).multiplyScalar(-e/Ki.z)}getViewSize(e,t){return this.getViewBounds(e,wg,Mg),t.subVectors(Mg,wg)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ar*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ea=class extends Ta{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Qd=class extends Gc{constructor(){super(new Ea(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Aa=class extends Hr{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(kt.DEFAULT_UP),this.updateMatrix(),this.target=new kt,this.shadow=new Qd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},Ra=class extends Hr{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var Ca=class extends Ze{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Mr=-90,Sr=1,Wr=class extends kt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new pn(Mr,Sr,e,t);s.layers=this.layers,this.add(s);let r=new pn(Mr,Sr,e,t);r.layers=this.layers,this.add(r);let o=new pn(Mr,Sr,e,t);o.layers=this.layers,this.add(o);let a=new pn(Mr,Sr,e,t);a.layers=this.layers,this.add(a);let l=new pn(Mr,Sr,e,t);l.layers=this.layers,this.add(l);let c=new pn(Mr,Sr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===qn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Ir)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=x,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Hc=class extends pn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Of="\\[\\]\\.:\\/",g_=new RegExp("["+Of+"]","g"),Uf="[^"+Of+"]",x_="[^"+Of.replace("\\.","")+"]",y_=/((?:WC+[\/:])*)/.source.replace("WC",Uf),v_=/(WCOD+)?/.source.replace("WCOD",x_),b_=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Uf),__=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Uf),w_=new RegExp("^"+y_+v_+b_+__+"$"),M_=["material","materials","bones","map"],ef=class{constructor(e,t,n){let s=n||bt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},bt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(g_,"")}static parseTrackName(e){let t=w_.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);M_.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ne("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){ze("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){ze("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){ze("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){ze("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){ze("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){ze("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){ze("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;ze("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){ze("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){ze("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};bt.Composite=ef;bt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};bt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};bt.prototype.GetterByBindingType=[bt.prototype._getValue_direct,bt.prototype._getValue_array,bt.prototype._getValue_arrayElement,bt.prototype._getValue_toArray];bt.prototype.SetterByBindingTypeAndVersioning=[[bt.prototype._setValue_direct,bt.prototype._setValue_direct_setNeedsUpdate,bt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[bt.prototype._setValue_array,bt.prototype._setValue_array_setNeedsUpdate,bt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[bt.prototype._setValue_arrayElement,bt.prototype._setValue_arrayElement_setNeedsUpdate,bt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[bt.prototype._setValue_fromArray,bt.prototype._setValue_fromArray_setNeedsUpdate,bt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var rP=new Float32Array(1);var ss=class extends Or{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var $r=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=Ge(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(Ge(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var tf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}},Sg=new ee,Bs=class{constructor(e=new ee(1/0,1/0),t=new ee(-1/0,-1/0)){this.isBox2=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Sg.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=1/0,this.max.x=this.max.y=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y}getCenter(e){return this.isEmpty()?e.set(0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Sg).distanceTo(e)}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}},Tg=new E,sc=new E,Tr=new E,Er=new E,Wd=new E,S_=new E,T_=new E,Pa=class{constructor(e=new E,t=new E){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){Tg.subVectors(e,this.start),sc.subVectors(this.end,this.start);let n=sc.dot(sc);if(n===0)return 0;let r=sc.dot(Tg)/n;return t&&(r=Ge(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=S_,n=T_){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,h=e.end;Tr.subVectors(c,a),Er.subVectors(h,l),Wd.subVectors(a,l);let u=Tr.dot(Tr),d=Er.dot(Er),f=Er.dot(Wd);if(u<=s&&d<=s)return t.copy(a),n.copy(l),t.distanceToSquared(n);if(u<=s)r=0,o=f/d,o=Ge(o,0,1);else{let p=Tr.dot(Wd);if(d<=s)o=0,r=Ge(-p/u,0,1);else{let x=Tr.dot(Er),m=u*d-x*x;m!==0?r=Ge((x*f-p*d)/m,0,1):r=0,o=(x*r+f)/d,o<0?(o=0,r=Ge(-p/u,0,1)):o>1&&(o=1,r=Ge((x-p)/u,0,1))}}return t.copy(a).addScaledVector(Tr,r),n.copy(l).addScaledVector(Er,o),t.distanceToSquared(n)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Ia=class extends Br{constructor(e=10,t=10,n=4473924,s=8947848){n=new Ae(n),s=new Ae(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let d=0,f=0,p=-a;d<=t;d++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let x=d===r?n:s;x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3}let h=new Ze;h.setAttribute("position",new Pe(l,3)),h.setAttribute("color",new Pe(c,3));let u=new Ls({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var La=class extends ni{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Ff(i,e,t,n){let s=E_(n);switch(t){case _f:return i*e;case jc:return i*e/s.components*s.byteLength;case Kc:return i*e/s.components*s.byteLength;case ls:return i*e*2/s.components*s.byteLength;case Jc:return i*e*2/s.components*s.byteLength;case wf:return i*e*3/s.components*s.byteLength;case oi:return i*e*4/s.components*s.byteLength;case Qc:return i*e*4/s.components*s.byteLength;case ka:case Oa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Ua:case Fa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case th:case ih:return Math.max(i,16)*Math.max(e,8)/4;case eh:case nh:return Math.max(i,8)*Math.max(e,8)/2;case sh:case rh:case ah:case lh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case oh:case Ba:case ch:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case hh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case uh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case dh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case fh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ph:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case mh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case gh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case xh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case yh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case vh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case bh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case _h:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case wh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Mh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Sh:case Th:case Eh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Ah:case Rh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case za:case Ch:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function E_(i){switch(i){case En:case xf:return{byteLength:1,components:1};case Zr:case yf:case ri:return{byteLength:2,components:1};case Yc:case Zc:return{byteLength:2,components:4};case si:case qc:case Zn:return{byteLength:4,components:1};case vf:case bf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ne("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function U0(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function I_(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],x=u[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let x=u[f];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var L_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,D_=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,N_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,k_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,O_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,U_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,F_=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,B_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,z_=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,V_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,G_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,H_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,W_=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,$_=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,X_=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,q_=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Y_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Z_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,j_=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,K_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,J_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Q_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,ew=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,tw=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,nw=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,iw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,sw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,rw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ow=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,aw="gl_FragColor = linearToOutputTexel( gl_FragColor );",lw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,cw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,hw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,uw=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,dw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,fw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,pw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,mw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,gw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,xw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,yw=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,vw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,bw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,_w=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,ww=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Mw=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Sw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Tw=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Ew=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Aw=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Rw=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Cw=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Pw=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Iw=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Lw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Dw=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Nw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,kw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ow=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Uw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Fw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Bw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,zw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Vw=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Gw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Hw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Ww=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,$w=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Xw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,qw=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Yw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Zw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,jw=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Kw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Jw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Qw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,eM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,tM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,nM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,iM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,sM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,rM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,oM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,aM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,lM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,cM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,hM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,uM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,dM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,fM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,pM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,mM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,gM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,xM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,yM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,vM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,bM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,_M=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,wM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,MM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,SM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,TM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,EM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,AM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,RM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,CM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,PM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,IM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,LM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,DM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,NM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,kM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,OM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,UM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,FM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,BM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,zM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,VM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,GM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,HM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,WM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,$M=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,XM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,qM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,YM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ZM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,jM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,KM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,JM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,QM=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,eS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,tS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,nS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,iS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,sS=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,rS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,oS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,aS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,lS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,cS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,hS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Qe={alphahash_fragment:L_,alphahash_pars_fragment:D_,alphamap_fragment:N_,alphamap_pars_fragment:k_,alphatest_fragment:O_,alphatest_pars_fragment:U_,aomap_fragment:F_,aomap_pars_fragment:B_,batching_pars_vertex:z_,batching_vertex:V_,begin_vertex:G_,beginnormal_vertex:H_,bsdfs:W_,iridescence_fragment:$_,bumpmap_pars_fragment:X_,clipping_planes_fragment:q_,clipping_planes_pars_fragment:Y_,clipping_planes_pars_vertex:Z_,clipping_planes_vertex:j_,color_fragment:K_,color_pars_fragment:J_,color_pars_vertex:Q_,color_vertex:ew,common:tw,defaultnormal_vertex:nw,displacementmap_pars_vertex:iw,displacementmap_vertex:sw,emissivemap_fragment:rw,emissivemap_pars_fragment:ow,colorspace_fragment:aw,colorspace_pars_fragment:lw,envmap_fragment:cw,envmap_common_pars_fragment:hw,envmap_pars_fragment:uw,envmap_pars_vertex:dw,envmap_physical_pars_fragment:Mw,envmap_vertex:fw,fog_vertex:pw,fog_pars_vertex:mw,fog_fragment:gw,fog_pars_fragment:xw,gradientmap_pars_fragment:yw,lightmap_pars_fragment:vw,lights_lambert_fragment:bw,lights_lambert_pars_fragment:_w,lights_pars_begin:ww,lights_toon_fragment:Sw,lights_toon_pars_fragment:Tw,lights_phong_fragment:Ew,lights_phong_pars_fragment:Aw,lights_physical_fragment:Rw,lights_physical_pars_fragment:Cw,lights_fragment_begin:Pw,lights_fragment_maps:Iw,lights_fragment_end:Lw,lightprobes_pars_fragment:Dw,logdepthbuf_fragment:Nw,logdepthbuf_pars_fragment:kw,logdepthbuf_pars_vertex:Ow,logdepthbuf_vertex:Uw,map_fragment:Fw,map_pars_fragment:Bw,map_particle_fragment:zw,map_particle_pars_fragment:Vw,metalnessmap_fragment:Gw,metalnessmap_pars_fragment:Hw,morphinstance_vertex:Ww,morphcolor_vertex:$w,morphnormal_vertex:Xw,morphtarget_pars_vertex:qw,morphtarget_vertex:Yw,normal_fragment_begin:Zw,normal_fragment_maps:jw,normal_pars_fragment:Kw,normal_pars_vertex:Jw,normal_vertex:Qw,normalmap_pars_fragment:eM,clearcoat_normal_fragment_begin:tM,clearcoat_normal_fragment_maps:nM,clearcoat_pars_fragment:iM,iridescence_pars_fragment:sM,opaque_fragment:rM,packing:oM,premultiplied_alpha_fragment:aM,project_vertex:lM,dithering_fragment:cM,dithering_pars_fragment:hM,roughnessmap_fragment:uM,roughnessmap_pars_fragment:dM,shadowmap_pars_fragment:fM,shadowmap_pars_vertex:pM,shadowmap_vertex:mM,shadowmask_pars_fragment:gM,skinbase_vertex:xM,skinning_pars_vertex:yM,skinning_vertex:vM,skinnormal_vertex:bM,specularmap_fragment:_M,specularmap_pars_fragment:wM,tonemapping_fragment:MM,tonemapping_pars_fragment:SM,transmission_fragment:TM,transmission_pars_fragment:EM,uv_pars_fragment:AM,uv_pars_vertex:RM,uv_vertex:CM,worldpos_vertex:PM,background_vert:IM,background_frag:LM,backgroundCube_vert:DM,backgroundCube_frag:NM,cube_vert:kM,cube_frag:OM,depth_vert:UM,depth_frag:FM,distance_vert:BM,distance_frag:zM,equirect_vert:VM,equirect_frag:GM,linedashed_vert:HM,linedashed_frag:WM,meshbasic_vert:$M,meshbasic_frag:XM,meshlambert_vert:qM,meshlambert_frag:YM,meshmatcap_vert:ZM,meshmatcap_frag:jM,meshnormal_vert:KM,meshnormal_frag:JM,meshphong_vert:QM,meshphong_frag:eS,meshphysical_vert:tS,meshphysical_frag:nS,meshtoon_vert:iS,meshtoon_frag:sS,points_vert:rS,points_frag:oS,shadow_vert:aS,shadow_frag:lS,sprite_vert:cS,sprite_frag:hS},pe={common:{diffuse:{value:new Ae(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new He},alphaMap:{value:null},alphaMapTransform:{value:new He},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new He}},envmap:{envMap:{value:null},envMapRotation:{value:new He},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new He}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new He}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new He},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new He},normalScale:{value:new ee(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new He},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new He}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new He}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new He}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ae(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ae(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new He},alphaTest:{value:0},uvTransform:{value:new He}},sprite:{diffuse:{value:new Ae(16777215)},opacity:{value:1},center:{value:new ee(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new He},alphaMap:{value:null},alphaMapTransform:{value:new He},alphaTest:{value:0}}},vn={basic:{uniforms:cn([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.fog]),vertexShader:Qe.meshbasic_vert,fragmentShader:Qe.meshbasic_frag},lambert:{uniforms:cn([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,pe.lights,{emissive:{value:new Ae(0)},envMapIntensity:{value:1}}]),vertexShader:Qe.meshlambert_vert,fragmentShader:Qe.meshlambert_frag},phong:{uniforms:cn([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,pe.lights,{emissive:{value:new Ae(0)},specular:{value:new Ae(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Qe.meshphong_vert,fragmentShader:Qe.meshphong_frag},standard:{uniforms:cn([pe.common,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.roughnessmap,pe.metalnessmap,pe.fog,pe.lights,{emissive:{value:new Ae(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Qe.meshphysical_vert,fragmentShader:Qe.meshphysical_frag},toon:{uniforms:cn([pe.common,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.gradientmap,pe.fog,pe.lights,{emissive:{value:new Ae(0)}}]),vertexShader:Qe.meshtoon_vert,fragmentShader:Qe.meshtoon_frag},matcap:{uniforms:cn([pe.common,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,{matcap:{value:null}}]),vertexShader:Qe.meshmatcap_vert,fragmentShader:Qe.meshmatcap_frag},points:{uniforms:cn([pe.points,pe.fog]),vertexShader:Qe.points_vert,fragmentShader:Qe.points_frag},dashed:{uniforms:cn([pe.common,pe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Qe.linedashed_vert,fragmentShader:Qe.linedashed_frag},depth:{uniforms:cn([pe.common,pe.displacementmap]),vertexShader:Qe.depth_vert,fragmentShader:Qe.depth_frag},normal:{uniforms:cn([pe.common,pe.bumpmap,pe.normalmap,pe.displacementmap,{opacity:{value:1}}]),vertexShader:Qe.meshnormal_vert,fragmentShader:Qe.meshnormal_frag},sprite:{uniforms:cn([pe.sprite,pe.fog]),vertexShader:Qe.sprite_vert,fragmentShader:Qe.sprite_frag},background:{uniforms:{uvTransform:{value:new He},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Qe.background_vert,fragmentShader:Qe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new He}},vertexShader:Qe.backgroundCube_vert,fragmentShader:Qe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Qe.cube_vert,fragmentShader:Qe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Qe.equirect_vert,fragmentShader:Qe.equirect_frag},distance:{uniforms:cn([pe.common,pe.displacementmap,{referencePosition:{value:new E},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Qe.distance_vert,fragmentShader:Qe.distance_frag},shadow:{uniforms:cn([pe.lights,pe.fog,{color:{value:new Ae(0)},opacity:{value:1}}]),vertexShader:Qe.shadow_vert,fragmentShader:Qe.shadow_frag}};vn.physical={uniforms:cn([vn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new He},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new He},clearcoatNormalScale:{value:new ee(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new He},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new He},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new He},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new He},sheen:{value:0},sheenColor:{value:new Ae(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new He},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new He},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new He},transmissionSamplerSize:{value:new ee},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new He},attenuationDistance:{value:0},attenuationColor:{value:new Ae(0)},specularColor:{value:new Ae(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new He},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new He},anisotropyVector:{value:new ee},anisotropyMap:{value:null},anisotropyMapTransform:{value:new He}}]),vertexShader:Qe.meshphysical_vert,fragmentShader:Qe.meshphysical_frag};var Ih={r:0,b:0,g:0},uS=new Ie,F0=new He;F0.set(-1,0,0,0,1,0,0,0,1);function dS(i,e,t,n,s,r){let o=new Ae(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(y){let S=y.isScene===!0?y.background:null;if(S&&S.isTexture){let b=y.backgroundBlurriness>0;S=e.get(S,b)}return S}function p(y){let S=!1,b=f(y);b===null?m(o,a):b&&b.isColor&&(m(b,1),S=!0);let A=i.xr.getEnvironmentBlendMode();A==="additive"?t.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||S)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(y,S){let b=f(S);b&&b.isCubeTexture?(c===void 0&&(c=new ot(new kn(1,1,1),new Yn({name:"BackgroundCubeMaterial",uniforms:$s(vn.backgroundCube.uniforms),vertexShader:vn.backgroundCube.vertexShader,fragmentShader:vn.backgroundCube.fragmentShader,side:xn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,R,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(uS.makeRotationFromEuler(S.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(F0),c.material.toneMapped=it.getTransfer(b.colorSpace)!==ht,(h!==b||u!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new ot(new Os(2,2),new Yn({name:"BackgroundMaterial",uniforms:$s(vn.background.uniforms),vertexShader:vn.background.vertexShader,fragmentShader:vn.background.fragmentShader,side:as,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.toneMapped=it.getTransfer(b.colorSpace)!==ht,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,S){y.getRGB(Ih,kf(i)),t.buffers.color.setClear(Ih.r,Ih.g,Ih.b,S,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,S=1){o.set(y),a=S,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,m(o,a)},render:p,addToRenderList:x,dispose:g}}function fS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(k,O,V,I,G){let $=!1,H=u(k,I,V,O);r!==H&&(r=H,c(r.object)),$=f(k,I,V,G),$&&p(k,I,V,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,b(k,O,V,I),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return i.createVertexArray()}function c(k){return i.bindVertexArray(k)}function h(k){return i.deleteVertexArray(k)}function u(k,O,V,I){let G=I.wireframe===!0,$=n[O.id];$===void 0&&($={},n[O.id]=$);let H=k.isInstancedMesh===!0?k.id:0,ne=$[H];ne===void 0&&(ne={},$[H]=ne);let X=ne[V.id];X===void 0&&(X={},ne[V.id]=X);let Q=X[G];return Q===void 0&&(Q=d(l()),X[G]=Q),Q}function d(k){let O=[],V=[],I=[];for(let G=0;G<t;G++)O[G]=0,V[G]=0,I[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:V,attributeDivisors:I,object:k,attributes:{},index:null}}function f(k,O,V,I){let G=r.attributes,$=O.attributes,H=0,ne=V.getAttributes();for(let X in ne)if(ne[X].location>=0){let te=G[X],we=$[X];if(we===void 0&&(X==="instanceMatrix"&&k.instanceMatrix&&(we=k.instanceMatrix),X==="instanceColor"&&k.instanceColor&&(we=k.instanceColor)),te===void 0||te.attribute!==we||we&&te.data!==we.data)return!0;H++}return r.attributesNum!==H||r.index!==I}function p(k,O,V,I){let G={},$=O.attributes,H=0,ne=V.getAttributes();for(let X in ne)if(ne[X].location>=0){let te=$[X];te===void 0&&(X==="instanceMatrix"&&k.instanceMatrix&&(te=k.instanceMatrix),X==="instanceColor"&&k.instanceColor&&(te=k.instanceColor));let we={};we.attribute=te,te&&te.data&&(we.data=te.data),G[X]=we,H++}r.attributes=G,r.attributesNum=H,r.index=I}function x(){let k=r.newAttributes;for(let O=0,V=k.length;O<V;O++)k[O]=0}function m(k){g(k,0)}function g(k,O){let V=r.newAttributes,I=r.enabledAttributes,G=r.attributeDivisors;V[k]=1,I[k]===0&&(i.enableVertexAttribArray(k),I[k]=1),G[k]!==O&&(i.vertexAttribDivisor(k,O),G[k]=O)}function y(){let k=r.newAttributes,O=r.enabledAttributes;for(let V=0,I=O.length;V<I;V++)O[V]!==k[V]&&(i.disableVertexAttribArray(V),O[V]=0)}function S(k,O,V,I,G,$,H){H===!0?i.vertexAttribIPointer(k,O,V,G,$):i.vertexAttribPointer(k,O,V,I,G,$)}function b(k,O,V,I){x();let G=I.attributes,$=V.getAttributes(),H=O.defaultAttributeValues;for(let ne in $){let X=$[ne];if(X.location>=0){let Q=G[ne];if(Q===void 0&&(ne==="instanceMatrix"&&k.instanceMatrix&&(Q=k.instanceMatrix),ne==="instanceColor"&&k.instanceColor&&(Q=k.instanceColor)),Q!==void 0){let te=Q.normalized,we=Q.itemSize,Be=e.get(Q);if(Be===void 0)continue;let Z=Be.buffer,xe=Be.type,Se=Be.bytesPerElement,ke=xe===i.INT||xe===i.UNSIGNED_INT||Q.gpuType===qc;if(Q.isInterleavedBufferAttribute){let ve=Q.data,Ye=ve.isInterleavedBuffer===!0?ve.stride:ve.itemSize,Pt=Q.offset;if(ve.isInstancedInterleavedBuffer||ve.isInstancedBufferAttribute){for(let Ue=0;Ue<X.locationSize;Ue++)g(X.location+Ue,ve.meshPerAttribute);k.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ve.meshPerAttribute*ve.count)}else for(let Ue=0;Ue<X.locationSize;Ue++)m(X.location+Ue);i.bindBuffer(i.ARRAY_BUFFER,Z);for(let Ue=0;Ue<X.locationSize;Ue++)S(X.location+Ue,we/X.locationSize,xe,te,Ye*Se,(Pt+we/X.locationSize*Ue)*Se,ke)}else{if(Q.isInstancedBufferAttribute){for(let ve=0;ve<X.locationSize;ve++)g(X.location+ve,Q.meshPerAttribute);k.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let ve=0;ve<X.locationSize;ve++)m(X.location+ve);i.bindBuffer(i.ARRAY_BUFFER,Z);for(let ve=0;ve<X.locationSize;ve++)S(X.location+ve,we/X.locationSize,xe,te,we*Se,we/X.locationSize*ve*Se,ke)}}else if(H!==void 0){let te=H[ne];if(te!==void 0)switch(te.length){case 2:i.vertexAttrib2fv(X.location,te);break;case 3:i.vertexAttrib3fv(X.location,te);break;case 4:i.vertexAttrib4fv(X.location,te);break;default:i.vertexAttrib1fv(X.location,te)}}}}y()}function A(){D();for(let k in n){let O=n[k];for(let V in O){let I=O[V];for(let G in I){let $=I[G];for(let H in $)h($[H].object),delete $[H];delete I[G]}}delete n[k]}}function R(k){if(n[k.id]===void 0)return;let O=n[k.id];for(let V in O){let I=O[V];for(let G in I){let $=I[G];for(let H in $)h($[H].object),delete $[H];delete I[G]}}delete n[k.id]}function v(k){for(let O in n){let V=n[O];for(let I in V){let G=V[I];if(G[k.id]===void 0)continue;let $=G[k.id];for(let H in $)h($[H].object),delete $[H];delete G[k.id]}}}function T(k){for(let O in n){let V=n[O],I=k.isInstancedMesh===!0?k.id:0,G=V[I];if(G!==void 0){for(let $ in G){let H=G[$];for(let ne in H)h(H[ne].object),delete H[ne];delete G[$]}delete V[I],Object.keys(V).length===0&&delete n[O]}}}function D(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:P,dispose:A,releaseStatesOfGeometry:R,releaseStatesOfObject:T,releaseStatesOfProgram:v,initAttributes:x,enableAttribute:m,disableUnusedAttributes:y}}function pS(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function mS(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==oi&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let T=v===ri&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==En&&v!==Zn&&!T&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ne("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ne("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ne("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),A=i.getParameter(i.MAX_SAMPLES),R=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:y,maxVaryings:S,maxFragmentUniforms:b,maxSamples:A,samples:R}}function gS(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Dn,a=new He,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,x=u.clipIntersection,m=u.clipShadows,g=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let y=r?0:n,S=y*4,b=g.clippingState||null;l.value=b,b=h(p,d,S,f);for(let A=0;A!==S;++A)b[A]=t[A];g.clippingState=b,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,p){let x=u!==null?u.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=f+x*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<g)&&(m=new Float32Array(g));for(let S=0,b=f;S!==x;++S,b+=4)o.copy(u[S]).applyMatrix4(y,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,m}}var Wa=class extends Nn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new ra(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new kn(5,5,5),r=new Yn({name:"CubemapFromEquirect",uniforms:$s(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:xn,blending:Vs});r.uniforms.tEquirect.value=t;let o=new ot(s,r),a=t.minFilter;return t.minFilter===Ui&&(t.minFilter=mn),new Wr(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},g0=256,xS=3,yS=20,B0=256,z0=16,vS=3,bS=new E,_S=new Ae,Dh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Wr(1,10,null),this._boxMesh=new ot(new kn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=bS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(_S));let m=new Wr(n,s,h);return m.position.copy(a),m.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,e.background=x,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=v0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=y0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(g0,If(e))}_fromTexture(e,t){e.mapping===Hs||e.mapping===Yr?this._setSize(e.image.length===0?g0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=x0(e,!1,!1),n=Math.log2(e)-xS;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=x0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Hs||e.mapping===Yr?(this._cubemapMaterial===null&&(this._cubemapMaterial=v0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=y0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=wS(),this._integrationMaterial=MS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/z0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-vS)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(B0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=SS());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function x0(i,e,t){return new Wa(i,{minFilter:Ui,generateMipmaps:e,type:ri,colorSpace:Xo,depthBuffer:t})}function $a(i,e,t){return new Yn({name:i,uniforms:e,vertexShader:Qe.cube_vert,fragmentShader:t,side:xn,blending:Vs,depthTest:!1,depthWrite:!1})}function wS(){return $a("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${B0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function MS(){return $a("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:z0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function SS(){return $a("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${yS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function y0(){return $a("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function v0(){return $a("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function TS(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Wc||f===$c)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new Wa(p.height);return x.fromEquirectangularTexture(i,d),e.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Wc||f===$c,x=f===Hs||f===Yr;if(p||x){let m=t.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return n===null&&(n=new Dh(i)),m=p?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let y=d.image;return p&&y&&y.height>0||x&&y&&l(y)?(n===null&&(n=new Dh(i)),m=p?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===Wc?d.mapping=Hs:f===$c&&(d.mapping=Yr),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function ES(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Vo("WebGLRenderer: "+n+" extension not supported."),s}}}function AS(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(e.remove(x),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function h(p){let x=p.attributes;for(let m in x)e.update(x[m],i.ARRAY_BUFFER)}function u(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let y=x!==null?x.array.length:m.array.length/3-1,S=m.count>=65535?ea:Qo,b=new S(Math.ceil(y/3)*6,1),A=b.array;if(x!==null){let v=x.array;g=x.version;for(let T=0,D=0;T<y;T+=3){let P=v[T+0],k=v[T+1],O=v[T+2];A[D++]=P,A[D++]=k,A[D++]=k,A[D++]=O,A[D++]=O,A[D++]=P}}else{g=m.version;for(let v=0,T=0;v<y;v+=3){let D=v+0,P=v+1,k=v+2;A[T++]=D,A[T++]=P,A[T++]=P,A[T++]=k,A[T++]=k,A[T++]=D}}b.version=g;let R=r.get(p);R&&e.remove(R),r.set(p,b)}function d(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function RS(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let x=0;for(let m=0;m<f;m++)x+=d[m];t.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function CS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:ze("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function PS(i,e,t){let n=new WeakMap,s=new ut;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let D=function(){v.dispose(),n.delete(a),a.removeEventListener("dispose",D)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],S=0;f===!0&&(S=1),p===!0&&(S=2),x===!0&&(S=3);let b=a.attributes.position.count*S,A=1;b>e.maxTextureSize&&(A=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let R=new Float32Array(b*A*4*u),v=new jo(R,b,A,u);v.type=Zn,v.needsUpdate=!0;let T=S*4;for(let P=0;P<u;P++){let k=m[P],O=g[P],V=y[P],I=b*A*4*P;for(let G=0;G<k.count;G++){let $=G*T;f===!0&&(s.fromBufferAttribute(k,G),R[I+$+0]=s.x,R[I+$+1]=s.y,R[I+$+2]=s.z,R[I+$+3]=0),p===!0&&(s.fromBufferAttribute(O,G),R[I+$+4]=s.x,R[I+$+5]=s.y,R[I+$+6]=s.z,R[I+$+7]=0),x===!0&&(s.fromBufferAttribute(V,G),R[I+$+8]=s.x,R[I+$+9]=s.y,R[I+$+10]=s.z,R[I+$+11]=V.itemSize===4?s.w:1)}}d={count:u,texture:v,size:new ee(b,A)},n.set(a,d),a.addEventListener("dispose",D)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function IS(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var LS={[cf]:"LINEAR_TONE_MAPPING",[hf]:"REINHARD_TONE_MAPPING",[uf]:"CINEON_TONE_MAPPING",[df]:"ACES_FILMIC_TONE_MAPPING",[pf]:"AGX_TONE_MAPPING",[mf]:"NEUTRAL_TONE_MAPPING",[ff]:"CUSTOM_TONE_MAPPING"};function DS(i,e,t,n,s,r){let o=new Nn(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Ze;h.setAttribute("position",new Pe([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Pe([0,2,0,0,2,0],2));let u=new Cc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new ot(h,u),f=new Ea(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,y=null,S=[],b=!1;this.setSize=function(A,R){o.setSize(A,R),a!==null&&a.setSize(A,R),l!==null&&l.setSize(A,R);for(let v=0;v<S.length;v++){let T=S[v];T.setSize&&T.setSize(A,R)}},this.setEffects=function(A){S=A,b=S.length>0&&S[0].isRenderPass===!0;let R=o.width,v=o.height;S.length>0&&a===null&&(a=new Nn(R,v,{type:ri,depthBuffer:!1,stencilBuffer:!1}),l=new Nn(R,v,{type:ri,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&S.some(D=>D.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Ni(R,v),r===!0&&(c.format=Fi,c.type=Ws)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let D=0;D<S.length;D++){let P=S[D];P.setSize&&P.setSize(R,v),T&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(A,R){if(m||A.toneMapping===xi&&S.length===0)return!1;if(y=R,R!==null){let v=R.width,T=R.height;(o.width!==v||o.height!==T)&&this.setSize(v,T)}return b===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=xi,!0},this.hasRenderPass=function(){return b},this.end=function(A,R){A.toneMapping=g,m=!0;let v=o,T=a;for(let D=0;D<S.length;D++){let P=S[D];P.enabled!==!1&&(P.render(A,T,v,R),P.needsSwap!==!1&&(v=T,T=T===a?l:a))}if(p!==A.outputColorSpace||x!==A.toneMapping){p=A.outputColorSpace,x=A.toneMapping,u.defines={},it.getTransfer(p)===ht&&(u.defines.SRGB_TRANSFER="");let D=LS[x];D&&(u.defines[D]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=v.texture,A.setRenderTarget(y),A.render(d,f),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var V0=new gn,G0=new Ni(1,1),H0=new aa(1),W0=new jo,$0=new yc,X0=new ra,b0=[],_0=[],w0=new Float32Array(16),M0=new Float32Array(9),S0=new Float32Array(4);function Qr(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=b0[s];if(r===void 0&&(r=new Float32Array(s),b0[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Ot(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Ut(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function kh(i,e){let t=_0[e];t===void 0&&(t=new Int32Array(e),_0[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function NS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function kS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ot(t,e))return;i.uniform2fv(this.addr,e),Ut(t,e)}}function OS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Ot(t,e))return;i.uniform3fv(this.addr,e),Ut(t,e)}}function US(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ot(t,e))return;i.uniform4fv(this.addr,e),Ut(t,e)}}function FS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Ot(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Ut(t,e)}else{if(Ot(t,n))return;S0.set(n),i.uniformMatrix2fv(this.addr,!1,S0),Ut(t,n)}}function BS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Ot(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Ut(t,e)}else{if(Ot(t,n))return;M0.set(n),i.uniformMatrix3fv(this.addr,!1,M0),Ut(t,n)}}function zS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Ot(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Ut(t,e)}else{if(Ot(t,n))return;w0.set(n),i.uniformMatrix4fv(this.addr,!1,w0),Ut(t,n)}}function VS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function GS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ot(t,e))return;i.uniform2iv(this.addr,e),Ut(t,e)}}function HS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ot(t,e))return;i.uniform3iv(this.addr,e),Ut(t,e)}}function WS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ot(t,e))return;i.uniform4iv(this.addr,e),Ut(t,e)}}function $S(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function XS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ot(t,e))return;i.uniform2uiv(this.addr,e),Ut(t,e)}}function qS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ot(t,e))return;i.uniform3uiv(this.addr,e),Ut(t,e)}}function YS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ot(t,e))return;i.uniform4uiv(this.addr,e),Ut(t,e)}}function Oh(i){return i.version===0&&(i.compareFunction=Af,i.needsUpdate=!0),i}function ZS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Oh(G0):r=V0,t.setTexture2D(e||r,s)}function jS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||$0,s)}function KS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Oh(H0):r=X0,t.setTextureCube(e||r,s)}function JS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||W0,s)}function QS(i){switch(i){case 5126:return NS;case 35664:return kS;case 35665:return OS;case 35666:return US;case 35674:return FS;case 35675:return BS;case 35676:return zS;case 5124:case 35670:return VS;case 35667:case 35671:return GS;case 35668:case 35672:return HS;case 35669:case 35673:return WS;case 5125:return $S;case 36294:return XS;case 36295:return qS;case 36296:return YS;case 35678:case 36198:case 36298:case 36306:case 35682:return ZS;case 35679:case 36299:case 36307:return jS;case 35680:case 36300:case 36308:case 36293:return KS;case 36289:case 36303:case 36311:case 36292:return JS}}function e1(i,e){i.uniform1fv(this.addr,e)}function t1(i,e){let t=Qr(e,this.size,2);i.uniform2fv(this.addr,t)}function n1(i,e){let t=Qr(e,this.size,3);i.uniform3fv(this.addr,t)}function i1(i,e){let t=Qr(e,this.size,4);i.uniform4fv(this.addr,t)}function s1(i,e){let t=Qr(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function r1(i,e){let t=Qr(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function o1(i,e){let t=Qr(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function a1(i,e){i.uniform1iv(this.addr,e)}function l1(i,e){i.uniform2iv(this.addr,e)}function c1(i,e){i.uniform3iv(this.addr,e)}function h1(i,e){i.uniform4iv(this.addr,e)}function u1(i,e){i.uniform1uiv(this.addr,e)}function d1(i,e){i.uniform2uiv(this.addr,e)}function f1(i,e){i.uniform3uiv(this.addr,e)}function p1(i,e){i.uniform4uiv(this.addr,e)}function m1(i,e,t){let n=this.cache,s=e.length,r=kh(t,s);Ot(n,r)||(i.uniform1iv(this.addr,r),Ut(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Oh(G0):o=V0;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function g1(i,e,t){let n=this.cache,s=e.length,r=kh(t,s);Ot(n,r)||(i.uniform1iv(this.addr,r),Ut(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||$0,r[o])}function x1(i,e,t){let n=this.cache,s=e.length,r=kh(t,s);Ot(n,r)||(i.uniform1iv(this.addr,r),Ut(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Oh(H0):o=X0;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function y1(i,e,t){let n=this.cache,s=e.length,r=kh(t,s);Ot(n,r)||(i.uniform1iv(this.addr,r),Ut(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||W0,r[o])}function v1(i){switch(i){case 5126:return e1;case 35664:return t1;case 35665:return n1;case 35666:return i1;case 35674:return s1;case 35675:return r1;case 35676:return o1;case 5124:case 35670:return a1;case 35667:case 35671:return l1;case 35668:case 35672:return c1;case 35669:case 35673:return h1;case 5125:return u1;case 36294:return d1;case 36295:return f1;case 36296:return p1;case 35678:case 36198:case 36298:case 36306:case 35682:return m1;case 35679:case 36299:case 36307:return g1;case 35680:case 36300:case 36308:case 36293:return x1;case 36289:case 36303:case 36311:case 36292:return y1}}var Vf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=QS(t.type)}},Gf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=v1(t.type)}},Hf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Bf=/(\w+)(\])?(\[|\.)?/g;function T0(i,e){i.seq.push(e),i.map[e.id]=e}function b1(i,e,t){let n=i.name,s=n.length;for(Bf.lastIndex=0;;){let r=Bf.exec(n),o=Bf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){T0(t,c===void 0?new Vf(a,i,e):new Gf(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Hf(a),T0(t,u)),t=u}}}var Jr=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);b1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function E0(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var _1=37297,w1=0;function M1(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var A0=new He;function S1(i){it._getMatrix(A0,it.workingColorSpace,i);let e=`mat3( ${A0.elements.map(t=>t.toFixed(4))} )`;switch(it.getTransfer(i)){case qo:return[e,"LinearTransferOETF"];case ht:return[e,"sRGBTransferOETF"];default:return Ne("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function R0(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+M1(i.getShaderSource(e),a)}else return r}function T1(i,e){let t=S1(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var E1={[cf]:"Linear",[hf]:"Reinhard",[uf]:"Cineon",[df]:"ACESFilmic",[pf]:"AgX",[mf]:"Neutral",[ff]:"Custom"};function A1(i,e){let t=E1[e];return t===void 0?(Ne("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Lh=new E;function R1(){it.getLuminanceCoefficients(Lh);let i=Lh.x.toFixed(4),e=Lh.y.toFixed(4),t=Lh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function C1(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ha).join(`
`)}function P1(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function I1(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Ha(i){return i!==""}function C0(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function P0(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var L1=/^[ \t]*#include +<([\w\d./]+)>/gm;function Wf(i){return i.replace(L1,D1)}function D1(i,e){let t=Qe[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Wf(t)}var N1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function I0(i){return i.replace(N1,k1)}function k1(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function L0(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var O1={[zs]:"SHADOWMAP_TYPE_PCF",[Xr]:"SHADOWMAP_TYPE_VSM"};function U1(i){return O1[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var F1={[Yr]:"ENVMAP_MODE_REFRACTION"};function B1(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":F1[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var z1={[Da]:"ENVMAP_BLENDING_MULTIPLY",[qg]:"ENVMAP_BLENDING_MIX",[Yg]:"ENVMAP_BLENDING_ADD"};function V1(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":z1[i.combine]||"ENVMAP_BLENDING_NONE"}function G1(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=U1(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=B1(t),u=V1(t),d=C1(t),f=P1(r),p=s.createProgram(),x,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ha).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ha).join(`
`),m.length>0&&(m+=`
`)):(x=[L0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ha).join(`
`),m=[L0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==xi?"#define TONE_MAPPING":"",t.toneMapping!==xi?Qe.tonemapping_pars_fragment:"",t.toneMapping!==xi?A1("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",Qe.colorspace_pars_fragment,T1("linearToOutputTexel",t.outputColorSpace),R1(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ha).join(`
`)),o=Wf(o),o=C0(o,t),o=P0(o,t),a=Wf(a),a=C0(a,t),a=P0(a,t),o=I0(o),a=I0(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",t.glslVersion===Cf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Cf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=g+x+o,S=g+m+a,b=E0(s,s.VERTEX_SHADER,y),A=E0(s,s.FRAGMENT_SHADER,S);s.attachShader(p,b),s.attachShader(p,A),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function R(P){if(i.debug.checkShaderErrors){let k=s.getProgramInfoLog(p)||"",O=s.getShaderInfoLog(b)||"",V=s.getShaderInfoLog(A)||"",I=k.trim(),G=O.trim(),$=V.trim(),H=!0,ne=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,b,A);else{let X=R0(s,b,"vertex"),Q=R0(s,A,"fragment");ze("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+I+`
`+X+`
`+Q)}else I!==""?Ne("WebGLProgram: Program Info Log:",I):(G===""||$==="")&&(ne=!1);ne&&(P.diagnostics={runnable:H,programLog:I,vertexShader:{log:G,prefix:x},fragmentShader:{log:$,prefix:m}})}s.deleteShader(b),s.deleteShader(A),v=new Jr(s,p),T=I1(s,p)}let v;this.getUniforms=function(){return v===void 0&&R(this),v};let T;this.getAttributes=function(){return T===void 0&&R(this),T};let D=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(p,_1)),D},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=w1++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=A,this}var H1=0,$f=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Xf(e),t.set(e,n)),n}},Xf=class{constructor(e){this.id=H1++,this.code=e,this.usedTimes=0}};function W1(i){return i===ls||i===Ba||i===za}function $1(i,e,t,n,s,r){let o=new Ko,a=new $f,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,T,D,P,k,O){let V=P.fog,I=k.geometry,G=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?P.environment:null,$=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,H=e.get(v.envMap||G,$),ne=d[v.type],X=n.precision;v.precision!==null&&(X=n.getMaxPrecision(v.precision),X!==v.precision&&Ne("WebGLProgram.getParameters:",v.precision,"not supported, using",X,"instead."));let Q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,te=Q!==void 0?Q.length:0,we=0;I.morphAttributes.position!==void 0&&(we=1),I.morphAttributes.normal!==void 0&&(we=2),I.morphAttributes.color!==void 0&&(we=3);let Be,Z,xe,Se;if(ne){let ge=vn[ne];Be=ge.vertexShader,Z=ge.fragmentShader}else{Be=v.vertexShader,Z=v.fragmentShader;let ge=a.getVertexShaderStage(v),ft=a.getFragmentShaderStage(v);a.update(v,ge,ft),xe=ge.id,Se=ft.id}let ke=i.getRenderTarget(),ve=i.state.buffers.depth.getReversed(),Ye=k.isInstancedMesh===!0,Pt=k.isBatchedMesh===!0,Ue=!!v.map,dt=!!v.matcap,gt=!!H,et=gt&&H.isPMREMTexture===!0,Xt=!!v.aoMap,Dt=!!v.lightMap,wn=!!v.bumpMap&&v.wireframe===!1,Mt=!!v.normalMap,ci=!!v.displacementMap,Bt=!!v.emissiveMap,Vn=!!v.metalnessMap,Gn=!!v.roughnessMap,Hn=v.anisotropy>0,U=v.clearcoat>0,Wn=v.diffuseRoughness>0,_t=v.dispersion>0,wt=v.retroreflectivity>0,me=v.iridescence>0,Nt=v.sheen>0,Oe=v.transmission>0,We=Hn&&!!v.anisotropyMap,C=U&&!!v.clearcoatMap,w=U&&!!v.clearcoatNormalMap,B=U&&!!v.clearcoatRoughnessMap,se=Wn&&!!v.diffuseRoughnessMap,J=me&&!!v.iridescenceMap,ae=me&&!!v.iridescenceThicknessMap,de=Nt&&!!v.sheenColorMap,Y=Nt&&!!v.sheenRoughnessMap,j=!!v.specularMap,ce=!!v.specularColorMap,L=!!v.specularIntensityMap,K=Oe&&!!v.transmissionMap,q=Oe&&!!v.thicknessMap,he=!!v.gradientMap,oe=!!v.alphaMap,le=v.alphaTest>0,Ce=!!v.alphaHash,Ke=!!v.extensions,re=xi;v.toneMapped&&(ke===null||ke.isXRRenderTarget===!0)&&(re=i.toneMapping);let Le=et?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,je={shaderID:ne,shaderType:v.type,shaderName:v.name,vertexShader:Be,fragmentShader:Z,defines:v.defines,customVertexShaderID:xe,customFragmentShaderID:Se,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:X,batching:Pt,batchingColor:Pt&&k._colorsTexture!==null,instancing:Ye,instancingColor:Ye&&k.instanceColor!==null,instancingMorph:Ye&&k.morphTexture!==null,outputColorSpace:ke===null?i.outputColorSpace:ke.isXRRenderTarget===!0?ke.texture.colorSpace:it.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Ue,matcap:dt,envMap:gt,envMapMode:gt&&H.mapping,envMapPMREM:et,envMapMaxLod:et?Le.length-1:null,envMapSize:et?Le[0].width:null,aoMap:Xt,lightMap:Dt,bumpMap:wn,normalMap:Mt,displacementMap:ci,emissiveMap:Bt,normalMapObjectSpace:Mt&&v.normalMapType===Kg,normalMapTangentSpace:Mt&&v.normalMapType===jr,packedNormalMap:Mt&&v.normalMapType===jr&&W1(v.normalMap.format),metalnessMap:Vn,roughnessMap:Gn,anisotropy:Hn,anisotropyMap:We,clearcoat:U,clearcoatMap:C,clearcoatNormalMap:w,clearcoatRoughnessMap:B,diffuseRoughness:Wn,diffuseRoughnessMap:se,dispersion:_t,retroreflection:wt,iridescence:me,iridescenceMap:J,iridescenceThicknessMap:ae,sheen:Nt,sheenColorMap:de,sheenRoughnessMap:Y,specularMap:j,specularColorMap:ce,specularIntensityMap:L,transmission:Oe,transmissionMap:K,thicknessMap:q,gradientMap:he,opaque:v.transparent===!1&&v.blending===qr&&v.alphaToCoverage===!1,alphaMap:oe,alphaTest:le,alphaHash:Ce,combine:v.combine,mapUv:Ue&&f(v.map.channel),aoMapUv:Xt&&f(v.aoMap.channel),lightMapUv:Dt&&f(v.lightMap.channel),bumpMapUv:wn&&f(v.bumpMap.channel),normalMapUv:Mt&&f(v.normalMap.channel),displacementMapUv:ci&&f(v.displacementMap.channel),emissiveMapUv:Bt&&f(v.emissiveMap.channel),metalnessMapUv:Vn&&f(v.metalnessMap.channel),roughnessMapUv:Gn&&f(v.roughnessMap.channel),anisotropyMapUv:We&&f(v.anisotropyMap.channel),clearcoatMapUv:C&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:B&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:se&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:J&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:ae&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:de&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:Y&&f(v.sheenRoughnessMap.channel),specularMapUv:j&&f(v.specularMap.channel),specularColorMapUv:ce&&f(v.specularColorMap.channel),specularIntensityMapUv:L&&f(v.specularIntensityMap.channel),transmissionMapUv:K&&f(v.transmissionMap.channel),thicknessMapUv:q&&f(v.thicknessMap.channel),alphaMapUv:oe&&f(v.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Mt||Hn),vertexNormals:!!I.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:k.isPoints===!0&&!!I.attributes.uv&&(Ue||oe),fog:!!V,useFog:v.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||I.attributes.normal===void 0&&Mt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:ve,skinning:k.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:we,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:O.filter(ge=>ge.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:i.shadowMap.enabled&&D.length>0,shadowMapType:i.shadowMap.type,toneMapping:re,decodeVideoTexture:Ue&&v.map.isVideoTexture===!0&&it.getTransfer(v.map.colorSpace)===ht,decodeVideoTextureEmissive:Bt&&v.emissiveMap.isVideoTexture===!0&&it.getTransfer(v.emissiveMap.colorSpace)===ht,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===yn,flipSided:v.side===xn,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Ke&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ke&&v.extensions.multiDraw===!0||Pt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return je.vertexUv1s=l.has(1),je.vertexUv2s=l.has(2),je.vertexUv3s=l.has(3),l.clear(),je}function x(v){let T=[];if(v.shaderID?T.push(v.shaderID):(T.push(v.customVertexShaderID),T.push(v.customFragmentShaderID)),v.defines!==void 0)for(let D in v.defines)T.push(D),T.push(v.defines[D]);return v.isRawShaderMaterial===!1&&(m(T,v),g(T,v),T.push(i.outputColorSpace)),T.push(v.customProgramCacheKey),T.join()}function m(v,T){v.push(T.precision),v.push(T.outputColorSpace),v.push(T.envMapMode),v.push(T.envMapPMREM),v.push(T.envMapMaxLod),v.push(T.envMapSize),v.push(T.mapUv),v.push(T.alphaMapUv),v.push(T.lightMapUv),v.push(T.aoMapUv),v.push(T.bumpMapUv),v.push(T.normalMapUv),v.push(T.displacementMapUv),v.push(T.emissiveMapUv),v.push(T.metalnessMapUv),v.push(T.roughnessMapUv),v.push(T.anisotropyMapUv),v.push(T.clearcoatMapUv),v.push(T.clearcoatNormalMapUv),v.push(T.clearcoatRoughnessMapUv),v.push(T.diffuseRoughnessMapUv),v.push(T.iridescenceMapUv),v.push(T.iridescenceThicknessMapUv),v.push(T.sheenColorMapUv),v.push(T.sheenRoughnessMapUv),v.push(T.specularMapUv),v.push(T.specularColorMapUv),v.push(T.specularIntensityMapUv),v.push(T.transmissionMapUv),v.push(T.thicknessMapUv),v.push(T.combine),v.push(T.fogExp2),v.push(T.sizeAttenuation),v.push(T.morphTargetsCount),v.push(T.numSunLights),v.push(T.numDirLights),v.push(T.numPointLights),v.push(T.numSpotLights),v.push(T.numSpotLightMaps),v.push(T.numHemiLights),v.push(T.numRectAreaLights),v.push(T.numSunLightShadows),v.push(T.numDirLightShadows),v.push(T.numPointLightShadows),v.push(T.numSpotLightShadows),v.push(T.numSpotLightShadowsWithMaps),v.push(T.numLightProbes),v.push(T.numLightProbeGrids),v.push(T.shadowMapType),v.push(T.toneMapping),v.push(T.numClippingPlanes),v.push(T.numClipIntersection),v.push(T.depthPacking)}function g(v,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function y(v){let T=d[v.type],D;if(T){let P=vn[T];D=Va.clone(P.uniforms)}else D=v.uniforms;return D}function S(v,T){let D=h.get(T);return D!==void 0?++D.usedTimes:(D=new G1(i,T,v,s),c.push(D),h.set(T,D)),D}function b(v){if(--v.usedTimes===0){let T=c.indexOf(v);c[T]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function A(v){a.remove(v)}function R(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:y,acquireProgram:S,releaseProgram:b,releaseShaderCache:A,programs:c,dispose:R}}function X1(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function q1(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function D0(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function N0(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,m,g){let y=i[e];return y===void 0?(y={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:g},i[e]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=p,y.materialVariant=o(d),y.groupOrder=x,y.renderOrder=d.renderOrder,y.z=m,y.group=g),e++,y}function l(d,f,p,x,m,g,y){y.reversedDepth===!0&&(m=-m);let S=a(d,f,p,x,m,g);p.transmission>0?n.push(S):p.transparent===!0?s.push(S):t.push(S)}function c(d,f,p,x,m,g){let y=a(d,f,p,x,m,g);p.transmission>0?n.unshift(y):p.transparent===!0?s.unshift(y):t.unshift(y)}function h(d,f){t.length>1&&t.sort(d||q1),n.length>1&&n.sort(f||D0),s.length>1&&s.sort(f||D0)}function u(){for(let d=e,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function Y1(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new N0,i.set(n,[o])):s>=r.length?(o=new N0,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function Z1(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new E,color:new Ae};break;case"SpotLight":t={position:new E,direction:new E,color:new Ae,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new E,color:new Ae,distance:0,decay:0};break;case"HemisphereLight":t={direction:new E,skyColor:new Ae,groundColor:new Ae};break;case"RectAreaLight":t={color:new Ae,position:new E,halfWidth:new E,halfHeight:new E};break}return i[e.id]=t,t}}}function j1(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ee};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ee};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ee,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var K1=0;function J1(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function Q1(i){let e=new Z1,t=j1(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new E);let s=new E,r=new Ie,o=new Ie;function a(c){let h=0,u=0,d=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,y=0,S=0,b=0,A=0,R=0,v=0,T=0,D=0,P=0;c.sort(J1);for(let O=0,V=c.length;O<V;O++){let I=c[O],G=I.color,$=I.intensity,H=I.distance,ne=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===ls?ne=I.shadow.map.texture:ne=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=G.r*$,u+=G.g*$,d+=G.b*$;else if(I.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(I.sh.coefficients[X],$);P++}else if(I.isSunLight){let X=e.get(I);if(X.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,te=t.get(I);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[p]=te,n.sunShadowMap[p]=ne;let we=Q.getViewportCount();for(let Be=0;Be<we;Be++)n.sunShadowMatrix[x+Be]=Q.getMatrix(Be),n.sunShadowCascade[x+Be]=Q._cascadeData[Be];x+=we,p++}n.sun[f]=X,f++}else if(I.isDirectionalLight){let X=e.get(I);if(X.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,te=t.get(I);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize=Q.mapSize,n.directionalShadow[m]=te,n.directionalShadowMap[m]=ne,n.directionalShadowMatrix[m]=I.shadow.matrix,A++}n.directional[m]=X,m++}else if(I.isSpotLight){let X=e.get(I);X.position.setFromMatrixPosition(I.matrixWorld),X.color.copy(G).multiplyScalar($),X.distance=H,X.coneCos=Math.cos(I.angle),X.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),X.decay=I.decay,n.spot[y]=X;let Q=I.shadow;if(I.map&&(n.spotLightMap[T]=I.map,T++,Q.updateMatrices(I),I.castShadow&&D++),n.spotLightMatrix[y]=Q.matrix,I.castShadow){let te=t.get(I);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize=Q.mapSize,n.spotShadow[y]=te,n.spotShadowMap[y]=ne,v++}y++}else if(I.isRectAreaLight){let X=e.get(I);X.color.copy(G).multiplyScalar($),X.halfWidth.set(I.width*.5,0,0),X.halfHeight.set(0,I.height*.5,0),n.rectArea[S]=X,S++}else if(I.isPointLight){let X=e.get(I);if(X.color.copy(I.color).multiplyScalar(I.intensity),X.distance=I.distance,X.decay=I.decay,I.castShadow){let Q=I.shadow,te=t.get(I);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize=Q.mapSize,te.shadowCameraNear=Q.camera.near,te.shadowCameraFar=Q.camera.far,n.pointShadow[g]=te,n.pointShadowMap[g]=ne,n.pointShadowMatrix[g]=I.shadow.matrix,R++}n.point[g]=X,g++}else if(I.isHemisphereLight){let X=e.get(I);X.skyColor.copy(I.color).multiplyScalar($),X.groundColor.copy(I.groundColor).multiplyScalar($),n.hemi[b]=X,b++}}S>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=pe.LTC_FLOAT_1,n.rectAreaLTC2=pe.LTC_FLOAT_2):(n.rectAreaLTC1=pe.LTC_HALF_1,n.rectAreaLTC2=pe.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let k=n.hash;(k.sunLength!==f||k.directionalLength!==m||k.pointLength!==g||k.spotLength!==y||k.rectAreaLength!==S||k.hemiLength!==b||k.numSunShadows!==p||k.numDirectionalShadows!==A||k.numPointShadows!==R||k.numSpotShadows!==v||k.numSpotMaps!==T||k.numLightProbes!==P)&&(n.sun.length=f,n.directional.length=m,n.spot.length=y,n.rectArea.length=S,n.point.length=g,n.hemi.length=b,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=A,n.directionalShadowMap.length=A,n.directionalShadowMatrix.length=A,n.pointShadow.length=R,n.pointShadowMap.length=R,n.pointShadowMatrix.length=R,n.spotShadow.length=v,n.spotShadowMap.length=v,n.spotLightMatrix.length=v+T-D,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=D,n.numLightProbes=P,k.sunLength=f,k.directionalLength=m,k.pointLength=g,k.spotLength=y,k.rectAreaLength=S,k.hemiLength=b,k.numSunShadows=p,k.numDirectionalShadows=A,k.numPointShadows=R,k.numSpotShadows=v,k.numSpotMaps=T,k.numLightProbes=P,n.version=K1++)}function l(c,h){let u=0,d=0,f=0,p=0,x=0,m=0,g=h.matrixWorldInverse;for(let y=0,S=c.length;y<S;y++){let b=c[y];if(b.isSunLight){let A=n.sun[u];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(g),u++}else if(b.isDirectionalLight){let A=n.directional[d];A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(b.isSpotLight){let A=n.spot[p];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),p++}else if(b.isRectAreaLight){let A=n.rectArea[x];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(b.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(b.width*.5,0,0),A.halfHeight.set(0,b.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),x++}else if(b.isPointLight){let A=n.point[f];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let A=n.hemi[m];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:n}}function k0(i){let e=new Q1(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function eT(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new k0(i),e.set(s,[a])):r>=o.length?(a=new k0(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var tT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,nT=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,iT=[new E(1,0,0),new E(-1,0,0),new E(0,1,0),new E(0,-1,0),new E(0,0,1),new E(0,0,-1)],sT=[new E(0,-1,0),new E(0,-1,0),new E(0,0,1),new E(0,0,-1),new E(0,-1,0),new E(0,-1,0)],O0=new Ie,Ga=new E,zf=new E;function rT(i,e,t){let n=new Ji,s=new ee,r=new ee,o=new ut,a=new Pc,l=new Ic,c={},h=t.maxTextureSize,u={[as]:xn,[xn]:as,[yn]:yn},d=new Yn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ee},radius:{value:4}},vertexShader:tT,fragmentShader:nT}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Ze;p.setAttribute("position",new yt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new ot(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=zs;let g=this.type;this.render=function(R,v,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||R.length===0)return;this.type===Rg&&(Ne("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=zs);let D=i.getRenderTarget(),P=i.getActiveCubeFace(),k=i.getActiveMipmapLevel(),O=i.state;O.setBlending(Vs),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let V=g!==this.type;V&&v.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(G=>G.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,G=R.length;I<G;I++){let $=R[I],H=$.shadow;if(H===void 0){Ne("WebGLShadowMap:",$,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ne=H.getFrameExtents();s.multiply(ne),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ne.x),s.x=r.x*ne.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ne.y),s.y=r.y*ne.y,H.mapSize.y=r.y));let X=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=X,H.map===null||V===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===Xr){if($.isPointLight){Ne("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new Nn(s.x,s.y,{format:ls,type:ri,minFilter:mn,magFilter:mn,generateMipmaps:!1}),H.map.texture.name=$.name+".shadowMap",H.map.depthTexture=new Ni(s.x,s.y,Zn),H.map.depthTexture.name=$.name+".shadowMapDepth",H.map.depthTexture.format=Di,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Wt,H.map.depthTexture.magFilter=Wt}else $.isPointLight?(H.map=new Wa(s.x),H.map.depthTexture=new aa(s.x,si)):(H.map=new Nn(s.x,s.y),H.map.depthTexture=new Ni(s.x,s.y,si)),H.map.depthTexture.name=$.name+".shadowMap",H.map.depthTexture.format=Di,this.type===zs?(H.map.depthTexture.compareFunction=X?Ef:Tf,H.map.depthTexture.minFilter=mn,H.map.depthTexture.magFilter=mn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Wt,H.map.depthTexture.magFilter=Wt);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();$.isPointLight!==!0&&H.updateMatrices($,T);let te=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:T.layers;for(let we=0;we<Q;we++){let Be=H.getCamera(we);if($.isPointLight){let Z=H.camera,xe=H.matrix,Se=$.distance||Z.far;Se!==Z.far&&(Z.far=Se,Z.updateProjectionMatrix()),Ga.setFromMatrixPosition($.matrixWorld),Z.position.copy(Ga),zf.copy(Z.position),zf.add(iT[we]),Z.up.copy(sT[we]),Z.lookAt(zf),Z.updateMatrixWorld(),xe.makeTranslation(-Ga.x,-Ga.y,-Ga.z),O0.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),H._frustum.setFromProjectionMatrix(O0,Z.coordinateSystem,Z.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,we),i.clear();else{we===0&&(i.setRenderTarget(H.map),i.clear());let Z=H.getViewport(we);o.set(r.x*Z.x,r.y*Z.y,r.x*Z.z,r.y*Z.w),O.viewport(o)}n=H.getFrustum(we),b(v,T,Be,$,te,this.type)}H.isPointLightShadow!==!0&&this.type===Xr&&y(H,T),H.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(D,P,k)};function y(R,v){let T=e.update(x);d.defines.VSM_SAMPLES!==R.blurSamples&&(d.defines.VSM_SAMPLES=R.blurSamples,f.defines.VSM_SAMPLES=R.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),R.mapPass===null?R.mapPass=new Nn(s.x,s.y,{format:ls,type:ri}):(R.mapPass.width!==R.map.width||R.mapPass.height!==R.map.height)&&R.mapPass.setSize(R.map.width,R.map.height),d.uniforms.shadow_pass.value=R.map.depthTexture,d.uniforms.resolution.value.set(R.map.width,R.map.height),d.uniforms.radius.value=R.radius,i.setRenderTarget(R.mapPass),i.clear(),i.renderBufferDirect(v,null,T,d,x,null),f.uniforms.shadow_pass.value=R.mapPass.texture,f.uniforms.resolution.value.set(R.map.width,R.map.height),f.uniforms.radius.value=R.radius,i.setRenderTarget(R.map),i.clear(),i.renderBufferDirect(v,null,T,f,x,null)}function S(R,v,T,D){let P=null,k=T.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(k!==void 0)P=k;else if(P=T.isPointLight===!0?l:a,i.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let O=P.uuid,V=v.uuid,I=c[O];I===void 0&&(I={},c[O]=I);let G=I[V];G===void 0&&(G=P.clone(),I[V]=G,v.addEventListener("dispose",A)),P=G}if(P.visible=v.visible,P.wireframe=v.wireframe,D===Xr?P.side=v.shadowSide!==null?v.shadowSide:v.side:P.side=v.shadowSide!==null?v.shadowSide:u[v.side],P.alphaMap=v.alphaMap,P.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,P.map=v.map,P.clipShadows=v.clipShadows,P.clippingPlanes=v.clippingPlanes,P.clipIntersection=v.clipIntersection,P.displacementMap=v.displacementMap,P.displacementScale=v.displacementScale,P.displacementBias=v.displacementBias,P.wireframeLinewidth=v.wireframeLinewidth,P.linewidth=v.linewidth,T.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let O=i.properties.get(P);O.light=T}return P}function b(R,v,T,D,P,k){if(R.visible===!1)return;if(R.layers.test(P)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&k===Xr)&&(!R.frustumCulled||R.intersectsFrustum(n))){R.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,R.matrixWorld);let I=e.update(R),G=R.material;if(Array.isArray(G)){let $=I.groups;for(let H=0,ne=$.length;H<ne;H++){let X=$[H],Q=G[X.materialIndex];if(Q&&Q.visible){let te=S(R,Q,D,k);R.onBeforeShadow(i,R,v,T,I,te,X),i.renderBufferDirect(T,null,I,te,R,X),R.onAfterShadow(i,R,v,T,I,te,X)}}}else if(G.visible){let $=S(R,G,D,k);R.onBeforeShadow(i,R,v,T,I,$,null),i.renderBufferDirect(T,null,I,$,R,null),R.onAfterShadow(i,R,v,T,I,$,null)}}let V=R.children;for(let I=0,G=V.length;I<G;I++)b(V[I],v,T,D,P,k)}function A(R){R.target.removeEventListener("dispose",A);for(let T in c){let D=c[T],P=R.target.uuid;P in D&&(D[P].dispose(),delete D[P])}}}function oT(i,e){function t(){let L=!1,K=new ut,q=null,he=new ut(0,0,0,0);return{setMask:function(oe){q!==oe&&!L&&(i.colorMask(oe,oe,oe,oe),q=oe)},setLocked:function(oe){L=oe},setClear:function(oe,le,Ce,Ke,re){re===!0&&(oe*=Ke,le*=Ke,Ce*=Ke),K.set(oe,le,Ce,Ke),he.equals(K)===!1&&(i.clearColor(oe,le,Ce,Ke),he.copy(K))},reset:function(){L=!1,q=null,he.set(-1,0,0,0)}}}function n(){let L=!1,K=!1,q=null,he=null,oe=null;return{setReversed:function(le){if(K!==le){let Ce=e.get("EXT_clip_control");le?Ce.clipControlEXT(Ce.LOWER_LEFT_EXT,Ce.ZERO_TO_ONE_EXT):Ce.clipControlEXT(Ce.LOWER_LEFT_EXT,Ce.NEGATIVE_ONE_TO_ONE_EXT),K=le;let Ke=oe;oe=null,this.setClear(Ke)}},getReversed:function(){return K},setTest:function(le){le?ve(i.DEPTH_TEST):Ye(i.DEPTH_TEST)},setMask:function(le){q!==le&&!L&&(i.depthMask(le),q=le)},setFunc:function(le){if(K&&(le=a0[le]),he!==le){switch(le){case ac:i.depthFunc(i.NEVER);break;case lc:i.depthFunc(i.ALWAYS);break;case cc:i.depthFunc(i.LESS);break;case Pr:i.depthFunc(i.LEQUAL);break;case hc:i.depthFunc(i.EQUAL);break;case uc:i.depthFunc(i.GEQUAL);break;case dc:i.depthFunc(i.GREATER);break;case fc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}he=le}},setLocked:function(le){L=le},setClear:function(le){oe!==le&&(oe=le,K&&(le=1-le),i.clearDepth(le))},reset:function(){L=!1,q=null,he=null,oe=null,K=!1}}}function s(){let L=!1,K=null,q=null,he=null,oe=null,le=null,Ce=null,Ke=null,re=null;return{setTest:function(Le){L||(Le?ve(i.STENCIL_TEST):Ye(i.STENCIL_TEST))},setMask:function(Le){K!==Le&&!L&&(i.stencilMask(Le),K=Le)},setFunc:function(Le,je,ge){(q!==Le||he!==je||oe!==ge)&&(i.stencilFunc(Le,je,ge),q=Le,he=je,oe=ge)},setOp:function(Le,je,ge){(le!==Le||Ce!==je||Ke!==ge)&&(i.stencilOp(Le,je,ge),le=Le,Ce=je,Ke=ge)},setLocked:function(Le){L=Le},setClear:function(Le){re!==Le&&(i.clearStencil(Le),re=Le)},reset:function(){L=!1,K=null,q=null,he=null,oe=null,le=null,Ce=null,Ke=null,re=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],x=null,m=!1,g=null,y=null,S=null,b=null,A=null,R=null,v=null,T=new Ae(0,0,0),D=0,P=!1,k=null,O=null,V=null,I=null,G=null,$=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ne=0,X=i.getParameter(i.VERSION);X.indexOf("WebGL")!==-1?(ne=parseFloat(/^WebGL (\d)/.exec(X)[1]),H=ne>=1):X.indexOf("OpenGL ES")!==-1&&(ne=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),H=ne>=2);let Q=null,te={},we=i.getParameter(i.SCISSOR_BOX),Be=i.getParameter(i.VIEWPORT),Z=new ut().fromArray(we),xe=new ut().fromArray(Be);function Se(L,K,q,he){let oe=new Uint8Array(4),le=i.createTexture();i.bindTexture(L,le),i.texParameteri(L,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(L,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ce=0;Ce<q;Ce++)L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY?i.texImage3D(K,0,i.RGBA,1,1,he,0,i.RGBA,i.UNSIGNED_BYTE,oe):i.texImage2D(K+Ce,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,oe);return le}let ke={};ke[i.TEXTURE_2D]=Se(i.TEXTURE_2D,i.TEXTURE_2D,1),ke[i.TEXTURE_CUBE_MAP]=Se(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ke[i.TEXTURE_2D_ARRAY]=Se(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ke[i.TEXTURE_3D]=Se(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ve(i.DEPTH_TEST),o.setFunc(Pr),wn(!1),Mt(nf),ve(i.CULL_FACE),Xt(Vs);function ve(L){h[L]!==!0&&(i.enable(L),h[L]=!0)}function Ye(L){h[L]!==!1&&(i.disable(L),h[L]=!1)}function Pt(L,K){return d[L]!==K?(i.bindFramebuffer(L,K),d[L]=K,L===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=K),L===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=K),!0):!1}function Ue(L,K){let q=p,he=!1;if(L){q=f.get(K),q===void 0&&(q=[],f.set(K,q));let oe=L.textures;if(q.length!==oe.length||q[0]!==i.COLOR_ATTACHMENT0){for(let le=0,Ce=oe.length;le<Ce;le++)q[le]=i.COLOR_ATTACHMENT0+le;q.length=oe.length,he=!0}}else q[0]!==i.BACK&&(q[0]=i.BACK,he=!0);he&&i.drawBuffers(q)}function dt(L){return x!==L?(i.useProgram(L),x=L,!0):!1}let gt={[Gs]:i.FUNC_ADD,[Pg]:i.FUNC_SUBTRACT,[Ig]:i.FUNC_REVERSE_SUBTRACT};gt[Lg]=i.MIN,gt[Dg]=i.MAX;let et={[Ng]:i.ZERO,[kg]:i.ONE,[Og]:i.SRC_COLOR,[af]:i.SRC_ALPHA,[Gg]:i.SRC_ALPHA_SATURATE,[zg]:i.DST_COLOR,[Fg]:i.DST_ALPHA,[Ug]:i.ONE_MINUS_SRC_COLOR,[lf]:i.ONE_MINUS_SRC_ALPHA,[Vg]:i.ONE_MINUS_DST_COLOR,[Bg]:i.ONE_MINUS_DST_ALPHA,[Hg]:i.CONSTANT_COLOR,[Wg]:i.ONE_MINUS_CONSTANT_COLOR,[$g]:i.CONSTANT_ALPHA,[Xg]:i.ONE_MINUS_CONSTANT_ALPHA};function Xt(L,K,q,he,oe,le,Ce,Ke,re,Le){if(L===Vs){m===!0&&(Ye(i.BLEND),m=!1);return}if(m===!1&&(ve(i.BLEND),m=!0),L!==Cg){if(L!==g||Le!==P){if((y!==Gs||A!==Gs)&&(i.blendEquation(i.FUNC_ADD),y=Gs,A=Gs),Le)switch(L){case qr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case sf:i.blendFunc(i.ONE,i.ONE);break;case rf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case of:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ze("WebGLState: Invalid blending: ",L);break}else switch(L){case qr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case sf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case rf:ze("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case of:ze("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ze("WebGLState: Invalid blending: ",L);break}S=null,b=null,R=null,v=null,T.set(0,0,0),D=0,g=L,P=Le}return}oe=oe||K,le=le||q,Ce=Ce||he,(K!==y||oe!==A)&&(i.blendEquationSeparate(gt[K],gt[oe]),y=K,A=oe),(q!==S||he!==b||le!==R||Ce!==v)&&(i.blendFuncSeparate(et[q],et[he],et[le],et[Ce]),S=q,b=he,R=le,v=Ce),(Ke.equals(T)===!1||re!==D)&&(i.blendColor(Ke.r,Ke.g,Ke.b,re),T.copy(Ke),D=re),g=L,P=!1}function Dt(L,K){L.side===yn?Ye(i.CULL_FACE):ve(i.CULL_FACE);let q=L.side===xn;K&&(q=!q),wn(q),L.blending===qr&&L.transparent===!1?Xt(Vs):Xt(L.blending,L.blendEquation,L.blendSrc,L.blendDst,L.blendEquationAlpha,L.blendSrcAlpha,L.blendDstAlpha,L.blendColor,L.blendAlpha,L.premultipliedAlpha),o.setFunc(L.depthFunc),o.setTest(L.depthTest),o.setMask(L.depthWrite),r.setMask(L.colorWrite);let he=L.stencilWrite;a.setTest(he),he&&(a.setMask(L.stencilWriteMask),a.setFunc(L.stencilFunc,L.stencilRef,L.stencilFuncMask),a.setOp(L.stencilFail,L.stencilZFail,L.stencilZPass)),Bt(L.polygonOffset,L.polygonOffsetFactor,L.polygonOffsetUnits),L.alphaToCoverage===!0?ve(i.SAMPLE_ALPHA_TO_COVERAGE):Ye(i.SAMPLE_ALPHA_TO_COVERAGE)}function wn(L){k!==L&&(L?i.frontFace(i.CW):i.frontFace(i.CCW),k=L)}function Mt(L){L!==Eg?(ve(i.CULL_FACE),L!==O&&(L===nf?i.cullFace(i.BACK):L===Ag?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ye(i.CULL_FACE),O=L}function ci(L){L!==V&&(H&&i.lineWidth(L),V=L)}function Bt(L,K,q){L?(ve(i.POLYGON_OFFSET_FILL),(I!==K||G!==q)&&(I=K,G=q,o.getReversed()&&(K=-K,q=-q),i.polygonOffset(K,q))):Ye(i.POLYGON_OFFSET_FILL)}function Vn(L){L?ve(i.SCISSOR_TEST):Ye(i.SCISSOR_TEST)}function Gn(L){L===void 0&&(L=i.TEXTURE0+$-1),Q!==L&&(i.activeTexture(L),Q=L)}function Hn(L,K,q){q===void 0&&(Q===null?q=i.TEXTURE0+$-1:q=Q);let he=te[q];he===void 0&&(he={type:void 0,texture:void 0},te[q]=he),(he.type!==L||he.texture!==K)&&(Q!==q&&(i.activeTexture(q),Q=q),i.bindTexture(L,K||ke[L]),he.type=L,he.texture=K)}function U(){let L=te[Q];L!==void 0&&L.type!==void 0&&(i.bindTexture(L.type,null),L.type=void 0,L.texture=void 0)}function Wn(){try{i.compressedTexImage2D(...arguments)}catch(L){ze("WebGLState:",L)}}function _t(){try{i.compressedTexImage3D(...arguments)}catch(L){ze("WebGLState:",L)}}function wt(){try{i.texSubImage2D(...arguments)}catch(L){ze("WebGLState:",L)}}function me(){try{i.texSubImage3D(...arguments)}catch(L){ze("WebGLState:",L)}}function Nt(){try{i.compressedTexSubImage2D(...arguments)}catch(L){ze("WebGLState:",L)}}function Oe(){try{i.compressedTexSubImage3D(...arguments)}catch(L){ze("WebGLState:",L)}}function We(){try{i.texStorage2D(...arguments)}catch(L){ze("WebGLState:",L)}}function C(){try{i.texStorage3D(...arguments)}catch(L){ze("WebGLState:",L)}}function w(){try{i.texImage2D(...arguments)}catch(L){ze("WebGLState:",L)}}function B(){try{i.texImage3D(...arguments)}catch(L){ze("WebGLState:",L)}}function se(L){return u[L]!==void 0?u[L]:i.getParameter(L)}function J(L,K){u[L]!==K&&(i.pixelStorei(L,K),u[L]=K)}function ae(L){Z.equals(L)===!1&&(i.scissor(L.x,L.y,L.z,L.w),Z.copy(L))}function de(L){xe.equals(L)===!1&&(i.viewport(L.x,L.y,L.z,L.w),xe.copy(L))}function Y(L,K){let q=c.get(K);q===void 0&&(q=new WeakMap,c.set(K,q));let he=q.get(L);he===void 0&&(he=i.getUniformBlockIndex(K,L.name),i.uniformBlockBinding(K,he,he),q.set(L,he))}function j(L,K,q){let oe=c.get(K).get(L);l[oe]!==q&&(i.bindBufferBase(i.UNIFORM_BUFFER,oe,q),l[oe]=q)}function ce(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,te={},d={},l={},f=new WeakMap,p=[],x=null,m=!1,g=null,y=null,S=null,b=null,A=null,R=null,v=null,T=new Ae(0,0,0),D=0,P=!1,k=null,O=null,V=null,I=null,G=null,Z.set(0,0,i.canvas.width,i.canvas.height),xe.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ve,disable:Ye,bindFramebuffer:Pt,drawBuffers:Ue,useProgram:dt,setBlending:Xt,setMaterial:Dt,setFlipSided:wn,setCullFace:Mt,setLineWidth:ci,setPolygonOffset:Bt,setScissorTest:Vn,activeTexture:Gn,bindTexture:Hn,unbindTexture:U,compressedTexImage2D:Wn,compressedTexImage3D:_t,texImage2D:w,texImage3D:B,pixelStorei:J,getParameter:se,updateUBOMapping:Y,uniformBlockBinding:j,texStorage2D:We,texStorage3D:C,texSubImage2D:wt,texSubImage3D:me,compressedTexSubImage2D:Nt,compressedTexSubImage3D:Oe,scissor:ae,viewport:de,reset:ce}}function aT(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ee,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(C=>p.delete(C)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(C,w){return m?new OffscreenCanvas(C,w):Yo("canvas")}function y(C,w,B){let se=1,J=We(C);if((J.width>B||J.height>B)&&(se=B/Math.max(J.width,J.height)),se<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let ae=Math.floor(se*J.width),de=Math.floor(se*J.height);d===void 0&&(d=g(ae,de));let Y=w?g(ae,de):d;return Y.width=ae,Y.height=de,Y.getContext("2d").drawImage(C,0,0,ae,de),Ne("WebGLRenderer: Texture has been resized from ("+J.width+"x"+J.height+") to ("+ae+"x"+de+")."),Y}else return"data"in C&&Ne("WebGLRenderer: Image in DataTexture is too big ("+J.width+"x"+J.height+")."),C;return C}function S(C){return C.generateMipmaps}function b(C){i.generateMipmap(C)}function A(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function R(C,w,B,se,J,ae=!1){if(C!==null){if(i[C]!==void 0)return i[C];Ne("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let de;se&&(de=e.get("EXT_texture_norm16"),de||Ne("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Y=w;if(w===i.RED&&(B===i.FLOAT&&(Y=i.R32F),B===i.HALF_FLOAT&&(Y=i.R16F),B===i.UNSIGNED_BYTE&&(Y=i.R8),B===i.UNSIGNED_SHORT&&de&&(Y=de.R16_EXT),B===i.SHORT&&de&&(Y=de.R16_SNORM_EXT)),w===i.RED_INTEGER&&(B===i.UNSIGNED_BYTE&&(Y=i.R8UI),B===i.UNSIGNED_SHORT&&(Y=i.R16UI),B===i.UNSIGNED_INT&&(Y=i.R32UI),B===i.BYTE&&(Y=i.R8I),B===i.SHORT&&(Y=i.R16I),B===i.INT&&(Y=i.R32I)),w===i.RG&&(B===i.FLOAT&&(Y=i.RG32F),B===i.HALF_FLOAT&&(Y=i.RG16F),B===i.UNSIGNED_BYTE&&(Y=i.RG8),B===i.UNSIGNED_SHORT&&de&&(Y=de.RG16_EXT),B===i.SHORT&&de&&(Y=de.RG16_SNORM_EXT)),w===i.RG_INTEGER&&(B===i.UNSIGNED_BYTE&&(Y=i.RG8UI),B===i.UNSIGNED_SHORT&&(Y=i.RG16UI),B===i.UNSIGNED_INT&&(Y=i.RG32UI),B===i.BYTE&&(Y=i.RG8I),B===i.SHORT&&(Y=i.RG16I),B===i.INT&&(Y=i.RG32I)),w===i.RGB_INTEGER&&(B===i.UNSIGNED_BYTE&&(Y=i.RGB8UI),B===i.UNSIGNED_SHORT&&(Y=i.RGB16UI),B===i.UNSIGNED_INT&&(Y=i.RGB32UI),B===i.BYTE&&(Y=i.RGB8I),B===i.SHORT&&(Y=i.RGB16I),B===i.INT&&(Y=i.RGB32I)),w===i.RGBA_INTEGER&&(B===i.UNSIGNED_BYTE&&(Y=i.RGBA8UI),B===i.UNSIGNED_SHORT&&(Y=i.RGBA16UI),B===i.UNSIGNED_INT&&(Y=i.RGBA32UI),B===i.BYTE&&(Y=i.RGBA8I),B===i.SHORT&&(Y=i.RGBA16I),B===i.INT&&(Y=i.RGBA32I)),w===i.RGB&&(B===i.UNSIGNED_SHORT&&de&&(Y=de.RGB16_EXT),B===i.SHORT&&de&&(Y=de.RGB16_SNORM_EXT),B===i.UNSIGNED_INT_5_9_9_9_REV&&(Y=i.RGB9_E5),B===i.UNSIGNED_INT_10F_11F_11F_REV&&(Y=i.R11F_G11F_B10F)),w===i.RGBA){let j=ae?qo:it.getTransfer(J);B===i.FLOAT&&(Y=i.RGBA32F),B===i.HALF_FLOAT&&(Y=i.RGBA16F),B===i.UNSIGNED_BYTE&&(Y=j===ht?i.SRGB8_ALPHA8:i.RGBA8),B===i.UNSIGNED_SHORT&&de&&(Y=de.RGBA16_EXT),B===i.SHORT&&de&&(Y=de.RGBA16_SNORM_EXT),B===i.UNSIGNED_SHORT_4_4_4_4&&(Y=i.RGBA4),B===i.UNSIGNED_SHORT_5_5_5_1&&(Y=i.RGB5_A1)}return(Y===i.R16F||Y===i.R32F||Y===i.RG16F||Y===i.RG32F||Y===i.RGBA16F||Y===i.RGBA32F)&&e.get("EXT_color_buffer_float"),Y}function v(C,w){let B;return C?w===null||w===si||w===Ws?B=i.DEPTH24_STENCIL8:w===Zn?B=i.DEPTH32F_STENCIL8:w===Zr&&(B=i.DEPTH24_STENCIL8,Ne("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===si||w===Ws?B=i.DEPTH_COMPONENT24:w===Zn?B=i.DEPTH_COMPONENT32F:w===Zr&&(B=i.DEPTH_COMPONENT16),B}function T(C,w){return S(C)===!0||C.isFramebufferTexture&&C.minFilter!==Wt&&C.minFilter!==mn?Math.log2(Math.max(w.width,w.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?w.mipmaps.length:1}function D(C){let w=new WeakRef(C);n.get(C).__ref=w,p.add(w),x.register(C,w,w)}function P(C){let w=n.get(C).__ref;w!==void 0&&(p.delete(w),x.unregister(w))}function k(C){V(C.target)}function O(C){I(C.target)}function V(C){C.removeEventListener("dispose",k),P(C),$(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&u.delete(C)}function I(C){C.removeEventListener("dispose",O),P(C),ne(C)}function G(){for(let C of p){let w=C.deref();w!==void 0&&(w.isRenderTarget===!0?I(w):V(w))}p.clear(),u.clear()}function $(C){let w=n.get(C);if(w.__webglInit===void 0)return;let B=C.source,se=f.get(B);if(se){let J=se[w.__cacheKey];J.usedTimes--,J.usedTimes===0&&H(C),Object.keys(se).length===0&&f.delete(B)}n.remove(C)}function H(C){let w=n.get(C);i.deleteTexture(w.__webglTexture);let B=C.source,se=f.get(B);delete se[w.__cacheKey],o.memory.textures--}function ne(C){let w=n.get(C);w.__depthDisposeCallback&&w.__depthDisposeCallback();let B=C.depthTexture;if(B&&B.renderTarget===C&&V(B),C.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(w.__webglFramebuffer[J]))for(let ae=0;ae<w.__webglFramebuffer[J].length;ae++)i.deleteFramebuffer(w.__webglFramebuffer[J][ae]);else i.deleteFramebuffer(w.__webglFramebuffer[J]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[J])}else{if(Array.isArray(w.__webglFramebuffer))for(let J=0;J<w.__webglFramebuffer.length;J++)i.deleteFramebuffer(w.__webglFramebuffer[J]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let J=0;J<w.__webglColorRenderbuffer.length;J++)w.__webglColorRenderbuffer[J]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[J]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let se=C.textures;for(let J=0,ae=se.length;J<ae;J++){let de=n.get(se[J]);de.__webglTexture&&(i.deleteTexture(de.__webglTexture),o.memory.textures--),n.remove(se[J])}n.remove(C)}let X=0;function Q(){X=0}function te(){return X}function we(C){X=C}function Be(){let C=X;return C>=s.maxTextures&&Ne("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,C}function Z(C){let w=[];return w.push(C.wrapS),w.push(C.wrapT),w.push(C.wrapR||0),w.push(C.magFilter),w.push(C.minFilter),w.push(C.anisotropy),w.push(C.internalFormat),w.push(C.format),w.push(C.type),w.push(C.generateMipmaps),w.push(C.mipmapsAutoUpdate),w.push(C.premultiplyAlpha),w.push(C.flipY),w.push(C.unpackAlignment),w.push(C.colorSpace),w.join()}function xe(C,w){let B=n.get(C);if(C.isVideoTexture&&Nt(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&B.__version!==C.version){let se=C.image;if(se===null)Ne("WebGLRenderer: Texture marked for update but no image data found.");else if(se.complete===!1)Ne("WebGLRenderer: Texture marked for update but image is incomplete");else{Dt(B,C,w);return}}else C.isExternalTexture&&(B.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,B.__webglTexture,i.TEXTURE0+w)}function Se(C,w){let B=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&B.__version!==C.version){Dt(B,C,w);return}else C.isExternalTexture&&(B.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,B.__webglTexture,i.TEXTURE0+w)}function ke(C,w){let B=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&B.__version!==C.version){Dt(B,C,w);return}t.bindTexture(i.TEXTURE_3D,B.__webglTexture,i.TEXTURE0+w)}function ve(C,w){let B=n.get(C);if(C.version>0&&B.__version!==C.version){wn(B,C,w);return}t.bindTexture(i.TEXTURE_CUBE_MAP,B.__webglTexture,i.TEXTURE0+w)}let Ye={[Is]:i.REPEAT,[mi]:i.CLAMP_TO_EDGE,[pc]:i.MIRRORED_REPEAT},Pt={[Wt]:i.NEAREST,[Zg]:i.NEAREST_MIPMAP_NEAREST,[Na]:i.NEAREST_MIPMAP_LINEAR,[mn]:i.LINEAR,[Xc]:i.LINEAR_MIPMAP_NEAREST,[Ui]:i.LINEAR_MIPMAP_LINEAR},Ue={[Qg]:i.NEVER,[Af]:i.ALWAYS,[e0]:i.LESS,[Tf]:i.LEQUAL,[t0]:i.EQUAL,[Ef]:i.GEQUAL,[n0]:i.GREATER,[i0]:i.NOTEQUAL};function dt(C,w){if(w.type===Zn&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===mn||w.magFilter===Xc||w.magFilter===Na||w.magFilter===Ui||w.minFilter===mn||w.minFilter===Xc||w.minFilter===Na||w.minFilter===Ui)&&Ne("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,Ye[w.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,Ye[w.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,Ye[w.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,Pt[w.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,Pt[w.minFilter]),w.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,Ue[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===Wt||w.minFilter!==Na&&w.minFilter!==Ui||w.type===Zn&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let B=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,B.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function gt(C,w){let B=!1;C.__webglInit===void 0&&(C.__webglInit=!0,w.addEventListener("dispose",k),D(w));let se=w.source,J=f.get(se);J===void 0&&(J={},f.set(se,J));let ae=Z(w);if(ae!==C.__cacheKey){J[ae]===void 0&&(J[ae]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,B=!0),J[ae].usedTimes++;let de=J[C.__cacheKey];de!==void 0&&(J[C.__cacheKey].usedTimes--,de.usedTimes===0&&H(w)),C.__cacheKey=ae,C.__webglTexture=J[ae].texture}return B}function et(C,w,B){return Math.floor(Math.floor(C/B)/w)}function Xt(C,w,B,se){let ae=C.updateRanges;if(ae.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,B,se,w.data);else{ae.sort((L,K)=>L.start-K.start);let de=0;for(let L=1;L<ae.length;L++){let K=ae[de],q=ae[L],he=K.start+K.count,oe=et(q.start,w.width,4),le=et(K.start,w.width,4);q.start<=he+1&&oe===le&&et(q.start+q.count-1,w.width,4)===oe?K.count=Math.max(K.count,q.start+q.count-K.start):(++de,ae[de]=q)}ae.length=de+1;let Y=t.getParameter(i.UNPACK_ROW_LENGTH),j=t.getParameter(i.UNPACK_SKIP_PIXELS),ce=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let L=0,K=ae.length;L<K;L++){let q=ae[L],he=Math.floor(q.start/4),oe=Math.ceil(q.count/4),le=he%w.width,Ce=Math.floor(he/w.width),Ke=oe,re=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,le),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ce),t.texSubImage2D(i.TEXTURE_2D,0,le,Ce,Ke,re,B,se,w.data)}C.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,Y),t.pixelStorei(i.UNPACK_SKIP_PIXELS,j),t.pixelStorei(i.UNPACK_SKIP_ROWS,ce)}}function Dt(C,w,B){let se=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(se=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(se=i.TEXTURE_3D);let J=gt(C,w),ae=w.source;t.bindTexture(se,C.__webglTexture,i.TEXTURE0+B);let de=n.get(ae);if(ae.version!==de.__version||J===!0){if(t.activeTexture(i.TEXTURE0+B),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let re=it.getPrimaries(it.workingColorSpace),Le=w.colorSpace===Bi?null:it.getPrimaries(w.colorSpace),je=w.colorSpace===Bi||re===Le?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,je)}t.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment);let j=y(w.image,!1,s.maxTextureSize);j=Oe(w,j);let ce=r.convert(w.format,w.colorSpace),L=r.convert(w.type),K=R(w.internalFormat,ce,L,w.normalized,w.colorSpace,w.isVideoTexture);dt(se,w);let q,he=w.mipmaps,oe=w.isVideoTexture!==!0,le=de.__version===void 0||J===!0,Ce=ae.dataReady,Ke=T(w,j);if(w.isDepthTexture)K=v(w.format===Fi,w.type),le&&(oe?t.texStorage2D(i.TEXTURE_2D,1,K,j.width,j.height):t.texImage2D(i.TEXTURE_2D,0,K,j.width,j.height,0,ce,L,null));else if(w.isDataTexture)if(he.length>0){oe&&le&&t.texStorage2D(i.TEXTURE_2D,Ke,K,he[0].width,he[0].height);for(let re=0,Le=he.length;re<Le;re++)q=he[re],oe?Ce&&t.texSubImage2D(i.TEXTURE_2D,re,0,0,q.width,q.height,ce,L,q.data):t.texImage2D(i.TEXTURE_2D,re,K,q.width,q.height,0,ce,L,q.data);w.generateMipmaps=!1}else oe?(le&&t.texStorage2D(i.TEXTURE_2D,Ke,K,j.width,j.height),Ce&&Xt(w,j,ce,L)):t.texImage2D(i.TEXTURE_2D,0,K,j.width,j.height,0,ce,L,j.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){oe&&le&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ke,K,he[0].width,he[0].height,j.depth);for(let re=0,Le=he.length;re<Le;re++)if(q=he[re],w.format!==oi)if(ce!==null)if(oe){if(Ce)if(w.layerUpdates.size>0){let je=Ff(q.width,q.height,w.format,w.type);for(let ge of w.layerUpdates){let ft=q.data.subarray(ge*je/q.data.BYTES_PER_ELEMENT,(ge+1)*je/q.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,re,0,0,ge,q.width,q.height,1,ce,ft)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,re,0,0,0,q.width,q.height,j.depth,ce,q.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,re,K,q.width,q.height,j.depth,0,q.data,0,0);else Ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else oe?Ce&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,re,0,0,0,q.width,q.height,j.depth,ce,L,q.data):t.texImage3D(i.TEXTURE_2D_ARRAY,re,K,q.width,q.height,j.depth,0,ce,L,q.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{oe&&le&&t.texStorage2D(i.TEXTURE_2D,Ke,K,he[0].width,he[0].height);for(let re=0,Le=he.length;re<Le;re++)q=he[re],w.format!==oi?ce!==null?oe?Ce&&t.compressedTexSubImage2D(i.TEXTURE_2D,re,0,0,q.width,q.height,ce,q.data):t.compressedTexImage2D(i.TEXTURE_2D,re,K,q.width,q.height,0,q.data):Ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):oe?Ce&&t.texSubImage2D(i.TEXTURE_2D,re,0,0,q.width,q.height,ce,L,q.data):t.texImage2D(i.TEXTURE_2D,re,K,q.width,q.height,0,ce,L,q.data)}else if(w.isDataArrayTexture)if(oe){if(le&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ke,K,j.width,j.height,j.depth),Ce)if(w.layerUpdates.size>0){let re=Ff(j.width,j.height,w.format,w.type);for(let Le of w.layerUpdates){let je=j.data.subarray(Le*re/j.data.BYTES_PER_ELEMENT,(Le+1)*re/j.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Le,j.width,j.height,1,ce,L,je)}w.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,j.width,j.height,j.depth,ce,L,j.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,K,j.width,j.height,j.depth,0,ce,L,j.data);else if(w.isData3DTexture)oe?(le&&t.texStorage3D(i.TEXTURE_3D,Ke,K,j.width,j.height,j.depth),Ce&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,j.width,j.height,j.depth,ce,L,j.data)):t.texImage3D(i.TEXTURE_3D,0,K,j.width,j.height,j.depth,0,ce,L,j.data);else if(w.isFramebufferTexture){if(le)if(oe)t.texStorage2D(i.TEXTURE_2D,Ke,K,j.width,j.height);else{let re=j.width,Le=j.height;for(let je=0;je<Ke;je++)t.texImage2D(i.TEXTURE_2D,je,K,re,Le,0,ce,L,null),re>>=1,Le>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in i){let re=i.canvas;if(re.hasAttribute("layoutsubtree")||re.setAttribute("layoutsubtree","true"),j.parentNode!==re){re.appendChild(j),u.add(w),re.onpaint=Le=>{let je=Le.changedElements;for(let ge of u)je.includes(ge.image)&&(ge.needsUpdate=!0)},re.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,j);else{let je=i.RGBA,ge=i.RGBA,ft=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,je,ge,ft,j)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(he.length>0){if(oe&&le){let re=We(he[0]);t.texStorage2D(i.TEXTURE_2D,Ke,K,re.width,re.height)}for(let re=0,Le=he.length;re<Le;re++)q=he[re],oe?Ce&&t.texSubImage2D(i.TEXTURE_2D,re,0,0,ce,L,q):t.texImage2D(i.TEXTURE_2D,re,K,ce,L,q);w.generateMipmaps=!1}else if(oe){if(le){let re=We(j);t.texStorage2D(i.TEXTURE_2D,Ke,K,re.width,re.height)}Ce&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ce,L,j)}else t.texImage2D(i.TEXTURE_2D,0,K,ce,L,j);S(w)&&w.mipmapsAutoUpdate===!0&&b(se),de.__version=ae.version,w.onUpdate&&w.onUpdate(w)}C.__version=w.version}function wn(C,w,B){if(w.image.length!==6)return;let se=gt(C,w),J=w.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+B);let ae=n.get(J);if(J.version!==ae.__version||se===!0){t.activeTexture(i.TEXTURE0+B);let de=it.getPrimaries(it.workingColorSpace),Y=w.colorSpace===Bi?null:it.getPrimaries(w.colorSpace),j=w.colorSpace===Bi||de===Y?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,j);let ce=w.isCompressedTexture||w.image[0].isCompressedTexture,L=w.image[0]&&w.image[0].isDataTexture,K=[];for(let ge=0;ge<6;ge++)!ce&&!L?K[ge]=y(w.image[ge],!0,s.maxCubemapSize):K[ge]=L?w.image[ge].image:w.image[ge],K[ge]=Oe(w,K[ge]);let q=K[0],he=r.convert(w.format,w.colorSpace),oe=r.convert(w.type),le=R(w.internalFormat,he,oe,w.normalized,w.colorSpace),Ce=w.isVideoTexture!==!0,Ke=ae.__version===void 0||se===!0,re=J.dataReady,Le=T(w,q);dt(i.TEXTURE_CUBE_MAP,w);let je;if(w.isDepthTexture){if(le=v(w.format===Fi,w.type),Ke)if(Ce)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,le,q.width,q.height);else for(let ge=0;ge<6;ge++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,le,q.width,q.height,0,he,oe,null)}else if(ce){Ce&&Ke&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Le,le,q.width,q.height);for(let ge=0;ge<6;ge++){je=K[ge].mipmaps;for(let ft=0;ft<je.length;ft++){let zt=je[ft];w.format!==oi?he!==null?Ce?re&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ft,0,0,zt.width,zt.height,he,zt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ft,le,zt.width,zt.height,0,zt.data):Ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ce?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ft,0,0,zt.width,zt.height,he,oe,zt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ft,le,zt.width,zt.height,0,he,oe,zt.data)}}}else{if(je=w.mipmaps,Ce&&Ke){je.length>0&&Le++;let ge=We(K[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Le,le,ge.width,ge.height)}for(let ge=0;ge<6;ge++)if(L){Ce?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,K[ge].width,K[ge].height,he,oe,K[ge].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,le,K[ge].width,K[ge].height,0,he,oe,K[ge].data);for(let ft=0;ft<je.length;ft++){let $i=je[ft].image[ge].image;Ce?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ft+1,0,0,$i.width,$i.height,he,oe,$i.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ft+1,le,$i.width,$i.height,0,he,oe,$i.data)}}else{Ce?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,he,oe,K[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,le,he,oe,K[ge]);for(let ft=0;ft<je.length;ft++){let zt=je[ft];Ce?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ft+1,0,0,he,oe,zt.image[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ft+1,le,he,oe,zt.image[ge])}}}S(w)&&w.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),ae.__version=J.version,w.onUpdate&&w.onUpdate(w)}C.__version=w.version}function Mt(C,w,B,se,J,ae){let de=r.convert(B.format,B.colorSpace),Y=r.convert(B.type),j=R(B.internalFormat,de,Y,B.normalized,B.colorSpace),ce=n.get(w),L=n.get(B);if(L.__renderTarget=w,!ce.__hasExternalTextures){let K=Math.max(1,w.width>>ae),q=Math.max(1,w.height>>ae);J===i.TEXTURE_3D||J===i.TEXTURE_2D_ARRAY?t.texImage3D(J,ae,j,K,q,w.depth,0,de,Y,null):t.texImage2D(J,ae,j,K,q,0,de,Y,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),me(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,se,J,L.__webglTexture,0,wt(w)):(J===i.TEXTURE_2D||J>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&J<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,se,J,L.__webglTexture,ae),t.bindFramebuffer(i.FRAMEBUFFER,null)}function ci(C,w,B){if(i.bindRenderbuffer(i.RENDERBUFFER,C),w.depthBuffer){let se=w.depthTexture,J=se&&se.isDepthTexture?se.type:null,ae=v(w.stencilBuffer,J),de=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;me(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,wt(w),ae,w.width,w.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,wt(w),ae,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,ae,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,de,i.RENDERBUFFER,C)}else{let se=w.textures;for(let J=0;J<se.length;J++){let ae=se[J],de=r.convert(ae.format,ae.colorSpace),Y=r.convert(ae.type),j=R(ae.internalFormat,de,Y,ae.normalized,ae.colorSpace);me(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,wt(w),j,w.width,w.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,wt(w),j,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,j,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Bt(C,w,B){let se=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let J=n.get(w.depthTexture);J.__renderTarget=w;let ae=se?w.depthTexture.image[0]:w.depthTexture.image;(!J.__webglTexture||ae.width!==w.width||ae.height!==w.height)&&(ae.width=w.width,ae.height=w.height,w.depthTexture.needsUpdate=!0),se?ve(w.depthTexture,0):xe(w.depthTexture,0);let de=J.__webglTexture,Y=wt(w),j=se?i.TEXTURE_CUBE_MAP_POSITIVE_X+B:i.TEXTURE_2D,ce=w.depthTexture.format===Fi?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(w.depthTexture.format===Di)me(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ce,j,de,0,Y):i.framebufferTexture2D(i.FRAMEBUFFER,ce,j,de,0);else if(w.depthTexture.format===Fi)me(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ce,j,de,0,Y):i.framebufferTexture2D(i.FRAMEBUFFER,ce,j,de,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Vn(C){let w=n.get(C),B=C.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==C.depthTexture){let se=C.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),se){let J=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,se.removeEventListener("dispose",J)};se.addEventListener("dispose",J),w.__depthDisposeCallback=J}w.__boundDepthTexture=se}if(C.depthTexture&&!w.__autoAllocateDepthBuffer)if(B)for(let se=0;se<6;se++)Bt(w.__webglFramebuffer[se],C,se);else C.texture.mipmaps.length>0?Bt(w.__webglFramebuffer[0],C,0):Bt(w.__webglFramebuffer,C,0);else if(B){w.__webglDepthbuffer=[];for(let se=0;se<6;se++)if(t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[se]),w.__webglDepthbuffer[se]===void 0)w.__webglDepthbuffer[se]=i.createRenderbuffer(),ci(w.__webglDepthbuffer[se],C,!1);else{let J=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ae=w.__webglDepthbuffer[se];i.bindRenderbuffer(i.RENDERBUFFER,ae),i.framebufferRenderbuffer(i.FRAMEBUFFER,J,i.RENDERBUFFER,ae)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),ci(w.__webglDepthbuffer,C,!1);else{let J=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ae=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ae),i.framebufferRenderbuffer(i.FRAMEBUFFER,J,i.RENDERBUFFER,ae)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Gn(C,w,B){let se=n.get(C);w!==void 0&&Mt(se.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),B!==void 0&&Vn(C)}function Hn(C){let w=C.texture,B=n.get(C),se=n.get(w);C.addEventListener("dispose",O),D(C);let J=C.textures,ae=C.isWebGLCubeRenderTarget===!0,de=J.length>1;if(de||(se.__webglTexture===void 0&&(se.__webglTexture=i.createTexture()),se.__version=w.version,o.memory.textures++),ae){B.__webglFramebuffer=[];for(let Y=0;Y<6;Y++)if(w.mipmaps.length>0){B.__webglFramebuffer[Y]=[];for(let j=0;j<w.mipmaps.length;j++)B.__webglFramebuffer[Y][j]=i.createFramebuffer()}else B.__webglFramebuffer[Y]=i.createFramebuffer()}else{if(w.mipmaps.length>0){B.__webglFramebuffer=[];for(let Y=0;Y<w.mipmaps.length;Y++)B.__webglFramebuffer[Y]=i.createFramebuffer()}else B.__webglFramebuffer=i.createFramebuffer();if(de)for(let Y=0,j=J.length;Y<j;Y++){let ce=n.get(J[Y]);ce.__webglTexture===void 0&&(ce.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&me(C)===!1){B.__webglMultisampledFramebuffer=i.createFramebuffer(),B.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,B.__webglMultisampledFramebuffer);for(let Y=0;Y<J.length;Y++){let j=J[Y];B.__webglColorRenderbuffer[Y]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,B.__webglColorRenderbuffer[Y]);let ce=r.convert(j.format,j.colorSpace),L=r.convert(j.type),K=R(j.internalFormat,ce,L,j.normalized,j.colorSpace,C.isXRRenderTarget===!0),q=wt(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,q,K,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Y,i.RENDERBUFFER,B.__webglColorRenderbuffer[Y])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(B.__webglDepthRenderbuffer=i.createRenderbuffer(),ci(B.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ae){t.bindTexture(i.TEXTURE_CUBE_MAP,se.__webglTexture),dt(i.TEXTURE_CUBE_MAP,w);for(let Y=0;Y<6;Y++)if(w.mipmaps.length>0)for(let j=0;j<w.mipmaps.length;j++)Mt(B.__webglFramebuffer[Y][j],C,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Y,j);else Mt(B.__webglFramebuffer[Y],C,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Y,0);S(w)?b(i.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(de){for(let Y=0,j=J.length;Y<j;Y++){let ce=J[Y],L=n.get(ce),K=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(K=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(K,L.__webglTexture),dt(K,ce),Mt(B.__webglFramebuffer,C,ce,i.COLOR_ATTACHMENT0+Y,K,0),S(ce)&&b(K)}t.unbindTexture()}else{let Y=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(Y=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Y,se.__webglTexture),dt(Y,w),w.mipmaps.length>0)for(let j=0;j<w.mipmaps.length;j++)Mt(B.__webglFramebuffer[j],C,w,i.COLOR_ATTACHMENT0,Y,j);else Mt(B.__webglFramebuffer,C,w,i.COLOR_ATTACHMENT0,Y,0);S(w)?b(Y):w.mipmaps.length>0&&i.texParameteri(Y,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&Vn(C)}function U(C){let w=C.textures;for(let B=0,se=w.length;B<se;B++){let J=w[B];if(S(J)&&J.mipmapsAutoUpdate===!0){let ae=A(C),de=n.get(J).__webglTexture;t.bindTexture(ae,de),b(ae),t.unbindTexture()}}}let Wn=[];function _t(C){if(C.samples>0){if(me(C)===!1){let w=C.textures,B=C.width,se=C.height,J=i.COLOR_BUFFER_BIT,ae=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,de=n.get(C),Y=w.length>1;if(Y)for(let ce=0;ce<w.length;ce++)t.bindFramebuffer(i.FRAMEBUFFER,de.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,de.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,de.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,de.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,de.__webglFramebuffer);for(let ce=0;ce<w.length;ce++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(J|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(J|=i.STENCIL_BUFFER_BIT)),Y){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,de.__webglColorRenderbuffer[ce]);let L=n.get(w[ce]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,L,0)}i.blitFramebuffer(0,0,B,se,0,0,B,se,J,i.NEAREST),l===!0&&(Wn.length=0,Wn.push(i.COLOR_ATTACHMENT0+ce),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Wn.push(ae),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Wn))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Y)for(let ce=0;ce<w.length;ce++){t.bindFramebuffer(i.FRAMEBUFFER,de.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.RENDERBUFFER,de.__webglColorRenderbuffer[ce]);let L=n.get(w[ce]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,de.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.TEXTURE_2D,L,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,de.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let w=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function wt(C){return Math.min(s.maxSamples,C.samples)}function me(C){let w=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Nt(C){let w=o.render.frame;h.get(C)!==w&&(h.set(C,w),C.update())}function Oe(C,w){let B=C.colorSpace,se=C.format,J=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||B!==Xo&&B!==Bi&&(it.getTransfer(B)===ht?(se!==oi||J!==En)&&Ne("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ze("WebGLTextures: Unsupported texture color space:",B)),w}function We(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=Be,this.resetTextureUnits=Q,this.getTextureUnits=te,this.setTextureUnits=we,this.setTexture2D=xe,this.setTexture2DArray=Se,this.setTexture3D=ke,this.setTextureCube=ve,this.rebindTextures=Gn,this.setupRenderTarget=Hn,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=_t,this.setupDepthRenderbuffer=Vn,this.setupFrameBufferTexture=Mt,this.useMultisampledRTT=me,this.dispose=G}function lT(i,e){function t(n,s=Bi){let r,o=it.getTransfer(s);if(n===En)return i.UNSIGNED_BYTE;if(n===Yc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Zc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===vf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===bf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===xf)return i.BYTE;if(n===yf)return i.SHORT;if(n===Zr)return i.UNSIGNED_SHORT;if(n===qc)return i.INT;if(n===si)return i.UNSIGNED_INT;if(n===Zn)return i.FLOAT;if(n===ri)return i.HALF_FLOAT;if(n===_f)return i.ALPHA;if(n===wf)return i.RGB;if(n===oi)return i.RGBA;if(n===Di)return i.DEPTH_COMPONENT;if(n===Fi)return i.DEPTH_STENCIL;if(n===jc)return i.RED;if(n===Kc)return i.RED_INTEGER;if(n===ls)return i.RG;if(n===Jc)return i.RG_INTEGER;if(n===Qc)return i.RGBA_INTEGER;if(n===ka||n===Oa||n===Ua||n===Fa)if(o===ht)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ka)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Oa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ua)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Fa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ka)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Oa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ua)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Fa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===eh||n===th||n===nh||n===ih)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===eh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===th)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===nh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ih)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===sh||n===rh||n===oh||n===ah||n===lh||n===Ba||n===ch)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===sh||n===rh)return o===ht?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===oh)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ah)return r.COMPRESSED_R11_EAC;if(n===lh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ba)return r.COMPRESSED_RG11_EAC;if(n===ch)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===hh||n===uh||n===dh||n===fh||n===ph||n===mh||n===gh||n===xh||n===yh||n===vh||n===bh||n===_h||n===wh||n===Mh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===hh)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===uh)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===dh)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===fh)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ph)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===mh)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===gh)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===xh)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===yh)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===vh)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===bh)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===_h)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===wh)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Mh)return o===ht?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Sh||n===Th||n===Eh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Sh)return o===ht?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Th)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Eh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ah||n===Rh||n===za||n===Ch)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Ah)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Rh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===za)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Ch)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Ws?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var cT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,hT=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,qf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new la(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Yn({vertexShader:cT,fragmentShader:hT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new ot(new Os(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Yf=class extends ni{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new qf,g={},y=t.getContextAttributes(),S=null,b=null,A=[],R=[],v=new ee,T=null,D=null,P=new pn;P.viewport=new ut;let k=new pn;k.viewport=new ut;let O=[P,k],V=new Hc,I=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Z){let xe=A[Z];return xe===void 0&&(xe=new kr,A[Z]=xe),xe.getTargetRaySpace()},this.getControllerGrip=function(Z){let xe=A[Z];return xe===void 0&&(xe=new kr,A[Z]=xe),xe.getGripSpace()},this.getHand=function(Z){let xe=A[Z];return xe===void 0&&(xe=new kr,A[Z]=xe),xe.getHandSpace()};function $(Z){let xe=R.indexOf(Z.inputSource);if(xe===-1)return;let Se=A[xe];Se!==void 0&&(Se.update(Z.inputSource,Z.frame,c||o),Se.dispatchEvent({type:Z.type,data:Z.inputSource}))}function H(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",ne);for(let Z=0;Z<A.length;Z++){let xe=R[Z];xe!==null&&(R[Z]=null,A[Z].disconnect(xe))}I=null,G=null,m.reset();for(let Z in g)delete g[Z];if(e.setRenderTarget(S),f=null,d=null,u=null,s=null,b=null,Be.stop(),n.isPresenting=!1,e.setPixelRatio(T),e.setSize(v.width,v.height,!1),D!==null){let Z=D.camera;Z.fov=D.fov,Z.zoom=D.zoom,Z.updateProjectionMatrix(),D=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Z){r=Z,n.isPresenting===!0&&Ne("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Z){a=Z,n.isPresenting===!0&&Ne("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Z){c=Z},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Z){if(s=Z,s!==null){if(S=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",H),s.addEventListener("inputsourceschange",ne),y.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(v),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let Se=null,ke=null,ve=null;y.depth&&(ve=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Se=y.stencil?Fi:Di,ke=y.stencil?Ws:si);let Ye={colorFormat:t.RGBA8,depthFormat:ve,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ye),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new Nn(d.textureWidth,d.textureHeight,{format:oi,type:En,depthTexture:new Ni(d.textureWidth,d.textureHeight,ke,void 0,void 0,void 0,void 0,void 0,void 0,Se),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let Se={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,Se),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new Nn(f.framebufferWidth,f.framebufferHeight,{format:oi,type:En,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Be.setContext(s),Be.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ne(Z){for(let xe=0;xe<Z.removed.length;xe++){let Se=Z.removed[xe],ke=R.indexOf(Se);ke>=0&&(R[ke]=null,A[ke].disconnect(Se))}for(let xe=0;xe<Z.added.length;xe++){let Se=Z.added[xe],ke=R.indexOf(Se);if(ke===-1){for(let Ye=0;Ye<A.length;Ye++)if(Ye>=R.length){R.push(Se),ke=Ye;break}else if(R[Ye]===null){R[Ye]=Se,ke=Ye;break}if(ke===-1)break}let ve=A[ke];ve&&ve.connect(Se)}}function X(Z,xe){xe===null?Z.matrixWorld.copy(Z.matrix):Z.matrixWorld.multiplyMatrices(xe.matrixWorld,Z.matrix),Z.matrixWorldInverse.copy(Z.matrixWorld).invert()}this.updateCamera=function(Z){if(s===null)return;let xe=Z.near,Se=Z.far;m.texture!==null&&(m.depthNear>0&&(xe=m.depthNear),m.depthFar>0&&(Se=m.depthFar)),V.near=k.near=P.near=xe,V.far=k.far=P.far=Se,(I!==V.near||G!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),I=V.near,G=V.far),V.layers.mask=Z.layers.mask|6,P.layers.mask=V.layers.mask&-5,k.layers.mask=V.layers.mask&-3;let ke=Z.parent,ve=V.cameras;X(V,ke);for(let Ye=0;Ye<ve.length;Ye++)X(ve[Ye],ke);V.projectionMatrix.copy(P.projectionMatrix),V.projectionMatrixInverse.copy(P.projectionMatrixInverse),D===null&&Z.isPerspectiveCamera&&(D={camera:Z,fov:Z.fov,zoom:Z.zoom}),Q(Z,V,ke)};function Q(Z,xe,Se){Se===null?Z.matrix.copy(xe.matrixWorld):(Z.matrix.copy(Se.matrixWorld),Z.matrix.invert(),Z.matrix.multiply(xe.matrixWorld)),Z.matrix.decompose(Z.position,Z.quaternion,Z.scale),Z.updateMatrixWorld(!0),Z.projectionMatrix.copy(xe.projectionMatrix),Z.projectionMatrixInverse.copy(xe.projectionMatrixInverse),Z.isPerspectiveCamera&&(Z.fov=Dr*2*Math.atan(1/Z.projectionMatrix.elements[5]),Z.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Z){l=Z,d!==null&&(d.fixedFoveation=Z),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Z)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(V)},this.getCameraTexture=function(Z){return g[Z]};let te=null;function we(Z,xe){if(h=xe.getViewerPose(c||o),p=xe,h!==null){let Se=h.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let ke=!1;Se.length!==V.cameras.length&&(V.cameras.length=0,ke=!0);for(let Ue=0;Ue<Se.length;Ue++){let dt=Se[Ue],gt=null;if(f!==null)gt=f.getViewport(dt);else{let Xt=u.getViewSubImage(d,dt);gt=Xt.viewport,Ue===0&&(e.setRenderTargetTextures(b,Xt.colorTexture,Xt.depthStencilTexture),e.setRenderTarget(b))}let et=O[Ue];et===void 0&&(et=new pn,et.layers.enable(Ue),et.viewport=new ut,O[Ue]=et),et.matrix.fromArray(dt.transform.matrix),et.matrix.decompose(et.position,et.quaternion,et.scale),et.projectionMatrix.fromArray(dt.projectionMatrix),et.projectionMatrixInverse.copy(et.projectionMatrix).invert(),et.viewport.set(gt.x,gt.y,gt.width,gt.height),Ue===0&&(V.matrix.copy(et.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),ke===!0&&V.cameras.push(et)}let ve=s.enabledFeatures;if(ve&&ve.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=n.getBinding();let Ue=u.getDepthInformation(Se[0]);Ue&&Ue.isValid&&Ue.texture&&m.init(Ue,s.renderState)}if(ve&&ve.includes("camera-access")&&x){e.state.unbindTexture(),u=n.getBinding();for(let Ue=0;Ue<Se.length;Ue++){let dt=Se[Ue].camera;if(dt){let gt=g[dt];gt||(gt=new la,g[dt]=gt);let et=u.getCameraImage(dt);gt.sourceTexture=et}}}}for(let Se=0;Se<A.length;Se++){let ke=R[Se],ve=A[Se];ke!==null&&ve!==void 0&&ve.update(ke,xe,c||o)}te&&te(Z,xe),xe.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:xe}),p=null}let Be=new U0;Be.setAnimationLoop(we),this.setAnimationLoop=function(Z){te=Z},this.dispose=function(){}}},uT=new Ie,q0=new He;q0.set(-1,0,0,0,1,0,0,0,1);function dT(i,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,kf(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,y,S,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,b)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,y,S):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===xn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===xn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let y=e.get(g),S=y.envMap,b=y.envMapRotation;S&&(m.envMap.value=S,m.envMapRotation.value.setFromMatrix4(uT.makeRotationFromEuler(b)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(q0),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,y,S){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*y,m.scale.value=S*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,y){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===xn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let y=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function fT(i,e,t,n){let s={},r={};function o(y,S){let b=S.program;n.uniformBlockBinding(y,b,s[y.id])}function a(y,S){let b=s[y.id];b===void 0&&(p(y),b=l(y),s[y.id]=b,y.addEventListener("dispose",m));let A=S.program;n.updateUBOMapping(y,A);let R=e.render.frame;r[y.id]!==R&&(c(y),r[y.id]=R)}function l(y){let S=i.createBuffer(),b=y.__size,A=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,S),i.bufferData(i.UNIFORM_BUFFER,b,A),i.bindBuffer(i.UNIFORM_BUFFER,null),S}function c(y){let S=s[y.id],b=y.uniforms,A=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let R=0,v=b.length;R<v;R++){let T=b[R];if(Array.isArray(T))for(let D=0,P=T.length;D<P;D++)h(T[D],R,D,A);else h(T,R,0,A)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(y,S,b,A){if(d(y,S,b,A)===!0){let R=y.__offset,v=y.value;if(Array.isArray(v)){let T=0;for(let D=0;D<v.length;D++){let P=v[D],k=x(P,!0);u(P,y.__data,T),T+=k.storage/Float32Array.BYTES_PER_ELEMENT}}else u(v,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,R,y.__data)}}function u(y,S,b){typeof y=="number"||typeof y=="boolean"?S[b]=y:y.isMatrix3?(S[b]=y.elements[0],S[b+1]=y.elements[1],S[b+2]=y.elements[2],S[b+3]=0,S[b+4]=y.elements[3],S[b+5]=y.elements[4],S[b+6]=y.elements[5],S[b+7]=0,S[b+8]=y.elements[6],S[b+9]=y.elements[7],S[b+10]=y.elements[8],S[b+11]=0):ArrayBuffer.isView(y)?S.set(y.subarray(0,S.length-b),b):y.toArray(S,b)}function d(y,S,b,A){let R=y.value,v=S+"_"+b;if(Array.isArray(R)){A[v]===void 0&&(A[v]=[]);let T=A[v],D=!1;for(let P=0;P<R.length;P++)f(R[P],T,P)===!0&&(D=!0);return D}return f(R,A,v)}function f(y,S,b){if(S[b]===void 0)return typeof y=="number"||typeof y=="boolean"?S[b]=y:ArrayBuffer.isView(y)?S[b]=y.slice():S[b]=y.clone(),!0;{let A=S[b];if(typeof y=="number"||typeof y=="boolean"){if(A!==y)return S[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(A.equals(y)===!1)return A.copy(y),!0}}return!1}function p(y){let S=y.uniforms,b=0,A=16;for(let v=0,T=S.length;v<T;v++){let D=Array.isArray(S[v])?S[v]:[S[v]];for(let P=0,k=D.length;P<k;P++){let O=D[P],V=Array.isArray(O.value)?O.value:[O.value],I=Array.isArray(S[v])||Array.isArray(O.value),G=b;for(let H=0,ne=V.length;H<ne;H++){let X=V[H],Q=x(X,I),te=b%A,we=te%Q.boundary,Be=te+we;b+=we,Be!==0&&A-Be<Q.storage&&(b+=A-Be),H===0&&(G=b),b+=Q.storage}let $=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new $((b-G)/Float32Array.BYTES_PER_ELEMENT),O.__offset=G}}let R=b%A;return R>0&&(b+=A-R),y.__size=b,y.__cache={},this}function x(y,S){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?Ne("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):Ne("WebGLRenderer: Unsupported uniform value type.",y),S===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(y){let S=y.target;S.removeEventListener("dispose",m),i.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function g(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:g}}var pT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),yi=null;function mT(){return yi===null&&(yi=new na(pT,16,16,ls,ri),yi.name="DFG_LUT",yi.minFilter=mn,yi.magFilter=mn,yi.wrapS=mi,yi.wrapT=mi,yi.generateMipmaps=!1,yi.needsUpdate=!0),yi}var Nh=class{constructor(e={}){let{canvas:t=s0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=En}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let x=f,m=new Set([Qc,Jc,Kc]),g=new Set([En,si,Zr,Ws,Yc,Zc]),y=new Uint32Array(4),S=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},A=null,R=null,v=[],T=[],D=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=xi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,k=!1,O=null,V=null,I=null,G=null;this._outputColorSpace=Zt;let $=0,H=0,ne=null,X=-1,Q=null,te=new ut,we=new ut,Be=null,Z=new Ae(0),xe=0,Se=t.width,ke=t.height,ve=1,Ye=null,Pt=null,Ue=new ut(0,0,Se,ke),dt=new ut(0,0,Se,ke),gt=!1,et=new Ji,Xt=new vc,Dt=!1,wn=!1,Mt=new Ie,ci=new E,Bt=new ut,Vn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Gn=!1;function Hn(){return ne===null?ve:1}let U=n;function Wn(M,N){return t.getContext(M,N)}let _t,wt,me,Nt,Oe,We,C,w,B,se,J,ae,de,Y,j,ce,L,K,q,he,oe,le,Ce;try{let M={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Le,!1),t.addEventListener("webglcontextrestored",je,!1),t.addEventListener("webglcontextcreationerror",ge,!1),U===null){let N="webgl2";if(U=Wn(N,M),U===null)throw Wn(N)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ke()}catch(M){throw t.removeEventListener("webglcontextlost",Le,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),ze("WebGLRenderer: "+M.message),M}function Ke(){_t=new ES(U),_t.init(),oe=new lT(U,_t),wt=new mS(U,_t,e,oe),me=new oT(U,_t),wt.reversedDepthBuffer&&d&&me.buffers.depth.setReversed(!0),V=U.createFramebuffer(),I=U.createFramebuffer(),G=U.createFramebuffer(),Nt=new CS(U),Oe=new X1,We=new aT(U,_t,me,Oe,wt,oe,Nt),C=new TS(P),w=new I_(U),le=new fS(U,w),B=new AS(U,w,Nt,le),se=new IS(U,B,w,le,Nt),K=new PS(U,wt,We),j=new gS(Oe),J=new $1(P,C,_t,wt,le,j),ae=new dT(P,Oe),de=new Y1,Y=new eT(_t),L=new dS(P,C,me,se,p,l),ce=new rT(P,se,wt),Ce=new fT(U,Nt,wt,me),q=new pS(U,_t,Nt),he=new RS(U,_t,Nt),Nt.programs=J.programs,P.capabilities=wt,P.extensions=_t,P.properties=Oe,P.renderLists=de,P.shadowMap=ce,P.state=me,P.info=Nt}x!==En&&(D=new DS(x,t.width,t.height,a,s,r));let re=new Yf(P,U);this.xr=re,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let M=_t.get("WEBGL_lose_context");M&&M.loseContext()},this.forceContextRestore=function(){let M=_t.get("WEBGL_lose_context");M&&M.restoreContext()},this.getPixelRatio=function(){return ve},this.setPixelRatio=function(M){M!==void 0&&(ve=M,this.setSize(Se,ke,!1))},this.getSize=function(M){return M.set(Se,ke)},this.setSize=function(M,N,W=!0){if(re.isPresenting){Ne("WebGLRenderer: Can't change size while VR device is presenting.");return}Se=M,ke=N,t.width=Math.floor(M*ve),t.height=Math.floor(N*ve),W===!0&&(t.style.width=M+"px",t.style.height=N+"px"),D!==null&&D.setSize(t.width,t.height),this.setViewport(0,0,M,N)},this.getDrawingBufferSize=function(M){return M.set(Se*ve,ke*ve).floor()},this.setDrawingBufferSize=function(M,N,W){Se=M,ke=N,ve=W,t.width=Math.floor(M*W),t.height=Math.floor(N*W),this.setViewport(0,0,M,N)},this.setEffects=function(M){if(x===En){ze("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(M){for(let N=0;N<M.length;N++)if(M[N].isOutputPass===!0){Ne("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(M||[])},this.getCurrentViewport=function(M){return M.copy(te)},this.getViewport=function(M){return M.copy(Ue)},this.setViewport=function(M,N,W,F){M.isVector4?Ue.set(M.x,M.y,M.z,M.w):Ue.set(M,N,W,F),me.viewport(te.copy(Ue).multiplyScalar(Hn()).round())},this.getScissor=function(M){return M.copy(dt)},this.setScissor=function(M,N,W,F){M.isVector4?dt.set(M.x,M.y,M.z,M.w):dt.set(M,N,W,F),me.scissor(we.copy(dt).multiplyScalar(Hn()).round())},this.getScissorTest=function(){return gt},this.setScissorTest=function(M){me.setScissorTest(gt=M)},this.setOpaqueSort=function(M){Ye=M},this.setTransparentSort=function(M){Pt=M},this.getClearColor=function(M){return M.copy(L.getClearColor())},this.setClearColor=function(){L.setClearColor(...arguments)},this.getClearAlpha=function(){return L.getClearAlpha()},this.setClearAlpha=function(){L.setClearAlpha(...arguments)},this.clear=function(M=!0,N=!0,W=!0){let F=0;if(M){let z=!1;if(ne!==null){let fe=ne.texture.format;z=m.has(fe)}if(z){let fe=ne.texture.type,Me=g.has(fe),ue=L.getClearColor(),be=L.getClearAlpha(),Re=ue.r,Xe=ue.g,tt=ue.b;Me?(y[0]=Re,y[1]=Xe,y[2]=tt,y[3]=be,U.clearBufferuiv(U.COLOR,0,y)):(S[0]=Re,S[1]=Xe,S[2]=tt,S[3]=be,U.clearBufferiv(U.COLOR,0,S))}else F|=U.COLOR_BUFFER_BIT}N&&(F|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),W&&(F|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F!==0&&U.clear(F)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(M){M.setRenderer(this),O=M},this.dispose=function(){t.removeEventListener("webglcontextlost",Le,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),L.dispose(),de.dispose(),Y.dispose(),We.dispose(),Oe.dispose(),C.dispose(),se.dispose(),B.dispose(),le.dispose(),Ce.dispose(),J.dispose(),re.dispose(),re.removeEventListener("sessionstart",Mm),re.removeEventListener("sessionend",Sm),ws.stop()};function Le(M){M.preventDefault(),Zo("WebGLRenderer: Context Lost."),k=!0}function je(){Zo("WebGLRenderer: Context Restored."),k=!1;let M=Nt.autoReset,N=ce.enabled,W=ce.autoUpdate,F=ce.needsUpdate,z=ce.type;Ke(),Nt.autoReset=M,ce.enabled=N,ce.autoUpdate=W,ce.needsUpdate=F,ce.type=z}function ge(M){ze("WebGLRenderer: A WebGL context could not be created. Reason: ",M.statusMessage)}function ft(M){let N=M.target;N.removeEventListener("dispose",ft),zt(N)}function zt(M){$i(M),Oe.remove(M)}function $i(M){let N=Oe.get(M).programs;N!==void 0&&(N.forEach(function(W){J.releaseProgram(W)}),M.isShaderMaterial&&J.releaseShaderCache(M))}this.renderBufferDirect=function(M,N,W,F,z,fe){N===null&&(N=Vn);let Me=z.isMesh&&z.matrixWorld.determinantAffine()<0,ue=Qv(M,N,W,F,z);me.setMaterial(F,Me);let be=W.index,Re=1;if(F.wireframe===!0){if(be=B.getWireframeAttribute(W),be===void 0)return;Re=2}let Xe=W.drawRange,tt=W.attributes.position,Te=Xe.start*Re,nt=(Xe.start+Xe.count)*Re;fe!==null&&(Te=Math.max(Te,fe.start*Re),nt=Math.min(nt,(fe.start+fe.count)*Re)),be!==null?(Te=Math.max(Te,0),nt=Math.min(nt,be.count)):tt!=null&&(Te=Math.max(Te,0),nt=Math.min(nt,tt.count));let It=nt-Te;if(It<0||It===1/0)return;le.setup(z,F,ue,W,be);let vt,xt=q;if(be!==null&&(vt=w.get(be),xt=he,xt.setIndex(vt)),z.isMesh)F.wireframe===!0?(me.setLineWidth(F.wireframeLinewidth*Hn()),xt.setMode(U.LINES)):xt.setMode(U.TRIANGLES);else if(z.isLine){let en=F.linewidth;en===void 0&&(en=1),me.setLineWidth(en*Hn()),z.isLineSegments?xt.setMode(U.LINES):z.isLineLoop?xt.setMode(U.LINE_LOOP):xt.setMode(U.LINE_STRIP)}else z.isPoints?xt.setMode(U.POINTS):z.isSprite&&xt.setMode(U.TRIANGLES);if(z.isBatchedMesh)if(_t.get("WEBGL_multi_draw"))xt.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{let en=z._multiDrawStarts,Ee=z._multiDrawCounts,dn=z._multiDrawCount,at=be?w.get(be).bytesPerElement:1,Ms=Oe.get(F).currentProgram.getUniforms();for(let tn=0;tn<dn;tn++)Ms.setValue(U,"_gl_DrawID",tn),xt.render(en[tn]/at,Ee[tn])}else if(z.isInstancedMesh)xt.renderInstances(Te,It,z.count);else if(W.isInstancedBufferGeometry){let en=W._maxInstanceCount!==void 0?W._maxInstanceCount:1/0,Ee=Math.min(W.instanceCount,en);xt.renderInstances(Te,It,Ee)}else xt.render(Te,It)};function wm(M,N,W,F){O!==null&&M.isNodeMaterial&&O.setObject(F,M),Dt===!0&&j.setState(M,W,!1),M.transparent===!0&&M.side===yn&&M.forceSinglePass===!1?(M.side=xn,M.needsUpdate=!0,Ao(M,N,F),M.side=as,M.needsUpdate=!0,Ao(M,N,F),M.side=yn):Ao(M,N,F)}this.compile=function(M,N,W=null){W===null&&(W=M),O!==null&&O.renderStart(M,N,W),R=Y.get(W),R.init(N),T.push(R),W.traverseVisible(function(z){z.isLight&&z.layers.test(N.layers)&&(R.pushLight(z),z.castShadow&&R.pushShadow(z))}),M!==W&&M.traverseVisible(function(z){z.isLight&&z.layers.test(N.layers)&&(R.pushLight(z),z.castShadow&&R.pushShadow(z))}),R.setupLights(),O!==null&&O.updateLights(R.state.lightsArray),wn=this.localClippingEnabled,Dt=j.init(this.clippingPlanes,wn),Dt===!0&&j.setGlobalState(this.clippingPlanes,N),O!==null&&ce.render(R.state.shadowsArray,W,N);let F=new Set;return M.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;let fe=z.material;if(fe)if(Array.isArray(fe))for(let Me=0;Me<fe.length;Me++){let ue=fe[Me];wm(ue,W,N,z),F.add(ue)}else wm(fe,W,N,z),F.add(fe)}),R=T.pop(),O!==null&&O.renderEnd(),F},this.compileAsync=function(M,N,W=null){let F=this.compile(M,N,W);return new Promise(z=>{function fe(){if(F.forEach(function(Me){let be=Oe.get(Me).currentProgram;(be===void 0||be.isReady())&&F.delete(Me)}),F.size===0){z(M);return}setTimeout(fe,10)}_t.get("KHR_parallel_shader_compile")!==null?fe():setTimeout(fe,10)})};let gd=null;function Kv(M){gd&&gd(M)}function Mm(){ws.stop()}function Sm(){ws.start()}let ws=new U0;ws.setAnimationLoop(Kv),typeof self<"u"&&ws.setContext(self),this.setAnimationLoop=function(M){gd=M,re.setAnimationLoop(M),M===null?ws.stop():ws.start()},re.addEventListener("sessionstart",Mm),re.addEventListener("sessionend",Sm),this.render=function(M,N){if(N!==void 0&&N.isCamera!==!0){ze("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(k===!0)return;O!==null&&O.renderStart(M,N);let W=re.enabled===!0&&re.isPresenting===!0,F=D!==null&&(ne===null||W)&&D.begin(P,ne);if(M.matrixWorldAutoUpdate===!0&&M.updateMatrixWorld(),N.parent===null&&N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),re.enabled===!0&&re.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(re.cameraAutoUpdate===!0&&re.updateCamera(N),N=re.getCamera()),M.isScene===!0&&M.onBeforeRender(P,M,N,ne),R=Y.get(M,T.length),R.init(N),R.state.textureUnits=We.getTextureUnits(),T.push(R),Mt.multiplyMatrices(N.projectionMatrix,N.matrixWorldInverse),N.isArrayCamera?Xt.setFromArrayCamera(N):et.setFromProjectionMatrix(Mt,qn,N.reversedDepth),wn=this.localClippingEnabled,Dt=j.init(this.clippingPlanes,wn),A=de.get(M,v.length),A.init(),v.push(A),this.info.render.frame++,re.enabled===!0&&re.isPresenting===!0){let Me=P.xr.getDepthSensingMesh();Me!==null&&xd(Me,N,-1/0,P.sortObjects)}xd(M,N,0,P.sortObjects),A.finish(),O!==null&&O.updateLights(R.state.lightsArray),P.sortObjects===!0&&A.sort(Ye,Pt),Gn=re.enabled===!1||re.isPresenting===!1||re.hasDepthSensing()===!1,Gn&&L.addToRenderList(A,M),this.info.autoReset===!0&&this.info.reset(),Dt===!0&&j.beginShadows();let z=R.state.shadowsArray;if(ce.render(z,M,N),Dt===!0&&j.endShadows(),(F&&D.hasRenderPass())===!1){let Me=A.opaque,ue=A.transmissive;if(R.setupLights(),N.isArrayCamera){let be=N.cameras;if(ue.length>0)for(let Re=0,Xe=be.length;Re<Xe;Re++){let tt=be[Re];Em(Me,ue,M,tt)}Gn&&L.render(M);for(let Re=0,Xe=be.length;Re<Xe;Re++){let tt=be[Re];Tm(A,M,tt,tt.viewport)}}else ue.length>0&&Em(Me,ue,M,N),Gn&&L.render(M),Tm(A,M,N)}ne!==null&&H===0&&(We.updateMultisampleRenderTarget(ne),We.updateRenderTargetMipmap(ne)),F&&D.end(P),M.isScene===!0&&M.onAfterRender(P,M,N),le.resetDefaultState(),X=-1,Q=null,T.pop(),T.length>0?(R=T[T.length-1],We.setTextureUnits(R.state.textureUnits),Dt===!0&&j.setGlobalState(P.clippingPlanes,R.state.camera)):R=null,v.pop(),v.length>0?A=v[v.length-1]:A=null,O!==null&&O.renderEnd()};function xd(M,N,W,F){if(M.visible===!1)return;if(M.layers.test(N.layers)){if(M.isGroup)W=M.renderOrder;else if(M.isLOD)M.autoUpdate===!0&&M.update(N);else if(M.isLight)R.pushLight(M),M.castShadow&&R.pushShadow(M);else if(M.isSprite){let Me=N.isArrayCamera?Xt:et;if(!M.frustumCulled||M.intersectsFrustum(Me)){F&&Bt.setFromMatrixPosition(M.matrixWorld).applyMatrix4(Mt);let ue=se.update(M),be=M.material;be.visible&&A.push(M,ue,be,W,Bt.z,null,N)}}else if(M.isMesh||M.isLine||M.isPoints){let Me=N.isArrayCamera?Xt:et;if(!M.frustumCulled||M.intersectsFrustum(Me)){let ue=se.update(M),be=M.material;if(F&&(M.boundingSphere!==void 0?(M.boundingSphere===null&&M.computeBoundingSphere(),Bt.copy(M.boundingSphere.center)):(ue.boundingSphere===null&&ue.computeBoundingSphere(),Bt.copy(ue.boundingSphere.center)),Bt.applyMatrix4(M.matrixWorld).applyMatrix4(Mt)),Array.isArray(be)){let Re=ue.groups;for(let Xe=0,tt=Re.length;Xe<tt;Xe++){let Te=Re[Xe],nt=be[Te.materialIndex];nt&&nt.visible&&A.push(M,ue,nt,W,Bt.z,Te,N)}}else be.visible&&A.push(M,ue,be,W,Bt.z,null,N)}}}let fe=M.children;for(let Me=0,ue=fe.length;Me<ue;Me++)xd(fe[Me],N,W,F)}function Tm(M,N,W,F){let{opaque:z,transmissive:fe,transparent:Me}=M;R.setupLightsView(W),Dt===!0&&j.setGlobalState(P.clippingPlanes,W),F&&me.viewport(te.copy(F)),z.length>0&&_l(z,N,W),fe.length>0&&_l(fe,N,W),Me.length>0&&_l(Me,N,W),me.buffers.depth.setTest(!0),me.buffers.depth.setMask(!0),me.buffers.color.setMask(!0),me.setPolygonOffset(!1)}function Em(M,N,W,F){if((W.isScene===!0?W.overrideMaterial:null)!==null)return;if(R.state.transmissionRenderTarget[F.id]===void 0){let Te=_t.has("EXT_color_buffer_half_float")||_t.has("EXT_color_buffer_float");R.state.transmissionRenderTarget[F.id]=new Nn(1,1,{generateMipmaps:!0,type:Te?ri:En,minFilter:Ui,samples:Math.max(4,wt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:it.workingColorSpace})}let fe=R.state.transmissionRenderTarget[F.id],Me=F.viewport||te;fe.setSize(Me.z*P.transmissionResolutionScale,Me.w*P.transmissionResolutionScale);let ue=P.getRenderTarget(),be=P.getActiveCubeFace(),Re=P.getActiveMipmapLevel();P.setRenderTarget(fe),P.getClearColor(Z),xe=P.getClearAlpha(),xe<1&&P.setClearColor(16777215,.5),P.clear(),Gn&&L.render(W);let Xe=P.toneMapping;P.toneMapping=xi;let tt=F.viewport;if(F.viewport!==void 0&&(F.viewport=void 0),R.setupLightsView(F),Dt===!0&&j.setGlobalState(P.clippingPlanes,F),_l(M,W,F),We.updateMultisampleRenderTarget(fe),We.updateRenderTargetMipmap(fe),_t.has("WEBGL_multisampled_render_to_texture")===!1){let Te=!1;for(let nt=0,It=N.length;nt<It;nt++){let vt=N[nt],{object:xt,geometry:en,material:Ee,group:dn}=vt;if(Ee.side===yn&&xt.layers.test(F.layers)){let at=Ee.side;Ee.side=xn,Ee.needsUpdate=!0,Am(xt,W,F,en,Ee,dn),Ee.side=at,Ee.needsUpdate=!0,Te=!0}}Te===!0&&(We.updateMultisampleRenderTarget(fe),We.updateRenderTargetMipmap(fe))}P.setRenderTarget(ue,be,Re),P.setClearColor(Z,xe),tt!==void 0&&(F.viewport=tt),P.toneMapping=Xe}function _l(M,N,W){let F=N.isScene===!0?N.overrideMaterial:null;for(let z=0,fe=M.length;z<fe;z++){let Me=M[z],{object:ue,geometry:be,group:Re}=Me,Xe=Me.material;Xe.allowOverride===!0&&F!==null&&(Xe=F),ue.layers.test(W.layers)&&Am(ue,N,W,be,Xe,Re)}}function Am(M,N,W,F,z,fe){O!==null&&z.isNodeMaterial&&O.setObject(M,z),M.onBeforeRender(P,N,W,F,z,fe),M.modelViewMatrix.multiplyMatrices(W.matrixWorldInverse,M.matrixWorld),M.normalMatrix.getNormalMatrix(M.modelViewMatrix),z.onBeforeRender(P,N,W,F,M,fe),z.transparent===!0&&z.side===yn&&z.forceSinglePass===!1?(z.side=xn,z.needsUpdate=!0,P.renderBufferDirect(W,N,F,z,M,fe),z.side=as,z.needsUpdate=!0,P.renderBufferDirect(W,N,F,z,M,fe),z.side=yn):P.renderBufferDirect(W,N,F,z,M,fe),M.onAfterRender(P,N,W,F,z,fe)}function Rm(M){let N=0;for(let W of M)W.texture!==null&&N++;return N}function Ao(M,N,W){N.isScene!==!0&&(N=Vn);let F=Oe.get(M),z=R.state.lights,fe=R.state.shadowsArray,Me=z.state.version,ue=J.getParameters(M,z.state,fe,N,W,R.state.lightProbeGridArray),be=J.getProgramCacheKey(ue),Re=F.programs;F.environment=M.isMeshStandardMaterial||M.isMeshLambertMaterial||M.isMeshPhongMaterial?N.environment:null,F.fog=N.fog;let Xe=M.isMeshStandardMaterial||M.isMeshLambertMaterial&&!M.envMap||M.isMeshPhongMaterial&&!M.envMap;F.envMap=C.get(M.envMap||F.environment,Xe),F.envMapRotation=F.environment!==null&&M.envMap===null?N.environmentRotation:M.envMapRotation,Re===void 0&&(M.addEventListener("dispose",ft),Re=new Map,F.programs=Re,F.programVariants=new Map);let tt=Re.get(be);if(tt!==void 0){if(F.currentProgram===tt&&F.lightsStateVersion===Me)return Pm(M,ue),tt}else ue.uniforms=J.getUniforms(M),O!==null&&M.isNodeMaterial&&O.build(M,W,ue),M.onBeforeCompile(ue,P),tt=J.acquireProgram(ue,be),Re.set(be,tt),F.uniforms=ue.uniforms;let Te=F.uniforms;return(!M.isShaderMaterial&&!M.isRawShaderMaterial||M.clipping===!0)&&(Te.clippingPlanes=j.uniform),Pm(M,ue),F.needsLights=tb(M),F.lightsStateVersion=Me,F.needsLights&&(Te.ambientLightColor.value=z.state.ambient,Te.lightProbe.value=z.state.probe,Te.sunLights.value=z.state.sun,Te.sunLightShadows.value=z.state.sunShadow,Te.directionalLights.value=z.state.directional,Te.directionalLightShadows.value=z.state.directionalShadow,Te.spotLights.value=z.state.spot,Te.spotLightShadows.value=z.state.spotShadow,Te.rectAreaLights.value=z.state.rectArea,Te.ltc_1.value=z.state.rectAreaLTC1,Te.ltc_2.value=z.state.rectAreaLTC2,Te.pointLights.value=z.state.point,Te.pointLightShadows.value=z.state.pointShadow,Te.hemisphereLights.value=z.state.hemi,Te.sunShadowMatrix.value=z.state.sunShadowMatrix,Te.sunShadowCascade.value=z.state.sunShadowCascade,Te.directionalShadowMatrix.value=z.state.directionalShadowMatrix,Te.spotLightMatrix.value=z.state.spotLightMatrix,Te.spotLightMap.value=z.state.spotLightMap,Te.pointShadowMatrix.value=z.state.pointShadowMatrix),F.numLightProbeGrids=Rm(R.state.lightProbeGridArray),F.currentProgram=tt,F.uniformsList=null,tt}function Jv(M,N,W,F,z){let fe=Oe.get(M),Me=fe.currentProgram.id+","+F+","+z,ue=fe.programVariants.get(Me);return ue===void 0?(ue=Ao(M,N,W),fe.programVariants.set(Me,ue)):(fe.currentProgram=ue,fe.uniformsList=null,fe.outputColorSpace=F,fe.toneMapping=z),ue}function Cm(M){if(M.uniformsList===null){let N=M.currentProgram.getUniforms();M.uniformsList=Jr.seqWithValue(N.seq,M.uniforms)}return M.uniformsList}function Pm(M,N){let W=Oe.get(M);W.outputColorSpace=N.outputColorSpace,W.batching=N.batching,W.batchingColor=N.batchingColor,W.instancing=N.instancing,W.instancingColor=N.instancingColor,W.instancingMorph=N.instancingMorph,W.skinning=N.skinning,W.morphTargets=N.morphTargets,W.morphNormals=N.morphNormals,W.morphColors=N.morphColors,W.morphTargetsCount=N.morphTargetsCount,W.numClippingPlanes=N.numClippingPlanes,W.numIntersection=N.numClipIntersection,W.vertexAlphas=N.vertexAlphas,W.vertexTangents=N.vertexTangents,W.toneMapping=N.toneMapping}function Qv(M,N,W,F,z){N.isScene!==!0&&(N=Vn),We.resetTextureUnits();let fe=N.fog,Me=F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial?N.environment:null,ue=ne===null?P.outputColorSpace:ne.isXRRenderTarget===!0?ne.texture.colorSpace:it.workingColorSpace,be=F.isMeshStandardMaterial||F.isMeshLambertMaterial&&!F.envMap||F.isMeshPhongMaterial&&!F.envMap,Re=C.get(F.envMap||Me,be),Xe=F.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,tt=!!W.attributes.tangent&&(!!F.normalMap||F.anisotropy>0),Te=!!W.morphAttributes.position,nt=!!W.morphAttributes.normal,It=!!W.morphAttributes.color,vt=xi;F.toneMapped&&(ne===null||ne.isXRRenderTarget===!0)&&(vt=P.toneMapping);let xt=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,en=xt!==void 0?xt.length:0,Ee=Oe.get(F),dn=R.state.lights;if(Dt===!0&&(wn===!0||M!==Q)){let St=M===Q&&F.id===X;j.setState(F,M,St)}let at=!1,Ms=!1;F.version===Ee.__version?Ee.needsLights&&Ee.lightsStateVersion!==dn.state.version||z.isBatchedMesh&&Ee.batching===!1||!z.isBatchedMesh&&Ee.batching===!0||z.isBatchedMesh&&Ee.batchingColor===!0&&z._colorsTexture===null||z.isBatchedMesh&&Ee.batchingColor===!1&&z._colorsTexture!==null||z.isInstancedMesh&&Ee.instancing===!1||!z.isInstancedMesh&&Ee.instancing===!0||z.isSkinnedMesh&&Ee.skinning===!1||!z.isSkinnedMesh&&Ee.skinning===!0||z.isInstancedMesh&&Ee.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&Ee.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&Ee.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&Ee.instancingMorph===!1&&z.morphTexture!==null||Ee.envMap!==Re||F.fog===!0&&Ee.fog!==fe||Ee.numClippingPlanes!==void 0&&(Ee.numClippingPlanes!==j.numPlanes||Ee.numIntersection!==j.numIntersection)||Ee.vertexAlphas!==Xe||Ee.vertexTangents!==tt||Ee.morphTargets!==Te||Ee.morphNormals!==nt||Ee.morphColors!==It||Ee.morphTargetsCount!==en||Ee.numLightProbeGrids!==Rm(R.state.lightProbeGridArray)?at=!0:(Ee.outputColorSpace!==ue||Ee.toneMapping!==vt)&&(Ms=!0):(at=!0,Ee.__version=F.version);let tn=Ee.currentProgram;(at===!0||Ms===!0)&&(tn=Ms===!0?Jv(F,N,z,ue,vt):Ao(F,N,z),O&&F.isNodeMaterial&&O.onUpdateProgram(F,tn,Ee));let wl=!1,Xi=!1,Ss=!1,st=tn.getUniforms(),qt=Ee.uniforms;if(me.useProgram(tn.program)&&(wl=!0,Xi=!0,Ss=!0),F.id!==X&&(X=F.id,Xi=!0),wl||Q!==M){me.buffers.depth.getReversed()&&M.reversedDepth!==!0&&(M._reversedDepth=!0,M.updateProjectionMatrix()),st.setValue(U,"projectionMatrix",M.projectionMatrix),st.setValue(U,"viewMatrix",M.matrixWorldInverse);let Vt=st.map.cameraPosition;Vt!==void 0&&Vt.setValue(U,ci.setFromMatrixPosition(M.matrixWorld)),wt.logarithmicDepthBuffer&&st.setValue(U,"logDepthBufFC",2/(Math.log(M.far+1)/Math.LN2)),(F.isMeshPhongMaterial||F.isMeshToonMaterial||F.isMeshLambertMaterial||F.isMeshBasicMaterial||F.isMeshStandardMaterial||F.isShaderMaterial)&&st.setValue(U,"isOrthographic",M.isOrthographicCamera===!0),Q!==M&&(Q=M,Xi=!0,Ss=!0)}if(Ee.needsLights&&(dn.state.sunShadowMap.length>0&&st.setValue(U,"sunShadowMap",dn.state.sunShadowMap,We),dn.state.directionalShadowMap.length>0&&st.setValue(U,"directionalShadowMap",dn.state.directionalShadowMap,We),dn.state.spotShadowMap.length>0&&st.setValue(U,"spotShadowMap",dn.state.spotShadowMap,We),dn.state.pointShadowMap.length>0&&st.setValue(U,"pointShadowMap",dn.state.pointShadowMap,We)),z.isSkinnedMesh){st.setOptional(U,z,"bindMatrix"),st.setOptional(U,z,"bindMatrixInverse");let St=z.skeleton;St&&(St.boneTexture===null&&St.computeBoneTexture(),st.setValue(U,"boneTexture",St.boneTexture,We))}z.isBatchedMesh&&(st.setOptional(U,z,"batchingTexture"),st.setValue(U,"batchingTexture",z._matricesTexture,We),st.setOptional(U,z,"batchingIdTexture"),st.setValue(U,"batchingIdTexture",z._indirectTexture,We),st.setOptional(U,z,"batchingColorTexture"),z._colorsTexture!==null&&st.setValue(U,"batchingColorTexture",z._colorsTexture,We));let Kn=W.morphAttributes;if((Kn.position!==void 0||Kn.normal!==void 0||Kn.color!==void 0)&&K.update(z,W,tn),(Xi||Ee.receiveShadow!==z.receiveShadow)&&(Ee.receiveShadow=z.receiveShadow,st.setValue(U,"receiveShadow",z.receiveShadow)),(F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial)&&F.envMap===null&&N.environment!==null&&(qt.envMapIntensity.value=N.environmentIntensity),qt.dfgLUT!==void 0&&(qt.dfgLUT.value=mT()),Xi){if(st.setValue(U,"toneMappingExposure",P.toneMappingExposure),Ee.needsLights&&eb(qt,Ss),fe&&F.fog===!0&&ae.refreshFogUniforms(qt,fe),ae.refreshMaterialUniforms(qt,F,ve,ke,R.state.transmissionRenderTarget[M.id]),Ee.needsLights&&Ee.numLightProbeGrids>0){let St=b,Vt=0;for(let Ei of R.state.lightProbeGridArray)Ei.texture!==null&&(St.textures[Vt]=Ei.texture,St.min[Vt]=Ei.boundingBox.min,St.max[Vt]=Ei.boundingBox.max,St.resolution[Vt]=Ei.resolution,Vt++);for(let Ei in St)St[Ei].length=Vt;qt.probesSH.value=St.textures,qt.probesMin.value=St.min,qt.probesMax.value=St.max,qt.probesResolution.value=St.resolution}Jr.upload(U,Cm(Ee),qt,We)}if(F.isShaderMaterial&&F.uniformsNeedUpdate===!0&&(Jr.upload(U,Cm(Ee),qt,We),F.uniformsNeedUpdate=!1),F.isSpriteMaterial&&st.setValue(U,"center",z.center),st.setValue(U,"modelViewMatrix",z.modelViewMatrix),st.setValue(U,"normalMatrix",z.normalMatrix),st.setValue(U,"modelMatrix",z.matrixWorld),F.uniformsGroups!==void 0){let St=F.uniformsGroups;for(let Vt=0,Ei=St.length;Vt<Ei;Vt++){let Lm=St[Vt];Ce.update(Lm,tn),Ce.bind(Lm,tn)}}return tn}function eb(M,N){M.ambientLightColor.needsUpdate=N,M.lightProbe.needsUpdate=N,M.sunLights.needsUpdate=N,M.sunLightShadows.needsUpdate=N,M.directionalLights.needsUpdate=N,M.directionalLightShadows.needsUpdate=N,M.pointLights.needsUpdate=N,M.pointLightShadows.needsUpdate=N,M.spotLights.needsUpdate=N,M.spotLightShadows.needsUpdate=N,M.rectAreaLights.needsUpdate=N,M.hemisphereLights.needsUpdate=N}function tb(M){return M.isMeshLambertMaterial||M.isMeshToonMaterial||M.isMeshPhongMaterial||M.isMeshStandardMaterial||M.isShadowMaterial||M.isShaderMaterial&&M.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ne},this.setRenderTargetTextures=function(M,N,W){let F=Oe.get(M);F.__autoAllocateDepthBuffer=M.resolveDepthBuffer===!1,F.__autoAllocateDepthBuffer===!1&&(F.__useRenderToTexture=!1),Oe.get(M.texture).__webglTexture=N,Oe.get(M.depthTexture).__webglTexture=F.__autoAllocateDepthBuffer?void 0:W,F.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(M,N){let W=Oe.get(M);W.__webglFramebuffer=N,W.__useDefaultFramebuffer=N===void 0},this.setRenderTarget=function(M,N=0,W=0){ne=M,$=N,H=W;let F=null,z=!1,fe=!1;if(M){let ue=Oe.get(M);if(ue.__useDefaultFramebuffer!==void 0){me.bindFramebuffer(U.FRAMEBUFFER,ue.__webglFramebuffer),te.copy(M.viewport),we.copy(M.scissor),Be=M.scissorTest,me.viewport(te),me.scissor(we),me.setScissorTest(Be),X=-1;return}else if(ue.__webglFramebuffer===void 0)We.setupRenderTarget(M);else if(ue.__hasExternalTextures)We.rebindTextures(M,Oe.get(M.texture).__webglTexture,Oe.get(M.depthTexture).__webglTexture);else if(M.depthBuffer){let Xe=M.depthTexture;if(ue.__boundDepthTexture!==Xe){if(Xe!==null&&Oe.has(Xe)&&(M.width!==Xe.image.width||M.height!==Xe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");We.setupDepthRenderbuffer(M)}}let be=M.texture;(be.isData3DTexture||be.isDataArrayTexture||be.isCompressedArrayTexture)&&(fe=!0);let Re=Oe.get(M).__webglFramebuffer;M.isWebGLCubeRenderTarget?(Array.isArray(Re[N])?F=Re[N][W]:F=Re[N],z=!0):M.samples>0&&We.useMultisampledRTT(M)===!1?F=Oe.get(M).__webglMultisampledFramebuffer:Array.isArray(Re)?F=Re[W]:F=Re,te.copy(M.viewport),we.copy(M.scissor),Be=M.scissorTest}else te.copy(Ue).multiplyScalar(ve).floor(),we.copy(dt).multiplyScalar(ve).floor(),Be=gt;if(W!==0&&(F=V),me.bindFramebuffer(U.FRAMEBUFFER,F)&&me.drawBuffers(M,F),me.viewport(te),me.scissor(we),me.setScissorTest(Be),z){let ue=Oe.get(M.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+N,ue.__webglTexture,W)}else if(fe){let ue=N;for(let be=0;be<M.textures.length;be++){let Re=Oe.get(M.textures[be]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+be,Re.__webglTexture,W,ue)}}else if(M!==null&&W!==0){let ue=Oe.get(M.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,ue.__webglTexture,W)}X=-1};function Im(M){let N=Oe.get(M);return(N.__readFormat!==M.format||N.__readType!==M.type)&&(N.__readFormat=M.format,N.__readType=M.type,N.__formatReadable=wt.textureFormatReadable(M.format),N.__typeReadable=wt.textureTypeReadable(M.type)),N}this.readRenderTargetPixels=function(M,N,W,F,z,fe,Me,ue=0){if(!(M&&M.isWebGLRenderTarget)){ze("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let be=Oe.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&Me!==void 0&&(be=be[Me],Array.isArray(be)&&(be=be[0])),be){me.bindFramebuffer(U.FRAMEBUFFER,be);try{let Re=M.textures[ue],Xe=Re.format,tt=Re.type;M.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+ue);let Te=Im(Re);if(Te.__formatReadable===!1){ze("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Te.__typeReadable===!1){ze("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}N>=0&&N<=M.width-F&&W>=0&&W<=M.height-z&&U.readPixels(N,W,F,z,oe.convert(Xe),oe.convert(tt),fe)}finally{let Re=ne!==null?Oe.get(ne).__webglFramebuffer:null;me.bindFramebuffer(U.FRAMEBUFFER,Re)}}},this.readRenderTargetPixelsAsync=async function(M,N,W,F,z,fe,Me,ue=0){if(!(M&&M.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let be=Oe.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&Me!==void 0&&(be=be[Me],Array.isArray(be)&&(be=be[0])),be)if(N>=0&&N<=M.width-F&&W>=0&&W<=M.height-z){me.bindFramebuffer(U.FRAMEBUFFER,be);let Re=M.textures[ue],Xe=Re.format,tt=Re.type;M.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+ue);let Te=Im(Re);if(Te.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Te.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let nt=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,nt),U.bufferData(U.PIXEL_PACK_BUFFER,fe.byteLength,U.STREAM_READ),U.readPixels(N,W,F,z,oe.convert(Xe),oe.convert(tt),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let It=ne!==null?Oe.get(ne).__webglFramebuffer:null;me.bindFramebuffer(U.FRAMEBUFFER,It);let vt=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await o0(U,vt,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,nt),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,fe),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(nt),U.deleteSync(vt),fe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(M,N=null,W=0){let F=Math.pow(2,-W),z=Math.floor(M.image.width*F),fe=Math.floor(M.image.height*F),Me=N!==null?N.x:0,ue=N!==null?N.y:0;We.setTexture2D(M,0),U.copyTexSubImage2D(U.TEXTURE_2D,W,0,0,Me,ue,z,fe),me.unbindTexture()},this.copyTextureToTexture=function(M,N,W=null,F=null,z=0,fe=0){let Me,ue,be,Re,Xe,tt,Te,nt,It,vt=M.isCompressedTexture?M.mipmaps[fe]:M.image;if(W!==null)Me=W.max.x-W.min.x,ue=W.max.y-W.min.y,be=W.isBox3?W.max.z-W.min.z:1,Re=W.min.x,Xe=W.min.y,tt=W.isBox3?W.min.z:0;else{let st=Math.pow(2,-z);Me=Math.floor(vt.width*st),ue=Math.floor(vt.height*st),M.isDataArrayTexture?be=vt.depth:M.isData3DTexture?be=Math.floor(vt.depth*st):be=1,Re=0,Xe=0,tt=0}F!==null?(Te=F.x,nt=F.y,It=F.z):(Te=0,nt=0,It=0);let xt=oe.convert(N.format),en=oe.convert(N.type),Ee;N.isData3DTexture?(We.setTexture3D(N,0),Ee=U.TEXTURE_3D):N.isDataArrayTexture||N.isCompressedArrayTexture?(We.setTexture2DArray(N,0),Ee=U.TEXTURE_2D_ARRAY):(We.setTexture2D(N,0),Ee=U.TEXTURE_2D),me.activeTexture(U.TEXTURE0),me.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,N.flipY),me.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,N.premultiplyAlpha),me.pixelStorei(U.UNPACK_ALIGNMENT,N.unpackAlignment);let dn=me.getParameter(U.UNPACK_ROW_LENGTH),at=me.getParameter(U.UNPACK_IMAGE_HEIGHT),Ms=me.getParameter(U.UNPACK_SKIP_PIXELS),tn=me.getParameter(U.UNPACK_SKIP_ROWS),wl=me.getParameter(U.UNPACK_SKIP_IMAGES);me.pixelStorei(U.UNPACK_ROW_LENGTH,vt.width),me.pixelStorei(U.UNPACK_IMAGE_HEIGHT,vt.height),me.pixelStorei(U.UNPACK_SKIP_PIXELS,Re),me.pixelStorei(U.UNPACK_SKIP_ROWS,Xe),me.pixelStorei(U.UNPACK_SKIP_IMAGES,tt);let Xi=M.isDataArrayTexture||M.isData3DTexture,Ss=N.isDataArrayTexture||N.isData3DTexture;if(M.isDepthTexture){let st=Oe.get(M),qt=Oe.get(N),Kn=Oe.get(st.__renderTarget),St=Oe.get(qt.__renderTarget);me.bindFramebuffer(U.READ_FRAMEBUFFER,Kn.__webglFramebuffer),me.bindFramebuffer(U.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let Vt=0;Vt<be;Vt++)Xi&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Oe.get(M).__webglTexture,z,tt+Vt),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Oe.get(N).__webglTexture,fe,It+Vt)),U.blitFramebuffer(Re,Xe,Re+Me,Xe+ue,Te,nt,Te+Me,nt+ue,U.DEPTH_BUFFER_BIT,U.NEAREST);me.bindFramebuffer(U.READ_FRAMEBUFFER,null),me.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(z!==0||M.isRenderTargetTexture||Oe.has(M)){let st=Oe.get(M),qt=Oe.get(N);me.bindFramebuffer(U.READ_FRAMEBUFFER,I),me.bindFramebuffer(U.DRAW_FRAMEBUFFER,G);for(let Kn=0;Kn<be;Kn++)Xi?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,st.__webglTexture,z,tt+Kn):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,st.__webglTexture,z),Ss?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,qt.__webglTexture,fe,It+Kn):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,qt.__webglTexture,fe),z!==0?U.blitFramebuffer(Re,Xe,Re+Me,Xe+ue,Te,nt,Te+Me,nt+ue,U.COLOR_BUFFER_BIT,U.NEAREST):Ss?U.copyTexSubImage3D(Ee,fe,Te,nt,It+Kn,Re,Xe,Me,ue):U.copyTexSubImage2D(Ee,fe,Te,nt,Re,Xe,Me,ue);me.bindFramebuffer(U.READ_FRAMEBUFFER,null),me.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else Ss?M.isDataTexture||M.isData3DTexture?U.texSubImage3D(Ee,fe,Te,nt,It,Me,ue,be,xt,en,vt.data):N.isCompressedArrayTexture?U.compressedTexSubImage3D(Ee,fe,Te,nt,It,Me,ue,be,xt,vt.data):U.texSubImage3D(Ee,fe,Te,nt,It,Me,ue,be,xt,en,vt):M.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,fe,Te,nt,Me,ue,xt,en,vt.data):M.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,fe,Te,nt,vt.width,vt.height,xt,vt.data):U.texSubImage2D(U.TEXTURE_2D,fe,Te,nt,Me,ue,xt,en,vt);me.pixelStorei(U.UNPACK_ROW_LENGTH,dn),me.pixelStorei(U.UNPACK_IMAGE_HEIGHT,at),me.pixelStorei(U.UNPACK_SKIP_PIXELS,Ms),me.pixelStorei(U.UNPACK_SKIP_ROWS,tn),me.pixelStorei(U.UNPACK_SKIP_IMAGES,wl),fe===0&&N.generateMipmaps===!0&&N.mipmapsAutoUpdate===!0&&U.generateMipmap(Ee),me.unbindTexture()},this.initRenderTarget=function(M){Oe.get(M).__webglFramebuffer===void 0&&We.setupRenderTarget(M)},this.initTexture=function(M){M.isCubeTexture?We.setTextureCube(M,0):M.isData3DTexture?We.setTexture3D(M,0):M.isDataArrayTexture||M.isCompressedArrayTexture?We.setTexture2DArray(M,0):We.setTexture2D(M,0),me.unbindTexture()},this.resetState=function(){$=0,H=0,ne=null,me.reset(),le.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return qn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=it._getDrawingBufferColorSpace(e),t.unpackColorSpace=it._getUnpackColorSpace()}};var Zf=1e4,Uh=32,pt=Es(i=>Float32Array.from(i,e=>di(e)/Zf)),Xa=(i,{place:[e,t],radius:n})=>i.filter((s,r)=>r%2===0&&Math.hypot(s-e,i[r+1]-t)<=n).length,Fh=class{constructor(e,t,n){this.steps=e;this.now=t;this.apply=n;this.times=e.map(([s])=>di(s)),e.reduce((s,r,o)=>{let a=n(s,r);return o%Uh===0&&this.snapshots.push(a),a},t)}steps;now;apply;times;snapshots=[];index=-1;at(e){let t=Math.min(this.steps.length-1,Math.max(0,ui(this.times,e)));if(t===this.index)return this.now;let n=Math.floor(t/Uh);for(this.index<t&&this.index>=n*Uh||(this.index=n*Uh,this.now=this.snapshots[n]);this.index<t;)this.now=this.apply(this.now,this.steps[++this.index]);return this.now}get first(){return this.at(-1/0)}get last(){return this.at(1/0)}},Y0=i=>new Fh(i,new Float32Array,gT),Z0=({steps:i,step:e,places:t})=>new Fh(i,Array.from({length:t.length/2},()=>0),(n,[,s,r])=>{let o=[...n];return s.forEach((a,l)=>{a<o.length&&(o[a]=di(r[l])*e)}),o});function gT(i,[,e,t]){let n=new Set(e),s=i.filter((o,a)=>!n.has(a>>1)),r=new Float32Array(s.length+t.length);return r.set(s),r.set(pt(t),s.length),r}var xT=.1,j0=2,yT=1,vT=2,bT=.3,zh=3,Jf=.03,Vh=class{list=[];taken=0;first=0;extend(e,t){for(;this.taken<e.length;this.taken++){let n=this.taken;t(n)?n-this.first+1===zh?this.list.push([e[this.first],e[n]]):n-this.first>=zh&&(this.list.at(-1)[1]=e[n]):this.first=n+1}return this.list}},Xs="push or collision",qa=i=>i.replace(/(?<!or )\b(?:human )?collision(s?)\b/i,(e,t,n)=>t?"pushes or collisions":n?Xs:$n(Xs)),Ya=({kind:i,by_hand:e})=>/guiding/i.test(i)?"hand guiding":e||/collision/i.test(i)?Xs:null,Gh=class{constructor(e,t){this.plan=e;this.number=e.round,this.q=Array.from({length:t},()=>[]),this.particles=Y0(e.particles),this.treated=e.treatment?Z0(e.treatment):null}plan;number;start=0;t=[];q;tool=[];force=[];normal=new Ro;height=new Ro;particles;treated;interpreted=null;truth=null;observed=null;over=!1;states=null;get target(){let{press_force:e=null}=this.plan;return e!==null&&e>0?e:null}get events(){return this.interpreted?.events??this.plan.events??[]}get count(){return this.t.length}get length(){let e=this.t.at(-1)??0;return this.interpreted?Math.max(this.interpreted.duration,e):this.over&&this.count?e:Math.max(this.plan.duration,e)}get end(){return this.start+this.length}push({t:e,q:t,tool:n,force:s,normal:r,height:o}){let a=e.length;if(n.length!==7*a||s.length!==3*a||r.length!==a||o.length!==a||Object.values(t).some(c=>c.length!==a))throw new Error("columns of samples differ in length");if(!e.every(Number.isFinite))throw new Error("a time is not finite");for(let c of e)this.t.push(Math.max(di(c),this.t.at(-1)??-1/0));this.q.forEach((c,h)=>{let u=t[h],d=c.at(-1)??0;for(let f=0;f<a;f++)c.push(u?di(u[f]):d)});for(let[c,h]of[[this.tool,n],[this.force,s],[this.normal,r],[this.height,o]])for(let u of h)c.push(di(u))}place(e){let t=Math.max(0,ui(this.t,e)),[n,s]=[this.t[t],this.t[t+1]];return t+1>=this.count||!(s>n)?[t,0]:[t,Math.min(1,Math.max(0,(e-n)/(s-n)))]}toolAt(e){return this.count?_T(this.tool,...this.place(e)):null}measuredAt(e){let[t,n]=this.place(e),s=this.count>0,r=(a,l=0,c=1)=>Kf(a[c*t+l],a[c*(t+1)+l],n),o=({data:a})=>Number.isFinite(r(a))?r(a):null;return{q:Float64Array.from(s?this.q:[],a=>r(a)),tool:this.toolAt(e),force:s?[r(this.force,0,3),r(this.force,1,3),r(this.force,2,3)]:null,normal:o(this.normal),height:o(this.height)}}get firstContact(){return this.plan.phases.find(({contact:e})=>e)?.start??0}growthAt(e){let{growth:t}=this.plan;if(!t.length)return null;let n=Math.max(0,t.findLastIndex(([o])=>o<=e)),[s,r]=[t[n],t[n+1]];return!r||e<=s[0]||r[0]<=s[0]?s[1]:Kf(s[1],r[1],Math.min(1,(e-s[0])/(r[0]-s[0])))}phaseAt(e){return this.plan.phases.findLastIndex(({start:t})=>t<=e+1e-9)}get contacts(){let{basis:e,count:t}=this;return this.states?.basis!==e&&(this.states={basis:e,count:-1,pressed:new Vh,high:new Vh,contact:[],pushed:[]}),this.states.count!==t&&Object.assign(this.states,this.classify(this.states),{count:t}),this.states}contactAt(e){let{contact:t,pushed:n}=this.contacts;return jf(n,e)?"pushed":jf(t,e)?"contact":"none"}isPressed(e){return jf(this.contacts.contact,e)}get basis(){return`${!!this.interpreted} ${this.touchForce}`}get touchForce(){return xT*j0*Math.floor(Math.max(0,this.normal.largest)/j0)}classify({pressed:e,high:t}){let{normal:n,height:s,plan:r,interpreted:o}=this,a=n.least<=n.largest,l=this.touchForce,c=Math.max(bT,.5*l),h=o?.contacts??r.contacts,u=this.events.filter(Ya).map(({start:g,end:y})=>[g,y]);if(!this.count||!a){let g=r.phases.filter(({contact:y})=>y).map(({start:y,end:S})=>[y,S]);return{contact:Bh(h??g),pushed:Bh(u)}}let d=g=>s.data[g]>Jf,f=g=>Math.hypot(this.force[3*g],this.force[3*g+1],this.force[3*g+2]),p=t.extend(this.t,g=>d(g)&&f(g)>Math.max(vT,l)),x=u.length?Bh([...u,...p]):p;if(!h)return{contact:e.extend(this.t,g=>!d(g)&&n.data[g]>Math.max(yT,l)),pushed:x};let m=([g,y])=>(n.range(this.place(g)[0],this.place(y)[0]+2)?.[1]??0)>c;return{contact:Bh(o?.incidents?h:h.filter(m)),pushed:x}}};function jf(i,e){let t=Co(i.length,n=>i[n][0]<=e);return t>=0&&e<=i[t][1]}function Bh(i){let e=[];for(let[t,n]of[...i].sort((s,r)=>s[0]-r[0])){let s=e.at(-1);s&&t<=s[1]?s[1]=Math.max(s[1],n):e.push([t,n])}return e}var Kf=(i,e,t)=>t>0?i+t*(e-i):i;function _T(i,e,t){let[n,s]=[7*e,7*e+7],r=i.slice(n,s);if(t<=0)return r;for(let o=0;o<3;o++)r[o]=Kf(r[o],i[s+o],t);return Rt.slerpFlat(r,3,i,n+3,i,s+3,t),r}var mt=i=>typeof i=="string",ye=i=>typeof i=="number"&&Number.isFinite(i),$e=i=>e=>Array.isArray(e)&&e.every(i),cs=i=>Array.isArray(i),Wh=(...i)=>e=>Array.isArray(e)&&e.length===i.length&&i.every((t,n)=>t(e[n])),qs=i=>Wh(...Array.from({length:i},()=>ye)),qe=i=>e=>e==null||i(e),lt=i=>e=>typeof e=="object"&&e!==null&&Object.entries(i).every(([t,n])=>n(e[t])),hs=(i,e)=>t=>lt(i)(t)&&e(t),eo=qs(7),Za=qs(2),K0=lt({mean:ye,low:ye,high:ye}),wT=new Map([["box",lt({size:qs(3)})],["sphere",lt({radius:ye})],["mesh",lt({mesh:ye})],["cylinder",lt({radius:ye,length:ye})],["capsule",lt({radius:ye,length:ye})]]),Hh=hs({pose:eo,kind:mt,color:qe(qs(4))},i=>wT.get(i.kind)?.(i)===!0),J0=lt({vertices:$e(ye),triangles:$e(ye)}),MT=hs({radius_m:ye,axis_rad:ye},({kind:i,radius_m:e})=>i==="cylinder"&&e!==0),ST=hs({radius_m:ye,half_angle_rad:ye,axis_rad:ye},({kind:i,radius_m:e,half_angle_rad:t})=>i==="cone"&&e!==0&&t>0&&t<Math.PI/2),TT=hs({points:$e(ye),places:$e(ye),triangles:$e(ye)},({kind:i,points:e,places:t,triangles:n})=>{let s=e.length/3,r=o=>Number.isInteger(o)&&o>=0&&o<s;return i==="mesh"&&s>0&&t.length===2*s&&n.length>0&&n.length%3===0&&n.every(r)}),Q0=i=>MT(i)||ST(i)||TT(i),ET=i=>Q0(i)||hs({},({kind:e})=>e==="plane")(i),ex=lt({kind:mt,start:ye,end:ye,words:mt}),AT=lt({task:qe(lt({target:ye})),tool:lt({solid:Hh}),meshes:$e(J0),robot:qe(lt({variables:$e(mt),links:$e(lt({shapes:$e(Hh),collision:qe($e(Hh))})),joints:$e(lt({parent:ye,pose:eo,axis:qs(3),offset:ye,terms:$e(Za)}))}))}),RT=lt({strategy:mt,chosen:i=>typeof i=="boolean",error:qe(mt),score:qe(ye),predicted:qe(ye),lost:qe(ye),strokes:qe(ye),in_contact:qe(ye),duration:qe(ye),lines:qe($e($e(ye)))}),CT={why:$e(mt),considered:qe($e(RT)),lost:qe(ye),headings:qe($e(mt)),without:qe($e(lt({stroke:ye,performance:ye,lost:ye,particles:$e(ye),treated:qe(cs)}))),another:qe(lt({gain:ye,line:$e(ye),way:ye})),bases:qe(lt({poses:$e(Wh(ye,ye,ye,qe(ye))),chosen:$e(ye)}))},PT=1e6,IT=hs({unit:mt,target:ye,low:ye,high:ye,step:ye,cell:qs(2),places:$e(ye),steps:$e(Wh(ye,$e(ye),$e(ye)))},({unit:i,low:e,high:t,target:n,places:s})=>(i==="passes"?[n,e,t].every(Number.isInteger):i==="\xB5m"&&e<t)&&t<=PT&&e>0&&e<=n&&n<=t&&s.length%2===0),LT=lt({...CT,round:ye,duration:ye,root:qe(eo),surface:lt({pose:eo,rings:$e($e(ye)),shape:qe(Q0)}),scene:$e(Hh),meshes:$e(J0),goal:qe(hs({kind:mt},i=>i.kind!=="collected"||lt({place:qs(2),radius:ye})(i))),strokes:$e($e(ye)),phases:$e(lt({name:mt,start:ye,end:ye})),press_force:qe(ye),predicted:qe(ye),growth:$e(Za),particles:$e(Wh(ye,cs,cs)),treatment:qe(IT),events:qe($e(ex)),contacts:qe($e(Za))}),DT=lt({time:qe(ye),title:mt,evidence:mt,effect:mt,advice:mt}),NT=hs({cell:ye,places:$e(ye),expected:$e(ye),goal:qe(ye)},({cell:i,places:e,expected:t})=>i>0&&e.length===2*t.length),kT=lt({round:ye,duration:ye,estimate:K0,by_touch:K0,verdict:mt,words:$e(mt),found:qe(eo),events:$e(ex),contacts:$e(Za),incidents:qe($e(DT)),particles:cs,density:qe(NT),treated:qe(cs)}),OT=i=>Array.isArray(i)&&mt(i[0])&&mt(i[1])&&qe(ye)(i[2]),UT={head:AT,round:LT,interpreted:kT,stage:lt({stage:mt,words:mt}),observed:lt({round:ye,detections:cs}),truth:lt({round:ye,performance:qe(ye),particles:qe(cs),treated:qe(cs),pushes:$e(Za),surface:qe(eo),shape:qe(ET)}),ended:lt({verdict:qe(mt),badge:qe(mt),story:lt({asked:mt,happened:mt,sure:mt,surer:mt,next:qe(lt({words:mt,command:qe(mt)}))}),facts:$e(OT)})};function tx(i){let e=i;if(e?.piece==="judged"){let{felt:t,...n}=e;return{by_touch:t,...n,piece:"interpreted"}}if(e?.piece==="round"&&Array.isArray(e.considered)){let t=e.considered.map(n=>n&&"worth"in n?{score:n.worth,...n}:n);return{...e,considered:t}}return i}function nx(i){if(typeof i!="object"||i===null)throw new Error("a line is not a piece");let e=UT[i.piece];if(e&&!e(i))throw new Error(`a ${i.piece} piece lacks a field`);i.piece==="head"&&FT(i)}function FT({robot:i,tool:e}){if(!i)return;let t=i.joints.length+1;if(i.links.length>t||i.joints.some(({parent:n},s)=>!(n>=0&&n<=s)))throw new Error("a joint comes before its parent, or a link has no joint");if(e.link!==null&&!(e.link<t))throw new Error("the link of the tool does not exist")}var $h=.001;function ja(i,e){let t=i?.shape??e;return t&&t.kind!=="plane"?t:null}var vi=class i{head=null;rounds=[];stages=[];meshes=[];before={observed:null,truth:null};ended=null;broken=0;unknown=0;version=0;closed=!1;callbacks=new Set;cachedHappenings=null;static parse(e){let t=new i;for(let n of e.split(`
`))t.applyLine(n);return t.close(),t}applyLine(e){if(!e.trim())return;let t=null;try{t=JSON.parse(e)}catch{}this.apply(t)}apply(e){try{this.add(e)}catch{this.broken++}this.notify(e)}close(){this.closed=!0;for(let e of this.rounds)e.over=!0;this.layOutRounds(),this.notify(null)}get live(){return!this.closed}onChange(e){return this.callbacks.add(e),()=>this.callbacks.delete(e)}notify(e){this.version++;for(let t of this.callbacks)t(e)}add(e){let t=tx(e);switch(nx(t),t.piece){case"head":this.meshes.push(...t.meshes),this.head=t;break;case"stage":this.stages.push(t);break;case"round":{let n=new Gh(t,this.head?.robot?.variables.length??0);this.meshes.push(...t.meshes);let s=this.rounds.at(-1);s&&s.number===n.number&&!s.count&&!s.interpreted?this.rounds.pop():s&&(s.over=!0),this.rounds.push(n),this.layOutRounds();break}case"samples":{let n=this.round(t.round);n.push(t),n!==this.rounds.at(-1)&&this.layOutRounds();break}case"observed":this.placeOf(t).observed=t;break;case"interpreted":this.round(t.round).interpreted={...t},this.layOutRounds();break;case"truth":this.placeOf(t).truth=t;break;case"ended":this.ended=t,this.close();break;default:this.unknown++}}round(e){let t=this.rounds.findLast(n=>n.number===e);if(!t)throw new Error(`no round ${e}`);return t}placeOf({round:e}){return e===0?this.before:this.round(e)}layOutRounds(){let e=0;for(let t of this.rounds)t.start=e,e+=t.length}get duration(){return this.rounds.at(-1)?.end??0}get now(){let e=this.rounds.at(-1);return!e||!this.live||e.interpreted||e.plan.kind==="planned"?this.duration:e.start+(e.count?e.t.at(-1):0)}roundAt(e){return this.rounds[Math.max(0,Co(this.rounds.length,t=>this.rounds[t].start<=e))]??null}at(e){let t=this.roundAt(e);if(!t)return null;let n=Math.min(Math.max(0,e-t.start),t.length);return{round:t,time:n,...t.measuredAt(n),performance:t.growthAt(n),contact:t.contactAt(n),phase:t.phaseAt(n)}}outcomeAt(e){let t=this.rounds.findLast(l=>l.end<=e+1e-6&&(l.interpreted||l.truth||l.observed)),{truth:n,observed:s}=t??this.before,{shape:r,pose:o}=(t??this.rounds[0]).plan.surface,a=t?.interpreted?.found??o;return{estimated:{places:t?.interpreted?.particles,pose:a,shape:r},actual:{places:n?.particles,pose:n?.surface??a,shape:ja(n,r)},seen:{places:s?.detections,pose:a,shape:r}}}endedAt(e){let t=this.rounds.findLastIndex(s=>s.end<=e+1e-6),n=this.rounds[t+1];return n&&e>=n.start+n.firstContact?null:this.rounds[t]??null}resultAt(e){let t=this.endedAt(e);return t?.interpreted?t:null}foundAt(e){return this.rounds.findLast(t=>t.end<=e+1e-6)?.interpreted?.found??null}get happenings(){if(this.cachedHappenings?.version===this.version)return this.cachedHappenings.list;let e=[];for(let{number:t,start:n,events:s,truth:r}of this.rounds){for(let o of s)e.push({start:n+o.start,end:n+o.end,source:"event",round:t,kind:Ya(o)??o.kind,words:o.words});for(let[o,a]of r?.pushes??[])e.push({start:n+o,end:n+a,source:"push",round:t,kind:"true push",words:"A push in the simulated world."})}return e.sort((t,n)=>t.start-n.start),this.cachedHappenings={version:this.version,list:e},e}get stops(){let e=[0,this.duration];for(let{start:t,plan:n}of this.rounds){e.push(t);for(let s of n.phases)s.contact&&e.push(t+s.start)}for(let{start:t}of this.happenings)e.push(t);return[...new Set(e)].filter(t=>t<=this.duration).sort((t,n)=>t-n)}};var ix="wisch-theme",sx=()=>document.documentElement,Qf=new Set,Yh=!1,ep=null,rx=i=>{try{return i(localStorage)}catch{return null}};function us(){return Yh?"light":ep??(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light")}function ox(i){ep=i,rx(e=>e.setItem(ix,i)),Xh()}function to(i){return Qf.add(i),()=>Qf.delete(i)}function Xh(){sx().dataset.theme=us(),qh=null;for(let i of Qf)i()}function ax(){ep=["light","dark"].find(e=>e===rx(t=>t.getItem(ix)))??null,matchMedia("(prefers-color-scheme: dark)").addEventListener("change",Xh);let i=e=>{Yh!==e&&(Yh=e,Xh())};matchMedia("print").addEventListener("change",({matches:e})=>i(e)),addEventListener("beforeprint",()=>i(!0)),addEventListener("afterprint",()=>i(!1)),Xh()}var no=()=>Yh,qh=null;function De(i){qh??=new Map;let e=qh.get(i);return e===void 0&&(e=getComputedStyle(sx()).getPropertyValue(`--${i}`).trim()||"#888888",qh.set(i,e)),e}function hx(i,e=!1){let t=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,l=new Ze;l.morphTargetsRelative=a;let c=0;for(let h=0;h<i.length;++h){let u=i[h],d=0,f=0;if(t!==(u.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in u.attributes){if(!n.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(u.attributes[p]),d++}if(d!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==u.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in u.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;if(u.morphAttributes[p].length!==i[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(u.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of morph attributes."),null;if(e){let p;if(t)p=u.index.count;else if(u.attributes.position!==void 0)p=u.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,h),c+=p}}if(t){let h=0,u=[];for(let d=0;d<i.length;++d){let f=i[d].index;for(let p=0;p<f.count;++p)u.push(f.getX(p)+h);h+=i[d].attributes.position.count}l.setIndex(u)}for(let h in r){let u=lx(r[h]);if(!u)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;l.setAttribute(h,u)}for(let h in o){let u=o[h][0].length;if(u!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[h]=[];for(let d=0;d<u;++d){let f=[];for(let x=0;x<o[h].length;++x)f.push(o[h][x][d]);let p=lx(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;l.morphAttributes[h].push(p)}}}return l}function lx(i){let e,t,n,s=-1,r=0;for(let c=0;c<i.length;++c){let h=i[c];if(e===void 0&&(e=h.array.constructor),e!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(t===void 0&&(t=h.itemSize),t!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=h.normalized),n!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*t}let o=new e(r),a=new yt(o,t,n),l=0;for(let c=0;c<i.length;++c){let h=i[c];if(h.isInterleavedBufferAttribute){let u=l/t;for(let d=0,f=h.count;d<f;d++)for(let p=0;p<t;p++){let x=h.getComponent(d,p);a.setComponent(d+u,p,x)}}else o.set(h.array,l);l+=h.count*t}return s!==void 0&&(a.gpuType=s),a}function ux(i,e=1e-4){e=Math.max(e,Number.EPSILON);let t={},n=i.getIndex(),s=i.getAttribute("position"),r=n?n.count:s.count,o=0,a=Object.keys(i.attributes),l=[],c=new Map,h=[],u=["getX","getY","getZ","getW"],d=e*.5,f=Math.log10(1/e),p=Math.pow(10,f),x=d*p;for(let g=0;g<r;g++){let y=n?n.getX(g):g,S="";for(let b=0,A=a.length;b<A;b++){let R=a[b],v=i.getAttribute(R),T=v.itemSize;for(let D=0;D<T;D++)S+=`${Math.trunc(v[u[D]](y)*p+x)},`}S in t?h.push(t[S]):(l.push(y),t[S]=o,h.push(o),o++)}let m=i.clone();for(let g in i.attributes)m.setAttribute(g,cx(i.attributes[g],l,c));for(let g in i.morphAttributes)m.morphAttributes[g]=i.morphAttributes[g].map(y=>cx(y,l,c));return m.setIndex(h),m}function dx(i,e=Math.PI/3){let t=i.index?i.toNonIndexed():i,n=t.attributes.position,s=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(s*3);for(let b=0;b<s;b++)r[3*b+0]=n.getX(b),r[3*b+1]=n.getY(b),r[3*b+2]=n.getZ(b)}let o=Math.cos(e),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let b=0;b<l;b++){let A=9*b,R=r[A+0],v=r[A+1],T=r[A+2],D=r[A+3],P=r[A+4],k=r[A+5],O=r[A+6],V=r[A+7],I=r[A+8],G=O-D,$=V-P,H=I-k,ne=R-D,X=v-P,Q=T-k,te=$*Q-H*X,we=H*ne-G*Q,Be=G*X-$*ne,Z=1/(Math.sqrt(te*te+we*we+Be*Be)||1);c[3*b+0]=te*Z,c[3*b+1]=we*Z,c[3*b+2]=Be*Z}let h=new Int32Array(s),u=new Float64Array(s*3),d=1;for(;d<s*2;)d<<=1;let f=d-1,p=new Int32Array(d),x=0;for(let b=0;b<s;b++){let A=3*b,R=Math.trunc(r[A+0]*a),v=Math.trunc(r[A+1]*a),T=Math.trunc(r[A+2]*a),D=(Math.imul(R,73856093)^Math.imul(v,19349663)^Math.imul(T,83492791))&f;for(;;){let P=p[D];if(P===0){let O=3*x;u[O+0]=R,u[O+1]=v,u[O+2]=T,p[D]=x+1,h[b]=x++;break}let k=3*(P-1);if(u[k+0]===R&&u[k+1]===v&&u[k+2]===T){h[b]=P-1;break}D=D+1&f}}let m=new Int32Array(x+1);for(let b=0;b<s;b++)m[h[b]+1]++;for(let b=0;b<x;b++)m[b+1]+=m[b];let g=new Int32Array(s),y=m.slice(0,x);for(let b=0;b<l;b++){let A=3*b;g[y[h[A+0]]++]=b,g[y[h[A+1]]++]=b,g[y[h[A+2]]++]=b}let S=new Float32Array(s*3);for(let b=0;b<l;b++){let A=3*b,R=c[A+0],v=c[A+1],T=c[A+2];for(let D=0;D<3;D++){let P=A+D,k=h[P],O=0,V=0,I=0;for(let $=m[k],H=m[k+1];$<H;$++){let ne=3*g[$],X=c[ne+0],Q=c[ne+1],te=c[ne+2];R*X+v*Q+T*te>o&&(O+=X,V+=Q,I+=te)}let G=1/(Math.sqrt(O*O+V*V+I*I)||1);S[3*P+0]=O*G,S[3*P+1]=V*G,S[3*P+2]=I*G}}return t.setAttribute("normal",new yt(S,3,!1)),t}function cx(i,e,t=new Map){let n=i.isInterleavedBufferAttribute,s=n?i.data:i,r=n?s.stride:i.itemSize,o=n?t.get(s):void 0;if(o===void 0){let l=new s.array.constructor(e.length*r);for(let c=0;c<e.length;c++)for(let h=0;h<r;h++)l[c*r+h]=s.array[e[c]*r+h];o=n?new s.constructor(l,r,s.meshPerAttribute):new i.constructor(l,i.itemSize,i.normalized,i.meshPerAttribute),o.setUsage(s.usage),n&&t.set(s,o)}let a=n?new i.constructor(o,i.itemSize,i.offset,i.normalized):o;return a.name=i.name,n||(a.gpuType=i.gpuType),a}var BT=new E(1,1,1),zT=.7;function At([i,e,t,n,s,r,o],a=new Ie){return a.compose(new E(i,e,t),new Rt(n,s,r,o).normalize(),BT)}function jt(i,e){return i.matrixAutoUpdate=!1,At(e,i.matrix),i.matrixWorldNeedsUpdate=!0,i}function Et(i,e){return i.name=e,i.color.set(De(e)),i}function fx(i){let e=[];return i.traverse(t=>{"material"in t&&e.push(t)}),e}function tp(i){for(let{material:e}of fx(i))e.name&&Et(e,e.name)}function Zh(i){for(let e of fx(i))e.dispose?.(),e.geometry.dispose(),e.material.map?.dispose(),e.material.dispose()}function Ka(i){Zh(i),i.clear()}function Ys(i,e){return i.onBeforeCompile=t=>{t.vertexShader=t.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      gl_Position.z = (projectionMatrix * vec4(${e.toFixed(3)} * mvPosition.xyz, 1.0)).z / ${e.toFixed(3)};`)},i.customProgramCacheKey=()=>`shifted ${e}`,i}var VT=Es(({vertices:i,triangles:e})=>dx(new Ze().setAttribute("position",new yt(pt(i),3)).setIndex(e),zT));function Vi(i,e){switch(i.kind){case"box":return new kn(...i.size);case"sphere":return new Oi(i.radius,28,18);case"cylinder":return new es(i.radius,i.radius,i.length,32).rotateX(Math.PI/2);case"capsule":return new Ds(i.radius,i.length,10,28).rotateX(Math.PI/2);case"mesh":return e[i.mesh]?VT(e[i.mesh]):new Ze;default:return new Ze}}var gx=.05,xx=.02,yx=500,GT=64;function sp({axis_rad:i}){let[e,t]=[Math.cos(i),Math.sin(i)];return[[e,t],[-t,e]]}function jh(i,e,t){if(i.kind==="cone")return $T(i,e,t);let[,n]=sp(i);return(n[0]*e+n[1]*t)/i.radius_m}function HT(i,e,t){let n=i.kind==="mesh"?Math.hypot(t[0]-e[0],t[1]-e[1])/xx:Math.abs(jh(i,t[0],t[1])-jh(i,e[0],e[1]))/gx;return Math.min(yx,Math.max(1,Math.ceil(n)))}function ai(i,e,t,n){if(!i)return[e,t,n];if(i.kind==="mesh")return Jh(i).lift(e,t,n);if(i.kind==="cone")return XT(i,e,t,n);let[s,r]=sp(i),o=s[0]*e+s[1]*t,a=(r[0]*e+r[1]*t)/i.radius_m,l=(i.radius_m+n)*Math.sin(a);return[s[0]*o+r[0]*l,s[1]*o+r[1]*l,n*Math.cos(a)-2*i.radius_m*Math.sin(a/2)**2]}function ds({pose:i,shape:e},t){let n=At(i),s=new E(0,0,1),r=t.clone().applyMatrix4(n.clone().invert());if(e?.kind==="mesh")s.copy(Jh(e).normalNear(r));else if(e?.kind==="cone")s.copy(qT(e,r));else if(e){let[,o]=sp(e),[a,l]=[o[0]*r.x+o[1]*r.y,r.z+e.radius_m];s.set(o[0]*a,o[1]*a,l).multiplyScalar(Math.sign(e.radius_m)).normalize()}return s.transformDirection(n)}function vx({pose:i,rings:e,shape:t},[n,s,r]){if(t||!e.length)return!0;let o=new E(n,s,r).applyMatrix4(At(i).invert());return e.map(a=>pt(a)).filter(a=>{let l=!1;for(let c=0,h=a.length-2;c<a.length;h=c,c+=2){let[u,d,f,p]=[a[c],a[c+1],a[h],a[h+1]];d>o.y!=p>o.y&&o.x<u+(f-u)*(o.y-d)/(p-d)&&(l=!l)}return l}).length%2===1}function fs(i,e,t){if(!i)return[...e];let n=[];for(let s=0;s<e.length;s++){let[r,o,a]=e[s],l=s+1<e.length?e[s+1]:t?e[0]:null,c=l?HT(i,e[s],l):1;for(let h=0;h<c;h++){let u=h/c,d=l??e[s];n.push(ai(i,r+u*(d[0]-r),o+u*(d[1]-o),a+u*(d[2]-a)))}}return n}function px(i,e){let t=[];return i.forEach((n,s)=>{let r=i[(s+1)%i.length],[o,a]=[e(n),e(r)];if(o>=0&&t.push(n),o>=0!=a>=0){let l=o/(o-a);t.push([n[0]+l*(r[0]-n[0]),n[1]+l*(r[1]-n[1]),n[2]+l*(r[2]-n[2])])}}),t}function WT(i){let e=t=>{if(i.kind==="cylinder")return([s,r])=>jh(i,s,r)-t;let n=YT(i,t);return([s,r])=>n(s,r)};return(t,n)=>{let s=t.map(([c,h])=>jh(i,c,h)),[r,o]=[Math.min(...s),Math.max(...s)],a=Math.max(gx,(o-r)/yx),l=Math.floor(r/a);for(let c=l;c<Math.max(o/a,l+.5);c++){let[h,u]=[e(c*a),e((c+1)*a)],d=px(px(t,h),f=>-u(f));for(let f=1;f+1<d.length;f++)n([d[0],d[f],d[f+1]])}}}function np([i,e,t],n,s=0){let r=[[i,e],[e,t],[t,i]].map(([d,f])=>Math.hypot(d[0]-f[0],d[1]-f[1])),o=r.indexOf(Math.max(...r)),a=s||Math.max(xx,r[o]/GT);if(r[o]<=a)return n([i,e,t]);let[l,c,h]=[[i,e,t],[e,t,i],[t,i,e]][o],u=[(l[0]+c[0])/2,(l[1]+c[1])/2,(l[2]+c[2])/2];np([l,u,h],n,a),np([u,c,h],n,a)}function rp(i,e){if(!i)return e;let t=e.index?e.toNonIndexed():e,{array:n,count:s}=t.getAttribute("position"),r=[],o=i.kind==="mesh"?np:WT(i),a=c=>{for(let[h,u,d]of c)r.push(...ai(i,h,u,d))};for(let c=0;c+2<s;c+=3){let h=u=>[n[3*(c+u)],n[3*(c+u)+1],n[3*(c+u)+2]];o([h(0),h(1),h(2)],a)}let l=new Ze().setAttribute("position",new Pe(r,3));return l.computeVertexNormals(),e.dispose(),l}var Kh=Es(i=>{let[e,t]=[Math.cos(i.axis_rad),Math.sin(i.axis_rad)],[n,s]=[Math.cos(i.half_angle_rad),Math.sin(i.half_angle_rad)*Math.sign(i.radius_m)];return{along:[e,t],cosine:n,sine:s,slant:i.radius_m/s,axis:new E(n*e,n*t,-s),radial:new E(s*e,s*t,n),across:new E(-t,e,0)}});function $T(i,e,t){let{along:n,slant:s,sine:r}=Kh(i);return Math.atan2(n[0]*t-n[1]*e,s+n[0]*e+n[1]*t)/r}function XT(i,e,t,n){let{along:s,slant:r,sine:o,cosine:a,axis:l,radial:c,across:h}=Kh(i),[u,d]=[s[0]*e+s[1]*t,s[0]*t-s[1]*e],f=(u*(2*r+u)+d*d)/(Math.hypot(r+u,d)+r),p=Math.atan2(d,r+u)/o,x=h.clone().multiplyScalar(Math.sin(p)).addScaledVector(c,-2*Math.sin(p/2)**2),m=x.clone().add(c);return x.multiplyScalar(i.radius_m).addScaledVector(l,a*f).addScaledVector(m,o*f).addScaledVector(m,a*n).addScaledVector(l,-o*n).toArray()}function qT(i,e){let{sine:t,cosine:n,axis:s,radial:r,across:o}=Kh(i),[a,l]=[r.dot(e)+i.radius_m,o.dot(e)];return r.clone().multiplyScalar(a).addScaledVector(o,l).multiplyScalar(Math.sign(i.radius_m)).normalize().multiplyScalar(n).addScaledVector(s,-t)}function YT(i,e){let{along:t,slant:n,sine:s}=Kh(i),[r,o]=[Math.sin(e*s),Math.cos(e*s)];return(a,l)=>Math.sign(s)*(o*(t[0]*l-t[1]*a)-r*(n+t[0]*a+t[1]*l))}var ip=class{constructor(e){this.shape=e;let{points:t,places:n,triangles:s}=e;this.geometry=new Ze().setAttribute("position",new Pe([...t],3)).setIndex([...s]),this.geometry.computeVertexNormals(),this.normals=this.geometry.getAttribute("normal").array;let r=new Bs;for(let a=0;a<n.length;a+=2)r.expandByPoint(new ee(n[a],n[a+1]));this.low=r.min.toArray();let o=r.getSize(new ee);this.cell=Math.max(Math.sqrt(3*o.x*o.y/Math.max(s.length,1)),1e-4),this.columns=Math.floor(o.x/this.cell)+1;for(let a=0;a<s.length;a+=3){let l=[0,1,2].map(u=>s[a+u]);l.forEach(u=>this.triangleOf[u]??=a);let[c,h]=[0,1].map(u=>{let d=l.map(f=>Math.floor((n[2*f+u]-this.low[u])/this.cell));return[Math.min(...d),Math.max(...d)]});for(let u=h[0];u<=h[1];u++)for(let d=c[0];d<=c[1];d++)(this.cells[u*this.columns+d]??=[]).push(a)}}shape;geometry;normals;low;cell;columns;cells=[];triangleOf=[];lift(e,t,n){let s=this.find(e,t),r=this.mean(this.shape.points,s),o=this.mean(this.normals,s).normalize();return r.addScaledVector(o,n).toArray()}normalNear(e){return new E().fromArray(this.normals,3*mx(e.toArray(),this.shape.points))}mean(e,{corners:t,weights:n}){let s=new E;return t.forEach((r,o)=>{s.x+=n[o]*e[3*r],s.y+=n[o]*e[3*r+1],s.z+=n[o]*e[3*r+2]}),s}find(e,t){let[n,s]=[Math.floor((e-this.low[0])/this.cell),Math.floor((t-this.low[1])/this.cell)],r=n>=0&&n<this.columns&&s>=0?this.cells[s*this.columns+n]??[]:[];for(let o of r){let a=this.locate(o,e,t);if(a.weights.every(l=>l>=-1e-6))return a}return this.locate(this.triangleOf[mx([e,t],this.shape.places)]??0,e,t)}locate(e,t,n){let{places:s,triangles:r}=this.shape,o=[r[e],r[e+1],r[e+2]],[a,l,c]=[2*o[0],2*o[1],2*o[2]],[h,u,d,f,p,x]=[s[a],s[a+1],s[l],s[l+1],s[c],s[c+1]],m=(d-h)*(x-u)-(f-u)*(p-h),g=((t-h)*(x-u)-(n-u)*(p-h))/m,y=((d-h)*(n-u)-(f-u)*(t-h))/m;return{corners:o,weights:[1-g-y,g,y]}}};function mx(i,e){let[t,n]=[0,1/0];for(let s=0;s*i.length<e.length;s++){let r=0;for(let o=0;o<i.length;o++)r+=(i[o]-e[s*i.length+o])**2;r<n&&([t,n]=[s,r])}return t}var Jh=Es(i=>new ip(i));function ps(i,e=64,t={}){let n=document.createElement("canvas");n.width=n.height=e;let s=n.getContext("2d");return s.fillStyle=s.strokeStyle="#fff",i(s),Object.assign(new oa(n),t)}var Qh=()=>ps(i=>{i.arc(32,32,24,0,2*Math.PI),i.fill(),i.lineWidth=5,i.strokeStyle="#000",i.stroke()});function Zs(i,e,t,{nearer:n=.98,alphaTest:s=.3,renderOrder:r=7,vertexColors:o=!1}={}){let a=new Ze().setAttribute("position",new Pe(i,3)),l=new sa(a,Ys(new zr({size:t,sizeAttenuation:!1,map:e,alphaTest:s,transparent:!0,vertexColors:o}),n));return l.frustumCulled=!1,l.renderOrder=r,l}var Gi=256,bx=.24,op=4,ZT=.04,jT=.05,KT=null;function _x(){return KT??=ps(JT,Gi,{wrapS:Is,wrapT:Is,colorSpace:Zt,anisotropy:4,repeat:new ee(1/bx,1/bx)})}function JT(i){let e=i.createImageData(Gi,Gi);for(let t=0;t<Gi;t++)for(let n=0;n<Gi;n++){let s=Math.floor(op*t/Gi),r=2*Math.PI*n/Gi,o=t+5*Math.sin(r+2.1*s)+2*Math.sin(2*r+s),a=.5+.25*Math.sin(.55*o+3*s)+.25*Math.sin(1.63*o+s),l=op*t%Gi<op?.06:0,c=255*(1-ZT*Math.abs(Math.sin(5.3*s+1))-jT*a**3-l);e.data.set([c,c,c,255],4*(Gi*t+n))}i.putImageData(e,0,0)}pe.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new ee},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};vn.line={uniforms:Va.merge([pe.common,pe.fog,pe.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var $t=class extends Yn{constructor(e){super({type:"LineMaterial",uniforms:Va.clone(vn.line.uniforms),vertexShader:vn.line.vertexShader,fragmentShader:vn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var wx=new Ct,eu=new E,js=class extends Ca{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new Pe(e,3)),this.setAttribute("uv",new Pe(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new ss(t,6,1);return this.setAttribute("instanceStart",new Sn(n,3,0)),this.setAttribute("instanceEnd",new Sn(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new ss(t,6,1);return this.setAttribute("instanceColorStart",new Sn(n,3,0)),this.setAttribute("instanceColorEnd",new Sn(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new va(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ct);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),wx.setFromBufferAttribute(t),this.boundingBox.union(wx))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new an),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)eu.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(eu)),eu.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(eu));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var ap=new ut,Mx=new E,Sx=new E,Kt=new ut,Jt=new ut,bi=new ut,lp=new E,cp=new Ie,Qt=new Pa,Tx=new E,tu=new Ct,nu=new an,_i=new ut,wi,Ks;function Ex(i,e,t){return _i.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),_i.multiplyScalar(1/_i.w),_i.x=Ks/t.width,_i.y=Ks/t.height,_i.applyMatrix4(i.projectionMatrixInverse),_i.multiplyScalar(1/_i.w),Math.abs(Math.max(_i.x,_i.y))}function QT(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Qt.start.fromBufferAttribute(s,a),Qt.end.fromBufferAttribute(r,a),Qt.applyMatrix4(t);let c=new E,h=new E;wi.distanceSqToSegment(Qt.start,Qt.end,h,c),h.distanceTo(c)<Ks*.5&&e.push({point:h,pointOnLine:c,distance:wi.origin.distanceTo(h),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function eE(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,h=Math.min(a.instanceCount,l.count),u=-e.near;wi.at(1,bi),bi.w=1,bi.applyMatrix4(e.matrixWorldInverse),bi.applyMatrix4(n),bi.multiplyScalar(1/bi.w),bi.x*=r.x/2,bi.y*=r.y/2,bi.z=0,lp.copy(bi),cp.multiplyMatrices(e.matrixWorldInverse,o);for(let d=0,f=h;d<f;d++){if(Kt.fromBufferAttribute(l,d),Jt.fromBufferAttribute(c,d),Kt.w=1,Jt.w=1,Kt.applyMatrix4(cp),Jt.applyMatrix4(cp),Kt.z>u&&Jt.z>u)continue;if(Kt.z>u){let S=Kt.z-Jt.z,b=(Kt.z-u)/S;Kt.lerp(Jt,b)}else if(Jt.z>u){let S=Jt.z-Kt.z,b=(Jt.z-u)/S;Jt.lerp(Kt,b)}Kt.applyMatrix4(n),Jt.applyMatrix4(n),Kt.multiplyScalar(1/Kt.w),Jt.multiplyScalar(1/Jt.w),Kt.x*=r.x/2,Kt.y*=r.y/2,Jt.x*=r.x/2,Jt.y*=r.y/2,Qt.start.copy(Kt),Qt.start.z=0,Qt.end.copy(Jt),Qt.end.z=0;let x=Qt.closestPointToPointParameter(lp,!0);Qt.at(x,Tx);let m=Kr.lerp(Kt.z,Jt.z,x),g=m>=-1&&m<=1,y=lp.distanceTo(Tx)<Ks*.5;if(g&&y){Qt.start.fromBufferAttribute(l,d),Qt.end.fromBufferAttribute(c,d),Qt.start.applyMatrix4(o),Qt.end.applyMatrix4(o);let S=new E,b=new E;wi.distanceSqToSegment(Qt.start,Qt.end,b,S),t.push({point:b,pointOnLine:S,distance:wi.origin.distanceTo(b),object:i,face:null,faceIndex:d,uv:null,uv1:null})}}}var iu=class extends ot{constructor(e=new js,t=new $t({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)Mx.fromBufferAttribute(t,o),Sx.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+Mx.distanceTo(Sx);let r=new ss(s,2,1);return e.setAttribute("instanceDistanceStart",new Sn(r,1,0)),e.setAttribute("instanceDistanceEnd",new Sn(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;wi=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Ks=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),nu.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Ks*.5;else{let u=Math.max(s.near,nu.distanceToPoint(wi.origin));c=Ex(s,u,l.resolution)}if(nu.radius+=c,wi.intersectsSphere(nu)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),tu.copy(a.boundingBox).applyMatrix4(o);let h;if(n)h=Ks*.5;else{let u=Math.max(s.near,tu.distanceToPoint(wi.origin));h=Ex(s,u,l.resolution)}tu.expandByScalar(h),wi.intersectsBox(tu)!==!1&&(n?QT(this,t):eE(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(ap),this.material.uniforms.resolution.value.set(ap.z,ap.w))}};var tE={polygonOffset:!0,polygonOffsetFactor:-4,polygonOffsetUnits:-4};function Bn(i,e){let t=new iu(new js,e);return t.frustumCulled=!1,Ja(t,i),t}function Ja(i,e){i.geometry.dispose(),i.geometry=new js().setPositions(e.length?Float32Array.from(e):new Float32Array(6)),i.visible=e.length>0}function ms(i,e){let t=[];for(let n=0;n+(e?0:1)<i.length;n++)t.push(...i[n],...i[(n+1)%i.length]);return t}var nE=2e3;function su(i,e){let t=[],n=0,s=c=>Math.hypot(i[c+3]-i[c],i[c+4]-i[c+1],i[c+5]-i[c+2]),r=0;for(let c=0;c+5<i.length;c+=6)r+=s(c);let o=Math.max(1,r/(nE*(e[0]+e[1]))),[a,l]=[o*e[0],o*e[1]];for(let c=0;c+5<i.length;c+=6){let h=d=>[0,1,2].map(f=>i[c+f]+d*(i[c+3+f]-i[c+f])),u=s(c);for(let d=-(n%(a+l));d<u;d+=a+l){let[f,p]=[Math.max(0,d),Math.min(u,d+a)];p>f&&t.push(...h(f/u),...h(p/u))}n+=u}return t}var io=class{constructor(e,t){this.palette=t;this.line=Bn([],new $t({linewidth:e,vertexColors:!0,...tE}))}palette;line;positions=[];kinds=[];changed=!0;get count(){return this.kinds.length}clear(){this.positions.length=this.kinds.length=0,this.changed=!0}push(e,t){for(let n of e)this.positions.push(n);this.kinds.push(t),this.changed=!0}end(e){return new E().fromArray(this.positions,6*e+3)}paint(e){this.palette=e,this.changed=!0}show(e){this.changed&&this.upload(),this.line.geometry.instanceCount=Math.min(e,this.count),this.line.visible=e>0}upload(){this.changed=!1;let{geometry:e}=this.line;e.dispose();let t=6*Math.max(1,this.count),n=new Float32Array(t);for(let s=0;s<this.count;s++)for(let r of[6*s,6*s+3])this.palette[this.kinds[s]].toArray(n,r);e.setPositions(this.count?this.positions:new Float32Array(t)).setColors(n)}};var _n=({plan:{goal:i}})=>i?.kind==="polished"||i?.kind==="dispensed",Mi=({plan:{goal:i}})=>i?.kind==="dispensed"?"coat thickness":"passes",Qa=.51,Js={little:"too little",allowed:"allowed",much:"too much"},ru={little:4,allowed:3,much:2};function Ax(i,e,t,n){let s=n?Math.min(t,e-i):t,r=Array.from({length:s},(o,a)=>i+(e-i)*a/s);return n?r.map(Math.floor):r}function gs({unit:i,low:e,high:t,target:n}){let s=i==="passes",r=s?t+1:t,o={little:Ax(0,e,ru.little,s),allowed:Ax(e,r,ru.allowed,s),much:[r,s?r+Math.max(1,t-e):t+2*(t-n)]},a=(h,u,d)=>{let[f,p]=[h==="little"&&d<ru.little?2:1,ru[h]];return f+Math.round(u*(p-f)/Math.max(1,d-1))},l=Object.keys(o).flatMap(h=>o[h].map((u,d,{length:f})=>({degree:h,from:u,colour:`${h}-${a(h,d,f)}`}))),c=h=>String(s?h:Number(h.toPrecision(h<100?2:3)));return l.map((h,u)=>{let d=l[u+1]?.from,f=d===void 0?null:s?d-1:d;return{...h,label:f===null?`\u2265 ${c(h.from)}`:f===h.from?c(f):`${c(h.from)}\u2013${c(f)}`}})}function xs(i,{unit:e,target:t},n){let s=e==="passes"?Math.round(n):n,r=1e-6*t,o=0;return i.forEach(({degree:a,from:l},c)=>{(a==="much"&&e!=="passes"?s>l+r:s>=l-r)&&(o=c)}),o}function el(i,e){let t=gs(i);return e.map(n=>t[xs(t,i,n)].degree)}var tl=(i,e)=>i.filter(t=>t===e).length/Math.max(1,i.length),Cx=({unit:i,low:e,high:t})=>e===t?`${e} ${i}`:`${e} to ${t} ${i}`,Rx=new WeakMap;function bn(i,e){if(!i||!e||e.length!==i.places.length/2)return null;let t=Rx.get(e);if(t)return t;let n=e.map(s=>di(s)*i.step);return Rx.set(e,n),n}function ou(i,e,t,n){let s=i.endedAt(e);if(s?.plan.treatment){let{interpreted:a,truth:l,plan:{treatment:c,surface:h}}=s,u=a?.found??h.pose,d=`${Mi(s)} after round ${s.number}`,f=n.actual?bn(c,l?.treated):null;if(f)return{kind:"true",title:`True ${d}`,record:c,values:f,pose:l?.surface??u,shape:ja(l,h.shape)};let p=n.estimated?bn(c,a?.treated):null;if(p)return{kind:"estimated",title:`Estimated ${d}: mean of the belief`,record:c,values:p,pose:u,shape:h.shape}}let{treatment:r,surface:o}=t.plan;return!n.believed||!r||!t.treated?null:{kind:"predicted",title:`Predicted ${Mi(t)}`,record:r,values:t.treated.at(e-t.start),pose:o.pose,shape:o.shape}}var Px={axis:{label:"",height:20,plot:!1},rounds:{label:"Round",height:20,plot:!1},phases:{label:"Phase, stroke",height:18,plot:!1},contact:{label:"Contact",height:12,plot:!1},events:{label:"Events",height:18,plot:!1},force:{label:"Force [N]",height:74,plot:!0},height:{label:`Tool height
[mm]`,height:50,plot:!0},performance:{label:`Performance
[%]`,height:88,plot:!0}},nl=[3,2],Ix=[1,4],iE=4,au=class{constructor(e){this.names=e}names;lanes=[];left=112;right=22;width=600;height=0;from=0;to=1;layOut(e,t){this.width=e;let n=e<560;this.left=n?34:112;let s=0;this.lanes=this.names.map(r=>{let{plot:o,height:a}=Px[r];n&&o&&(s+=13);let l={...Px[r],name:r,top:s,height:Math.round(a*(o&&t?.66:1))};return s+=l.height+iE+(o?4:0),l}),this.height=s}get narrow(){return this.left<100}get span(){return this.width-this.left-this.right}x(e){return this.left+(e-this.from)/(this.to-this.from)*this.span}t(e){return this.from+(e-this.left)/this.span*(this.to-this.from)}lane(e){return this.lanes.find(t=>t.name===e)}},sE=[.01,.02,.05,.1,.2,.5,1,2,5,10,20,30,60,120,300,600,1200,1800,3600,7200];function lu(i,e,t){let n=sE.find(s=>(e-i)/s<=t)??(e-i)/t;return{step:n,times:Lx(n,i,e)}}function Lx(i,e,t){let n=Math.ceil(e/i-1e-9);return Array.from({length:Math.max(0,Math.floor(t/i+1e-9)-n+1)},(s,r)=>(n+r)*i)}function Dx(i,e,t){let n=(e-i)/t,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(o=>o*s).find(o=>o>=n*.999)??n;return Lx(r,i,e)}function il(i,{size:e=11,weight:t=400,align:n="left",base:s="middle",name:r="quiet"}={}){i.font=`${t} ${e}px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif`,i.textAlign=n,i.textBaseline=s,i.fillStyle=De(r)}function li(i,e,t,n,s,r){i.fillStyle=De(e),i.fillRect(t,n,s,r)}function sl(i,[e,t,n,s],r){i.save(),i.beginPath(),i.rect(e,t,n,s),i.clip(),r(),i.restore()}function An(i,e,t,n,s={}){let{room:r=1/0,halo:o=!1}=s;if(r<14)return;il(i,s);let a=e.length>200?e.slice(0,200):e;if(i.measureText(a).width>r){for(;a.length>1&&i.measureText(`${a}\u2026`).width>r;)a=a.slice(0,-1);if(a.length<3)return;a+="\u2026"}[i.strokeStyle,i.lineWidth,i.lineJoin]=[De("paper"),3,"round"],o&&i.strokeText(a,t,n),i.fillText(a,t,n)}function hn(i,e,t,n,s,r,o=1){i.strokeStyle=De(r),i.lineWidth=o,i.beginPath(),i.moveTo(e,t),i.lineTo(n,s),i.stroke()}var rE=1.12,oE=1.8,Nx=16,aE=[.45,.7,.95];function hp(i){return i.filter(({visible:e})=>e).flatMap(e=>{let t=e instanceof ot?e.geometry:null;t&&!t.boundingBox&&t.computeBoundingBox();let n=t?.boundingBox;return[...n&&!n.isEmpty()?[{worldFromBox:e.matrixWorld,box:n}]:[],...hp(e.children)]})}var up=({min:i,max:e})=>Array.from({length:8},(t,n)=>new E(n&1?e.x:i.x,n&2?e.y:i.y,n&4?e.z:i.z)),so=i=>hp(i).flatMap(({worldFromBox:e,box:t})=>up(t).map(n=>n.applyMatrix4(e))),cu=i=>hp(i).map(({worldFromBox:e,box:t})=>({blockFromWorld:e.clone().invert(),box:t}));function dp({blockFromWorld:i,box:e},t,n){let s=t.clone().applyMatrix4(i),r=n.clone().applyMatrix4(i).sub(s),o=new gi(s,r.clone().normalize()).intersectBox(e,new E);return e.containsPoint(s)||o!==null&&o.distanceTo(s)<r.length()}function kx(i,e,t){return i.length?i.filter(n=>{let s=n.clone().addScaledVector(e,oE);return!t.some(r=>dp(r,n,s))}).length/i.length:1}function Ox(i,e,t,n){let[s,r]=[n,-1/0];for(let o of aE)for(let a=0;a<Nx;a++){let l=2*Math.PI*a/Nx,c=new E(Math.cos(o)*Math.cos(l),Math.cos(o)*Math.sin(l),Math.sin(o)),h=c.dot(t);if(h<.2)continue;let u=0;for(let{blocks:f,tool:p}of i)u+=(3*kx(p,c,f)+2*kx(e,c,f))/i.length;let d=u+2*Math.min(h,.8)+.6*c.dot(n);d>r&&([s,r]=[c,d])}return s}var Ux=i=>i.reduce((e,t)=>e.addScaledVector(t,1/i.length),new E);function hu(i,e,{high:t,wide:n}){if(!i.length)return null;let s=e.clone().normalize(),r=new E().crossVectors(new E(0,0,1),s).normalize(),o=new E().crossVectors(s,r),a=h=>{let u=i.map(d=>d.dot(h));return(Math.min(...u)+Math.max(...u))/2},l=new E().addScaledVector(r,a(r)).addScaledVector(o,a(o)).addScaledVector(s,a(s)),c=()=>Math.max(.1,...i.map(h=>{let u=h.clone().sub(l);return u.dot(s)+rE*Math.max(Math.abs(u.dot(r))/n,Math.abs(u.dot(o))/t)}));for(let h=0;h<3;h++){let u=c(),d=x=>{let m=i.map(g=>{let y=g.clone().sub(l);return y.dot(x)/Math.max(.05,u-y.dot(s))});return(Math.min(...m)+Math.max(...m))/2*u},[f,p]=[d(r),d(o)];l.addScaledVector(r,f).addScaledVector(o,p)}return{target:l,eye:l.clone().addScaledVector(s,c())}}var zn=.0015,fp=[.005*nl[0],.005*nl[1]],lE=.2,cE=.03,hE=.12,uE=/board|table|wood|desk|counter/i;function ro(i,e=zn){let t=pt(i);return Array.from({length:t.length/2},(n,s)=>[t[2*s],t[2*s+1],e])}var uu=class{constructor(e,{head:t,meshes:n}){this.round=e;let{plan:s}=e;this.group.add(this.bodies);for(let{part:r,...o}of s.scene){let a=Vi(o,n),l=r==="obstacle",c=new ot(a,Et(Ys(new Un,1.015),l?"obstacle":"carrier"));c.receiveShadow=c.castShadow=!0,l&&this.obstacles.push(c);let h=new Br(new ca(a,30),Et(Ys(new Ls({transparent:!0,opacity:.4}),1.01),"obstacle-line"));this.bodies.add(jt(c,o.pose)),this.group.add(jt(h,o.pose))}this.addSurface(uE.test(t?.task?.surface??"")),this.addGoal(),s.strokes.forEach(r=>{let o=Et(new $t({linewidth:6,transparent:!0,opacity:.35}),"stroke"),a=Bn(ms(fs(s.surface.shape,ro(r,2*zn),!1),!1),o);this.strokes.push(a),this.strokeGroup.add(a)}),this.group.add(jt(this.strokeGroup,s.surface.pose))}round;group=new rt;bodies=new rt;obstacles=[];sights=null;surface=null;outlines=new Map;strokes=[];strokeGroup=new rt;show(e,t,n,s){let{truth:r}=this.round,o=r?.surface??null,{shape:a}=this.round.plan.surface;for(let l of this.outlines.values())l.visible=!1;n&&e.found&&this.showOutline(n,()=>this.outlineAt(n,a,"found",.28)),o&&e.actual&&this.showOutline(o,()=>this.outlineAt(o,ja(r,a),"actual",0)),this.strokeGroup.visible=e.strokes||s!==null,this.strokes.forEach((l,c)=>{l.visible=e.strokes||c===s,Et(l.material,c===s?"chosen":"stroke"),l.material.linewidth=c===s?7:c===t?9:6,l.material.opacity=c===s?1:c===t?.6:.35})}showOutline(e,t){let n=this.outlines.get(e);n||(n=t(),this.outlines.set(e,n),this.group.add(n)),n.visible=!0}fade(e){if(!(!this.surface||!this.obstacles.length)){this.sights??=this.pointsOver(cE);for(let t of this.obstacles){let[n]=cu([t]),s=n!==void 0&&this.sights.some(r=>dp(n,r,e));t.material.transparent=s,t.material.opacity=s?lE:1,t.material.depthWrite=t.castShadow=!s}}}get rings(){return this.round.plan.surface.rings.map(e=>ro(e)).filter(e=>e.length>=3)}face(){let e=this.round.plan.surface.shape;if(e?.kind==="mesh")return Jh(e).geometry;let[t,...n]=this.rings.map(r=>r.map(([o,a])=>new ee(o,a)));if(!t)return null;let s=new ki(t);return s.holes=n.map(r=>new ki(r)),rp(e,new Fs(s))}get corners(){return this.surface?so([this.surface]):[]}pointsOver(e){this.group.updateMatrixWorld(!0);let t=Ux(this.corners);return[t,...this.corners.map(n=>n.lerp(t,hE))].map(n=>n.clone().addScaledVector(ds(this.round.plan.surface,n),e))}addSurface(e){let{pose:t,shape:n}=this.round.plan.surface,s=this.face();if(!s)return;let r=new Un({side:yn,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1});e&&!n&&(r.map=_x()),this.surface=jt(new ot(s,Et(r,e?"surface-3d":"sheet-3d")),t),this.surface.receiveShadow=!0,this.bodies.add(this.surface);let o=this.rings.flatMap(a=>ms(fs(n,a,!0),!0));this.group.add(jt(Bn(o,Et(new $t({linewidth:2}),"outline")),t))}outlineAt(e,t,n,s){let r=jt(new rt,e),o=Et(new $t({linewidth:s?3:2}),n),a=this.rings.flatMap(c=>ms(fs(t,c.map(([h,u,d])=>[h,u,d+(s?1:2)*zn]),!0),!0));r.add(Bn(s?a:su(a,fp),o));let l=s?this.face():null;if(l){let c=new Un({transparent:!0,opacity:s,depthWrite:!1});r.add(new ot(l,Et(c,n)))}return r}addGoal(){let{goal:e,surface:t}=this.round.plan;if(e?.kind!=="collected")return;let[n,s]=e.place,r=jt(new rt,t.pose),o=(a,l,c)=>{let h=new Un({transparent:!0,opacity:l,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-3,polygonOffsetUnits:-3});a.translate(n,s,zn),r.add(new ot(rp(t.shape,a),Et(h,c)))};o(new Qi(e.radius,48),.22,"goal"),o(new Us(Math.max(0,e.radius-.003),e.radius,48),1,"goal-line"),o(new Qi(Math.min(.006,.3*e.radius),24),1,"goal-line"),this.group.add(r)}},dE=[[-1,-1],[1,-1],[1,1],[-1,1]];function fE({record:i,shape:e}){let t=pt(i.places),[n,s]=i.cell.map(c=>Qa*c),r=t.length/2,o=new Float32Array(12*r),a=[];for(let c=0;c<r;c++)dE.forEach(([h,u],d)=>o.set(ai(e,t[2*c]+h*n,t[2*c+1]+u*s,zn/2),12*c+3*d)),a.push(4*c,4*c+1,4*c+2,4*c,4*c+2,4*c+3);let l=new yt(new Float32Array(12*r),3);return new Ze().setAttribute("position",new yt(o,3)).setAttribute("color",l).setIndex(a)}var du=class{mesh=new ot(new Ze,new ln({vertexColors:!0,side:yn,toneMapped:!1,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-2}));shown=null;theme="";constructor(){this.mesh.frustumCulled=!1}show(e,t){if(this.mesh.visible=e!==null,!e)return;jt(this.mesh,e.pose);let n=this.shown?.record===e.record&&this.shown.shape===e.shape;n||(this.mesh.geometry.dispose(),this.mesh.geometry=fE(e)),(!n||this.shown?.values!==e.values||this.theme!==t)&&this.paint(e),this.shown=e,this.theme=t}paint({record:e,values:t}){let n=gs(e),s=n.map(o=>new Ae(De(o.colour))),r=this.mesh.geometry.getAttribute("color");t.forEach((o,a)=>{let{r:l,g:c,b:h}=s[xs(n,e,o)];for(let u=0;u<4;u++)r.setXYZ(4*a+u,l,c,h)}),r.needsUpdate=!0}};var pE=.1,mE=11,gE=13,pp=i=>new Path2D(`M32 ${32-i}l${i} ${i}l${-i} ${i}l${-i} ${-i}z`),xE=i=>ps(e=>{e.fillStyle="#000",e.fill(pp(31)),e.fillStyle="#fff",e.fill(pp(24)),i&&(e.globalCompositeOperation="destination-out",e.fill(pp(13)))}),mp=i=>ys(i,De("highlight"));function Fx(i){return i.map(({color:e,pose:t,shape:n,places:s,state:r},o)=>{let a=s.flatMap(([c,h])=>ai(n,c,h,2*zn)),l=jt(Zs(a,xE(r==="estimated"),gE,{renderOrder:7+o/(i.length+1)}),t);return l.material.color.set(mp(e)),l})}var yE=6,gp=i=>`track-${i%yE+1}`,Bx=i=>i.flatMap(({points:e,samples:t,color:n},s)=>{let r=new $t({linewidth:4.5,transparent:!0,polygonOffset:!0,polygonOffsetFactor:-12,polygonOffsetUnits:-12});r.color.set(fu(n,s));let o=Bn(ms(e,!1),r);return o.renderOrder=6,t?.length?[o,Vx(t,fu(n,s))]:[o]}),zx=i=>i.flatMap(({pose:e,color:t})=>{let n=At(e),s=new E().setFromMatrixPosition(n).toArray();return[...["axis-x","axis-y","axis-z"].map((o,a)=>{let l=new E().setComponent(a,pE).applyMatrix4(n).toArray();return Bn([...s,...l],Et(new $t({linewidth:3.5}),o))}),Vx([s],ys(t,De("axis-z")))]});function Vx(i,e){let t=Zs(i.flat(),Qh(),mE);return t.material.color.set(e),t}var ys=(i,e)=>i&&/^#[0-9a-f]{3,8}$/i.test(i)?i:e,fu=(i,e)=>ys(i,De(gp(e)));var vs=400,Qs=220,[oo,xp,yp,rl]=[52,12,10,38],Si=27,pu=130,Gx=20,vE=21;function Hx(i,e){let t=a=>a?.map(([l,c])=>[e(l),c]),n={...i,amounts:t(i.amounts),spans:t(i.spans)},s=n.title||n.id||n.diagram,r=n.amounts?n.diagram==="piechart"?wE(n.amounts):_E(n.amounts):n.spans?ME(n.spans):SE(n);r.setAttribute("role","img"),r.setAttribute("aria-label",`${n.diagram}: ${s}`);let o=[n.x_label,n.y_label].filter(a=>a);return _("figure",{class:"s-plot"},_("figcaption",{},s),r,o.length?_("p",{class:"w-quiet"},o.join(" / ")):null)}var bs=i=>Number.isInteger(i)?Fe(i,0):Fe(i,Math.abs(i)<10?3:1),al=(i,...e)=>ie("svg",{viewBox:`0 0 ${vs} ${i}`},...e),Wx=(i,e,t,n="end")=>{let[s="",r]=t.split(`
`);if(!r)return[Yt(i,e,ol(s,Gx),n)];let o=Yt(i,e+6,ol(r,vE),n,{fill:"var(--quiet)","font-size":9.5});return[Yt(i,e-5,ol(s,Gx),n),o]},bE=i=>i.replace(`
`,", "),ol=(i,e)=>i.length>e?`${i.slice(0,e-1)}\u2026`:i;function $x(i,[e,t],n,s){let r=o=>pu+(vs-pu-n)*(o-e)/(t-e||1);return i.flatMap(({name:o,from:a,to:l,value:c,label:h},u)=>[...Wx(pu-6,u*Si+17,o),ie("rect",{x:r(a),y:u*Si+4,width:Math.max(1,r(l)-r(a)),height:Si-6,rx:3,fill:`var(--${s})`},ie("title",{},`${bE(o)}: ${c}`)),...h===void 0?[]:[Yt(r(l)+5,u*Si+17,h)]])}function _E(i){let e=i.map(([,n])=>n),t=i.map(([n,s])=>({name:n,from:Math.min(0,s),to:Math.max(0,s),value:String(s),label:bs(s)}));return al(t.length*Si+6,...$x(t,[Math.min(0,...e),Math.max(0,...e)],52,"believed"))}function wE(i){let e=i.reduce((l,[,c])=>l+c,0)||1,[t,n,s]=[90,92,82],r=-Math.PI/2,o=l=>`${t+s*Math.cos(l)} ${n+s*Math.sin(l)}`,a=Math.max(2*n,i.length*Si+10);return al(a,...i.flatMap(([l,c],h)=>{let u=r;r+=2*Math.PI*c/e;let d=`var(--${gp(h)})`;return[c>=e?ie("circle",{cx:t,cy:n,r:s,fill:d}):ie("path",{d:`M${t} ${n}L${o(u)}A${s} ${s} 0 ${r-u>Math.PI?1:0} 1 ${o(r)}Z`,fill:d,stroke:"var(--paper)"}),ie("rect",{x:190,y:h*Si+4,width:12,height:12,fill:d}),...Wx(208,h*Si+14,l,"start"),Yt(vs-4,h*Si+14,`${bs(c)} (${Fe(100*c/e,0)} %)`,"end")]}))}function ME(i){let e=[Math.min(...i.map(([,[s]])=>s)),Math.max(...i.map(([,[,s]])=>s))],t=i.map(([s,[r,o]])=>({name:s,from:r,to:o,value:`${bs(o-r)} s`})),n=t.length*Si+22;return al(n,...$x(t,e,10,"event"),Yt(pu,n-4,"0 s"),Yt(vs-10,n-4,`${bs(e[1]-e[0])} s`,"end"))}function SE({points:i=[],diagram:e,x_label:t,y_label:n}){let s=d=>{let f=i.map(m=>m[d]),[p,x]=[Math.min(...f),Math.max(...f)];return p<x?[p,x]:[p-.5,x+.5]};if(!i.length)return al(30,Yt(8,18,"no points"));let[[r,o],[a,l]]=[s(0),s(1)],c=d=>oo+(vs-oo-xp)*(d-r)/(o-r),h=d=>Qs-rl-(Qs-yp-rl)*(d-a)/(l-a),u=e==="linechart"?[ie("path",{d:i.map(([d,f],p)=>`${p?"L":"M"}${c(d).toFixed(1)} ${h(f).toFixed(1)}`).join(""),fill:"none",stroke:"var(--believed)","stroke-width":1.8})]:i.map(([d,f])=>ie("circle",{cx:c(d),cy:h(f),r:2.6,fill:"var(--believed)","fill-opacity":.7}));return al(Qs,ie("path",{d:`M${oo} ${yp}V${Qs-rl}H${vs-xp}`,fill:"none",stroke:"var(--rule)"}),...u,Yt(oo-5,h(a),bs(a),"end"),Yt(oo-5,h(l)+9,bs(l),"end"),Yt(oo,Qs-rl+15,bs(r)),Yt(vs-xp,Qs-rl+15,bs(o),"end"),Yt(vs/2,Qs-5,ol(t,40),"middle"),Yt(4,yp+22,ol(n,30)))}var vp=class{constructor(e){this.host=e}host;steps=new Map;draws=new Set;drawn=null;asked=!1;last=0;request(e){return this.steps.set(++this.last,e),this.ask(),this.last}now(){return performance.now()}cancel(e){this.steps.delete(e)}draw(e){this.draws.add(e),this.ask()}drop(e){this.draws.delete(e)}ask(){this.asked||this.drawn||(this.asked=!0,this.host(e=>this.run(e)))}run(e){this.asked=!1;let t=this.drawn=new Set,n=this.steps;this.steps=new Map;for(let s of n.values())Xx(()=>s(e));for(let s=this.next(t);s;s=this.next(t))this.draws.delete(s),t.add(s),Xx(s);this.drawn=null,(this.steps.size||this.draws.size)&&this.ask()}next(e){for(let t of this.draws)if(!e.has(t))return t;return null}};function ao(i,e){let t=-1/0,n,s=()=>{n=void 0,t=performance.now(),e()};return{ask:()=>{if(n!==void 0)return;let r=t+i-performance.now();r<=0?s():n=setTimeout(s,r)},stop:()=>clearTimeout(n)}}function mu(i,e){let t=i.onChange(n=>{n?.piece!=="samples"&&Rn.draw(e)});return()=>{t(),Rn.drop(e)}}function Xx(i){try{i()}catch(e){reportError(e)}}var Rn=new vp(i=>requestAnimationFrame(i)),TE=null;function er(){return TE??=EE()}function EE(){let i=document.createElement("canvas").getContext("webgl2");if(!i)return!0;let e=i.getExtension("WEBGL_debug_renderer_info"),t=/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e?String(i.getParameter(e.UNMASKED_RENDERER_WEBGL)):"");return i.getExtension("WEBGL_lose_context")?.loseContext(),t}var qx={type:"change"},_p={type:"start"},Zx={type:"end"},gu=new gi,Yx=new Dn,AE=Math.cos(70*Kr.DEG2RAD),Ft=new E,Cn=2*Math.PI,ct={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},bp=1e-6,xu=class extends La{constructor(e,t=null){super(e,t),this.state=ct.NONE,this.target=new E,this.cursor=new E,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:rs.ROTATE,MIDDLE:rs.DOLLY,RIGHT:rs.PAN},this.touches={ONE:os.ROTATE,TWO:os.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new E,this._lastQuaternion=new Rt,this._lastTargetPosition=new E,this._quat=new Rt().setFromUnitVectors(e.up,new E(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new $r,this._sphericalDelta=new $r,this._scale=1,this._panOffset=new E,this._rotateStart=new ee,this._rotateEnd=new ee,this._rotateDelta=new ee,this._panStart=new ee,this._panEnd=new ee,this._panDelta=new ee,this._dollyStart=new ee,this._dollyEnd=new ee,this._dollyDelta=new ee,this._dollyDirection=new E,this._mouse=new ee,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=CE.bind(this),this._onPointerDown=RE.bind(this),this._onPointerUp=PE.bind(this),this._onContextMenu=UE.bind(this),this._onMouseWheel=DE.bind(this),this._onKeyDown=NE.bind(this),this._onTouchStart=kE.bind(this),this._onTouchMove=OE.bind(this),this._onMouseDown=IE.bind(this),this._onMouseMove=LE.bind(this),this._interceptControlDown=FE.bind(this),this._interceptControlUp=BE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=ct.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(qx),this.update(),this.state=ct.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Ft.copy(t).sub(this.target),Ft.applyQuaternion(this._quat),this._spherical.setFromVector3(Ft),this.autoRotate&&this.state===ct.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Cn:n>Math.PI&&(n-=Cn),s<-Math.PI?s+=Cn:s>Math.PI&&(s-=Cn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Ft.setFromSpherical(this._spherical),Ft.applyQuaternion(this._quatInverse),t.copy(this.target).add(Ft),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Ft.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new E(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new E(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Ft.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(gu.origin.copy(this.object.position),gu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(gu.direction))<AE?this.object.lookAt(this.target):(Yx.setFromNormalAndCoplanarPoint(this.object.up,this.target),gu.intersectPlane(Yx,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>bp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>bp||this._lastTargetPosition.distanceToSquared(this.target)>bp?(this.dispatchEvent(qx),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Cn/60*this.autoRotateSpeed*e:Cn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Ft.setFromMatrixColumn(t,0),Ft.multiplyScalar(-e),this._panOffset.add(Ft)}_panUp(e,t){this.screenSpacePanning===!0?Ft.setFromMatrixColumn(t,1):(Ft.setFromMatrixColumn(t,0),Ft.crossVectors(this.object.up,Ft)),Ft.multiplyScalar(e),this._panOffset.add(Ft)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Ft.copy(s).sub(this.target);let r=Ft.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Cn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Cn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Cn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Cn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new ee,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function RE(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function CE(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function PE(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Zx),this.state=ct.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function IE(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case rs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=ct.DOLLY;break;case rs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=ct.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=ct.ROTATE}break;case rs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=ct.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=ct.PAN}break;default:this.state=ct.NONE}this.state!==ct.NONE&&this.dispatchEvent(_p)}function LE(i){switch(this.state){case ct.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case ct.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case ct.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function DE(i){this.enabled===!1||this.enableZoom===!1||this.state!==ct.NONE||(i.preventDefault(),this.dispatchEvent(_p),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Zx))}function NE(i){this.enabled!==!1&&this._handleKeyDown(i)}function kE(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case os.ROTATE:if(this.enableRotate===!1){this.state=ct.NONE;break}this._handleTouchStartRotate(i),this.state=ct.TOUCH_ROTATE;break;case os.PAN:if(this.enablePan===!1){this.state=ct.NONE;break}this._handleTouchStartPan(i),this.state=ct.TOUCH_PAN;break;default:this.state=ct.NONE}break;case 2:switch(this.touches.TWO){case os.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=ct.TOUCH_DOLLY_PAN;break;case os.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=ct.TOUCH_DOLLY_ROTATE;break;default:this.state=ct.NONE}break;default:this.state=ct.NONE}this.state!==ct.NONE&&this.dispatchEvent(_p)}function OE(i){switch(this._trackPointer(i),this.state){case ct.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case ct.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case ct.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case ct.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=ct.NONE}}function UE(i){this.enabled!==!1&&i.preventDefault()}function FE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function BE(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var yu=Math.PI/24,jx=1.15,zE=380,vu=class{constructor(e,t,n){this.taken=n;this.lens.up.set(0,0,1),this.controls=Object.assign(new xu(this.lens,e),{maxPolarAngle:.62*Math.PI,minDistance:.1,maxDistance:40,zoomToCursor:!0}),this.controls.addEventListener("start",()=>{this.held=!0}),this.controls.addEventListener("end",()=>{this.held=!1}),this.controls.addEventListener("change",()=>{this.held&&this.take(),t()}),e.addEventListener("wheel",s=>{let{scrollHeight:r,clientHeight:o}=document.documentElement;this.controls.enableZoom=s.ctrlKey||document.activeElement===e||r<=o+1},{capture:!0,passive:!0}),e.addEventListener("pointerdown",()=>{this.controls.enableZoom=!0,e.focus({preventScroll:!0})},!0),e.addEventListener("keydown",s=>{if(s.ctrlKey||s.metaKey||s.altKey)return;let{controls:r}=this,a={a:()=>r.rotateLeft(yu),d:()=>r.rotateLeft(-yu),w:()=>r.rotateUp(yu),s:()=>r.rotateUp(-yu),z:()=>r.dollyIn(1/jx),x:()=>r.dollyIn(jx)}[s.key];a&&(this.take(),a(),s.preventDefault(),s.stopPropagation())})}taken;lens=new pn(36,1,.02,200);controls;open=1;goal=null;stepped=0;asked=!1;held=!1;get angles(){let e=Math.tan(this.lens.fov*Math.PI/360);return{high:e,wide:e*this.lens.aspect*this.open}}look(e,t=!1){if(e){if(this.goal=t&&!matchMedia("(prefers-reduced-motion: reduce)").matches?e:null,this.stepped=performance.now(),this.asked=t,!this.goal)return this.move(e);this.controls.dispatchEvent({type:"change"})}}step(){if(!this.goal)return!1;let e=performance.now(),t=1-Math.exp((this.stepped-e)/zE);this.stepped=e;let{goal:n}=this,s=this.controls.target.clone().lerp(n.target,t),r=this.lens.position.clone().lerp(n.eye,t);return r.distanceTo(n.eye)+s.distanceTo(n.target)<.002*r.distanceTo(s)&&(this.goal=null),this.move(this.goal?{target:s,eye:r}:n),this.goal!==null}followLinked(e,t){t&&this.take(),this.goal=null,this.move(e)}get view(){return{target:this.controls.target.clone(),eye:this.lens.position.clone()}}pixelsPerMetre(e,t){let n=e?new E().setFromMatrixPosition(e.matrix):this.controls.target;return t/(2*Math.tan(this.lens.fov*Math.PI/360)*Math.max(.05,n.distanceTo(this.lens.position)))}shape(e,t,n){this.lens.aspect=e/t,this.open=(e-n)/e,this.lens.setViewOffset(e,t,-n/2,0,e,t)}move({target:e,eye:t}){let{held:n}=this;this.held=!1,this.controls.target.copy(e),this.lens.position.copy(t),this.controls.update(),this.held=n}take(){this.goal=null,this.asked=!0,this.taken()}};var Mp=new E(0,0,1),Ti=(i,e=new E)=>new Ie().makeRotationFromQuaternion(new Rt().setFromUnitVectors(Mp,i.clone().normalize())).setPosition(e);function un(i,e=24){let t=new ya(i.map(([n,s])=>new ee(n,s)),e).rotateX(Math.PI/2);return t.setIndex([...t.index.array].filter((n,s)=>{let r=Math.floor(s/6)%(i.length-1),[o,a]=[i[r],i[r+1]];return(o[0]!==a[0]||o[1]!==a[1])&&(s%6<3?o:a)[0]>0}))}function bu({from:i,to:e,radius:t},n,s,r){let o=e.x-i.x,a=e.y-i.y,l=e.z-i.z,c=o*o+a*a+l*l,h=c>0?Math.min(1,Math.max(0,((n-i.x)*o+(s-i.y)*a+(r-i.z)*l)/c)):0;return Math.hypot(n-i.x-h*o,s-i.y-h*a,r-i.z-h*l)-t}var Kx=.012,wp=.01,ll=1e-4;function VE({rods:i,box:e,edge:t},n,s,r){let o=0;for(let u of i)o+=Math.exp(-bu(u,n,s,r)/Kx);let a=Math.abs(n)-e.x+t,l=Math.abs(s)-e.y+t,c=Math.abs(r)-e.z+t,h=Math.hypot(Math.max(0,a),Math.max(0,l),Math.max(0,c))+Math.min(0,Math.max(a,l,c))-t;return wp*Math.log(o**(-Kx/wp)+Math.exp(h/wp))}function GE(i,e){if(i(0)>=0)return 0;let[t,n]=[0,e];for(;n-t>.5*ll;){let s=(t+n)/2;i(s)<0?t=s:n=s}return(t+n)/2}function Sp(i,e,[t,n],[s,r],o){let a=Math.ceil((n-t)/o),[l,c]=[Math.asin(s),Math.asin(r)],h=Math.max(2,Math.ceil((c-l)/o)),u=Array.from({length:h+1},(S,b)=>Math.sin(l+b/h*(c-l))),d=[...s<=-1?[-1]:[],...u,...r>=1?[1]:[]],[f,p,x]=[[],[],[]],[m,g]=[new E,new E],y=(S,b,A)=>VE(i,S,b,A)+e;return d.forEach((S,b)=>{let A=b===0&&s<=-1||b===d.length-1&&r>=1,R=S*(i.box.z-e-ll);for(let v=0;v<=a;v++){let T=t+(n-t)*v/a,D=Math.cos(T),P=Math.sin(T),k=A?0:GE(H=>y(H*D,H*P,R),2*i.box.length()),O=k*D,V=k*P,I=y(O,V,R);m.set(O,V,R).applyMatrix4(i.linkFromShell),g.set(y(O+ll,V,R)-I,y(O,V+ll,R)-I,y(O,V,R+ll)-I).transformDirection(i.linkFromShell);let G=b*(a+1)+v;f.push(m.x,m.y,m.z),p.push(g.x,g.y,g.z);let $=G-a-1;b>0&&v<a&&x.push($,$+1,G,G,$+1,G+1)}}),new Ze().setAttribute("position",new Pe(f,3)).setAttribute("normal",new Pe(p,3)).setIndex(x)}var Cp=.007,HE=600,WE=5.5,$E=18,XE=.03,Tp=1500,qE=1.7,YE=.6,ZE=.35,_u=.4,SL=_u+.32*(1-_u),Ap=["position","normal"],lo=(i,e)=>i.getAttribute(e);function Qx(i){return/crumb|chip|sand|gravel|debris/i.test(i??"")?"crumb":/water|detergent|soap|juice|milk/i.test(i??"")?"drop":null}function Rp(i,e){let t=Math.sin(12.9898*i+78.233*e)*43758.5453;return t-Math.floor(t)}var Ep=(i,e,t,n)=>new Oi(1,i,e,0,2*Math.PI,0,t*Math.PI).rotateX(Math.PI/2).translate(0,0,-Math.cos(t*Math.PI)).scale(1,1,n);function Jx(i){let e=lo(i,"position");for(let t=0;t<e.count;t++){let n=1-ZE*Rp(Math.round(20*e.getX(t)),Math.round(20*e.getY(t))+Math.round(20*e.getZ(t)));e.setXYZ(t,n*e.getX(t),n*e.getY(t),n*e.getZ(t))}return i.deleteAttribute("normal")}function jE(){let i=new Qi(qE,8),{count:e}=i.getAttribute("position");return i.setAttribute("color",new yt(Float32Array.from({length:4*e},(t,n)=>n===3?YE:0),4)),i.deleteAttribute("normal")}var wu=class{mesh;shape=null;capacity=0;constructor(e){this.mesh=new ot(new Ze,e),this.mesh.frustumCulled=!1}place(e,t,n,s){let r=t.length/2;(this.shape!==e||this.capacity<r)&&this.reserve(e,2*r);let{geometry:o}=this.mesh;for(let a=0;a<r;a++)KE(o,e,a,n,s,t[2*a],t[2*a+1]);for(let a of Ap)o.hasAttribute(a)&&(lo(o,a).needsUpdate=!0);o.setDrawRange(0,r*e.index.count)}reserve(e,t){this.mesh.geometry.dispose();let n=new Ze,[s,r]=[lo(e,"position").count,e.index];for(let o of[...Ap,"color"].filter(a=>e.hasAttribute(a))){let{array:a,itemSize:l}=lo(e,o);n.setAttribute(o,new yt(Float32Array.from({length:a.length*t},(c,h)=>a[h%a.length]),l))}n.setIndex(new yt(Uint32Array.from({length:r.count*t},(o,a)=>r.array[a%r.count]+s*Math.floor(a/r.count)),1)),this.mesh.geometry=n,[this.shape,this.capacity]=[e,t]}},Mu=class{group=new rt;few;many;shadow=jE();grains;shadows=new wu(new ln({vertexColors:!0,transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-2}));drawn={places:null,radius:0};constructor(e){[this.few,this.many]=e==="crumb"?[Jx(Ep(5,3,.62,.85)),Jx(new Ns(1,1,4,1,!0).rotateX(Math.PI/2).translate(0,0,.5))]:[Ep(8,3,.5,.55),Ep(6,2,.5,.55)],this.grains=new wu(new wa(e==="crumb"?{flatShading:!0,specular:6710886,shininess:8}:{specular:10066329,shininess:60})),this.group.add(this.grains.mesh,this.shadows.mesh),this.paint()}paint(){let{color:e,emissive:t}=this.grains.mesh.material;e.set(De("believed")),t.copy(e).multiplyScalar(_u),e.multiplyScalar(1-_u)}show(e,t,n,s){if(this.group.visible=e!==null&&e.length>0,!e||!this.group.visible)return;jt(this.group,t);let r=e.length/2,o=Cp*Math.min(1,Math.sqrt(HE/r)),a=Math.min($E/s,Math.max(WE/s,o))/2;this.drawn.places===e&&Math.abs(a/this.drawn.radius-1)<XE||(this.drawn={places:e,radius:a},this.grains.place(r<Tp?this.few:this.many,e,a,n),this.shadows.mesh.visible=r<Tp,r<Tp&&this.shadows.place(this.shadow,e,a,n))}};function KE(i,e,t,n,s,r,o){let a=new E(...ai(s,r,o,0)),l=Ti(new E(...ai(s,r,o,1)).sub(a),a).multiply(new Ie().makeRotationZ(2*Math.PI*Rp(r,o))),c=n*(.75+.5*Rp(o,r)),h=new E;for(let u of Ap.filter(d=>e.hasAttribute(d))){let[d,f]=[lo(e,u),lo(i,u)];for(let p=0;p<d.count;p++)h.fromBufferAttribute(d,p),u==="position"?h.multiplyScalar(c).applyMatrix4(l):h.transformDirection(l),f.setXYZ(t*d.count+p,h.x,h.y,h.z)}}var Pp=["believed","estimated","actual","seen"],Ip={believed:6,estimated:12,actual:8,seen:14},JE={believed:i=>{i.arc(32,32,28,0,2*Math.PI),i.fill()},estimated:i=>{i.lineWidth=9,i.arc(32,32,25,0,2*Math.PI),i.stroke()},actual:i=>{i.lineWidth=15,i.moveTo(10,10),i.lineTo(54,54),i.moveTo(54,10),i.lineTo(10,54),i.stroke()},seen:i=>{i.lineWidth=7,i.rect(6,6,52,52),i.stroke()}},Su=class{group=new rt;points;shown=new Map;grains=null;constructor(){this.points=Object.fromEntries(Pp.map(e=>{let t=Zs([],ps(JE[e]),Ip[e],{nearer:.99,alphaTest:.15,renderOrder:2+Pp.indexOf(e)});return Et(t.material,e),this.group.add(t),[e,t]}))}paint(){this.grains?.paint()}show(e,t,{round:n,time:s},r,o){let a=Math.min(1.25,Math.max(.7,Cp*o/Ip.believed));for(let x of Pp)this.points[x].material.size=a*Ip[x];let{pose:l,shape:c}=n.plan.surface,h=!_n(n),u=h&&r.believed?n.particles.at(s):null,d=Qx(e.head?.task?.medium);d&&!this.grains&&(this.grains=new Mu(d),this.group.add(this.grains.group)),this.grains?.show(u,l,c,o),this.set("believed",this.grains?null:u,l,c,1);let f=e.endedAt(t)||t<n.start+n.firstContact?1:.45,p=e.outcomeAt(t);for(let x of["estimated","actual","seen"]){let{places:m,pose:g,shape:y}=p[x];this.set(x,m&&r[x]&&(h||x==="seen")?pt(m):null,g,y,f)}}set(e,t,n,s,r){let o=this.points[e];if(o.visible=t!==null&&t.length>0,!t||!o.visible||(jt(o,n),o.material.opacity=r,this.shown.get(e)===t))return;this.shown.set(e,t);let a=Array.from({length:t.length/2},(l,c)=>ai(s,t[2*c],t[2*c+1],zn));o.geometry.dispose(),o.geometry.setAttribute("position",new Pe(a.flat(),3))}};var QE=.11,eA=.0042,ey=.5,tA=new E(0,1,0),Tu=class{group=new rt;shaft;tip;constructor(e,t){let n=Et(new ln({depthTest:!1,transparent:!0,opacity:.95}),t);this.shaft=new ot(new es(e,e,1,12).translate(0,.5,0),n),this.tip=new ot(new Ns(3*e,6*e,16).translate(0,3*e,0),n),this.group.add(this.shaft,this.tip),this.group.renderOrder=this.shaft.renderOrder=this.tip.renderOrder=8}show(e,t,n){let s=t.length();this.group.visible=s>.001,this.group.visible&&(this.group.position.copy(e),this.group.quaternion.setFromUnitVectors(tA,t.clone().divideScalar(s)),this.shaft.scale.set(n,s,n),this.tip.position.y=s,this.tip.scale.setScalar(Math.min(n,s/9)))}},Eu=class{group=new rt;whole=new Tu(1,"force");pressed=new Tu(.5,"ink");constructor(){this.group.add(this.whole.group,this.pressed.group)}show(e,t,n,s){let{force:r,normal:o,round:a}=e,l=r?Math.hypot(...r):0;if(this.group.visible=s&&l>ey,!this.group.visible||!r)return;let c=QE/Math.max(10,a.normal.largest,l),h=eA*n.distanceTo(t);this.whole.show(t,new E(...r).multiplyScalar(c),h);let u=ds(a.plan.surface,t);this.pressed.show(t,u.multiplyScalar(Math.abs(o??0)>ey?(o??0)*c:0),h)}};function nA({mark:i,places:e},t){let[n,s]=[t.toFixed(1),(2*t).toFixed(1)],r={believed:"h0",estimated:`m-${n} 0a${n} ${n} 0 1 0 ${s} 0a${n} ${n} 0 1 0 -${s} 0`,actual:`m-${n} -${n}l${s} ${s}m0 -${s}l-${s} ${s}`,seen:`m-${n} -${n}h${s}v${s}h-${s}z`}[i],o="";for(let a=0;a+1<e.length;a+=2){let[l,c]=[1e3*e[a],-1e3*e[a+1]];Number.isFinite(l+c)&&(o+=`M${l.toFixed(1)} ${c.toFixed(1)}${r}`)}return ie("path",{d:o,class:`w-dots w-dots-${i}`,"stroke-width":i==="believed"?2.2*t:.7*t})}var Au=i=>Array.from({length:i.length/2},(e,t)=>`${t?"L":"M"}${(1e3*i[2*t]).toFixed(1)} ${(-1e3*i[2*t+1]).toFixed(1)}`).join(""),co=({plan:{surface:i}})=>i.shape?"the unrolled surface":"the surface from above",tr=(i,e,t={})=>_("figure",t,i,_("figcaption",{},e));function Hi(i,e,t,n=null){let s=i.plan.surface.rings.map(g=>pt(g)).filter(g=>g.length>=6),{goal:r}=i.plan,o=g=>Array.from({length:g.length/2},(y,S)=>new ee(g[2*S],g[2*S+1])),a=new Bs().setFromPoints(s.flatMap(o));if(r?.kind==="collected")for(let g of[-1,1])a.expandByPoint(new ee(...r.place).addScalar(g*r.radius));let l=g=>Math.max(...g.getSize(new ee)),c=a.clone().expandByScalar(s.length?.15*l(a):1/0);for(let{places:g}of e)for(let y of o(g))(!s.length||c.containsPoint(y))&&a.expandByPoint(y);a.max.x>a.min.x||a.set(new ee,new ee(1,1));let h=l(a),{min:u,max:d}=a.expandByScalar(.03*h),f=[u.x,-d.y,d.x-u.x,d.y-u.y].map(g=>(1e3*g).toFixed(1)),p=Math.max(1,...e.map(({places:g})=>g.length/2)),x=7*h*Math.min(1,Math.max(.6,Math.sqrt(160/p))),m=s.map(g=>`${Au(g)}Z`).join("");return ie("svg",{viewBox:f.join(" "),class:"w-picture",role:"img","aria-label":t},ie("path",{d:m,class:"w-ground","fill-rule":"evenodd","stroke-width":5*h}),n&&ie("clipPath",{id:n.id},ie("path",{d:m,"clip-rule":"evenodd"})),n?.map,r?.kind==="collected"&&ie("circle",{cx:1e3*r.place[0],cy:-1e3*r.place[1],r:1e3*r.radius,class:"w-goal","stroke-width":4*h}),...e.map(g=>nA(g,x)))}function hl(i){let e=gs(i),t=n=>{let s=e.filter(r=>r.degree===n);return s.length>0&&_("li",{"data-degree":n,style:`flex-grow:${s.length}`},_("span",{},Js[n]),or(s))};return _("div",{class:"w-scale"},_("ul",{"aria-label":`Scale in ${i.unit}`},...Object.keys(Js).map(t)),_("p",{},`${i.unit}; allowed: ${Cx(i)}${i.unit==="passes"?", counted in whole passes":`, target ${i.target} ${i.unit}`}`))}function iA(i,e){let t=el(i,e);return Object.keys(Js).map(n=>`${_e(tl(t,n),1)} ${Js[n]}`).join(", ")}function Ru(i,e){let t=gs(i),n=t.map(()=>""),s=pt(i.places),[r,o]=i.cell.map(h=>1e3*h),[a,l]=[Qa*r,Qa*o],c=e.length;for(let h=0;h<c;){let u=xs(t,i,e[h]),[d,f]=[1e3*s[2*h],-1e3*s[2*h+1]],p=1,x=m=>h+m<c&&Math.abs(-1e3*s[2*(h+m)+1]-f)<.1*o&&Math.abs(1e3*s[2*(h+m)]-d-m*r)<.1*r;for(;x(p)&&xs(t,i,e[h+p])===u;)p++;n[u]+=`M${(d-a).toFixed(1)} ${(f-l).toFixed(1)}H${(d+(p-1)*r+a).toFixed(1)}V${(f+l).toFixed(1)}H${(d-a).toFixed(1)}z`,h+=p}return t.map(({colour:h},u)=>ie("path",{d:n[u],style:`fill:var(--${h})`}))}function cl(i,e,t){let n=e.plan.treatment;if(!n||!t)return null;let s=hi(),r=`${i}: ${Mi(e)} per place; ${iA(n,t)} of ${t.length} places`,o=ie("g",{"clip-path":`url(#${s})`,class:"w-map"},...Ru(n,t));return tr(Hi(e,[],r,{id:s,map:o}),i)}function ty({rounds:i},e){let t=i[0],n=i.at(-1),s=i.findLast(h=>h.interpreted)??null,r=t.plan.surface.shape?", surface unrolled":"",o=n.plan.treatment;if(!o){let h=`This recording has no ${Mi(n)} per place.`;return[tr(Hi(n,[],h),h,{class:"w-wide"})]}let a=[cl("Before",t,t.treated?.first??null),cl(n.number===1?"Predicted":`Predicted for round ${n.number}`,n,n.treated?.last??null),e??(s&&cl(`Estimated after ${s.number} ${s.number===1?"round":"rounds"}: mean of the belief`,s,bn(s.plan.treatment,s.interpreted?.treated)))].filter(h=>h!==null),l=Mi(n),c=`${$n(l)} per place${r}`;return[_("p",{class:"w-wide w-quiet"},c),...a,hl(o)]}var Wi=5e-4,Lp=700,Dp=({plan:i},e)=>i.without?.find(t=>t.stroke===e)??null,Cu=i=>i.plan.predicted??i.growthAt(1/0)??NaN;function ny(i){let{phases:e,growth:t,strokes:n}=i.plan;if(!t.length)return[];let s=0,r=i.growthAt(0);return e.filter(({stroke:o})=>typeof o=="number"&&n[o]).map(({start:o,end:a,stroke:l})=>{let c=i.growthAt(a),h=Dp(i,l),u={stroke:l,gain:c-r,marginal:h&&Cu(i)-h.performance,way:sA(pt(n[l]??[])),start:o,time:a-s};return[s,r]=[a,c],u})}var sA=i=>{let e=0;for(let t=2;t+1<i.length;t+=2)e+=Math.hypot(i[t]-i[t-2],i[t+1]-i[t-1]);return e},iy=(i,e,t,n)=>i===0?`as many ${t} ${n}`:`${Math.abs(i)} ${i>0?"more":"fewer"} of ${e} ${t} ${n}`;function rA({plan:i,particles:e},t){let{goal:n,considered:s}=i,r=d=>d.length/2-(n?.kind==="collected"?Xa(d,n):0),o=e.first.length/2,a=r(pt(t.particles))-r(e.last),l=n?.kind==="collected"?"stay outside the goal area":"stay on the surface",c=i.lost??s?.find(({chosen:d})=>d)?.lost??null,h=t.lost-(c??NaN),u=c===null?`${_e(t.lost,1)} in all is lost`:Math.abs(h)<Wi?"nothing more is lost":`${_e(Math.abs(h),1)} ${h>0?"more":"less"} is lost`;return o<Lp?`${iy(a,o,"particles",l)}, and ${u}`:u}function oA({plan:{treatment:i},treated:e},t){let n=bn(i,t.treated);if(!i||!e||!n)return null;let s=gs(i),r=(o,a)=>o.filter(l=>s[xs(s,i,l)].degree===a).length;return["little","much"].map(o=>iy(r(n,o)-r(e.last,o),n.length,"places",`get ${Js[o]}`)).join(", ")}function sy(i,{stroke:e,way:t,time:n}){let s=Dp(i,e),r=`The stroke takes ${Fe(n,1)} s with the way to it, and ${Fe(t,2)} m in contact.`,o=i.plan.headings?.[e];if(!s)return[r,...o?[o]:[]];let a=Cu(i),l=Math.abs(a-s.performance)<Wi?`${_e(a,1)} as with it`:`${_e(s.performance,1)} instead of ${_e(a,1)}`,c=i.plan.treatment?oA(i,s):rA(i,s);return[`Predicted without stroke ${e+1}: ${l}${c?`; ${c}`:""}.`,r,...o?[o]:[]]}function aA(i,e,t,n){let{width:s,height:r}=i.viewBox.baseVal,o=Math.max(s,r)/100,a=e.plan.strokes.map(u=>pt(u)),l=a.filter((u,d)=>d!==t).map(Au).join(""),c=n?a[t]:null,h=[ie("path",{d:l,class:"w-line","stroke-width":.6*o})];if(c&&c.length>=4){let[u,d,f,p]=c.slice(-4),x=Math.atan2(d-p,f-u)*180/Math.PI,m=ie("path",{d:`M${3*o} 0L${-2*o} ${2.6*o}V${-2.6*o}z`,class:"w-line-tip",transform:`translate(${1e3*f} ${-1e3*p}) rotate(${x})`});h.push(...["w-line w-casing","w-line w-line-chosen"].map((g,y)=>ie("path",{d:Au(c),class:g,"stroke-width":(y?1.6:3)*o})),m)}i.insertBefore(ie("g",{},...h),i.querySelector(".w-dots"))}function ry(i,e){let t=Dp(i,e);if(!t)return[];let{treatment:n}=i.plan,s=(o,a)=>{let l=a?i.treated?.last??null:bn(n,t.treated),c=a?i.particles.last:pt(t.particles),h=`${o}, at the end: ${co(i)} with ${c.length/2} particles`,u=n?cl(o,i,l):tr(Hi(i,[{mark:"believed",places:c}],h),o),d=u?.querySelector("svg.w-picture");return d&&aA(d,i,e,a),u},r=[s(`Predicted with stroke ${e+1}`,!0),s("Predicted without it",!1)].filter(o=>o!==null);return[_("div",{class:"w-pair"},...r),...n?[hl(n)]:[]]}var oy=3,ay=i=>`${i>0?"+":""}${Fe(100*i,1)}`,Np=i=>i.length>1?`${i.slice(0,-1).join(", ")} and ${i.at(-1)}`:String(i[0]);function lA(i,e){let t=i.filter(r=>r.marginal!==null);if(t.length<2)return[];let n=t.reduce((r,o)=>o.marginal>r.marginal?o:r),s=t.filter(({marginal:r})=>r<Wi).map(({stroke:r})=>r+1);return[...n.marginal>=Wi?[`Stroke ${n.stroke+1} is predicted to matter most: without it, the plan reaches ${_e(e-n.marginal,1)} instead of ${_e(e,1)}.`]:[],...s.length?[`Without stroke ${Np(s).replace(" and "," or ")} alone, the plan is predicted to reach ${s.some(r=>t.find(o=>o.stroke+1===r).marginal<=-Wi)?"as much or more":"as much"}. It may still help if dirt or tool differ from the belief.`]:[]]}var cA=.05;function hA(i,e){let t=i.growthAt(0),n=e?.interpreted?.estimate;return!e||!n||t===null||Math.abs(t-n.mean)<cA?[]:[`The prediction begins at ${_e(t,1)}, ${t<n.mean?"below":"above"} the estimate of ${Gt(n)} after round ${e.number}. It starts from one random draw from the new belief; the estimate is the mean of all draws.${e.events.some(Ya)?` A push, a collision or hand guiding in round ${e.number} may have left open what was wiped there.`:""}`]}function uA({plan:{goal:i}},e,t){let n=e.filter(({gain:r},o)=>{let a=0;return r<=-Wi&&e.slice(o).some(l=>(a+=l.gain)>-Wi)});if(i?.kind!=="collected"||!n.length)return[];let s=Math.max(...n.map(({gain:r})=>-r));return[`${n.length>1?"Strokes":"Stroke"} ${Np(n.map(({stroke:r})=>r+1))} ${n.length>1?"are":"is"} predicted to take dirt out of the goal area, ${Fe(100*s,1)} points at most. The tool pushes all dirt in its way; later strokes bring it back, and the plan reaches ${_e(t,1)}.`]}function dA(i){let e=new Map;i.forEach((s,r)=>e.set(s,[...e.get(s)??[],r+1]));let n=[...e].sort(([,s],[,r])=>r.length-s.length).slice(0,oy).map(([s,r])=>`${e.size===1&&i.length>1?"All strokes":r.length>1?`Strokes ${Np(r)}`:`Stroke ${r[0]}`}: ${s}`);return e.size>oy?[...n,"Choose another stroke in the table to see how the tool is turned in it."]:n}var ly=(i,e)=>_("div",{class:"w-choice",tabindex:0,role:"group","aria-label":i},e),Pu=class{constructor(e,t){this.seek=e;this.choose=t}seek;choose;element=_("div");round=null;stroke=null;rejected=null;kept=null;show(e,t,n){if(e&&e===this.round)return;(this.stroke!==null||this.rejected)&&this.choose(null),[this.round,this.stroke,this.rejected,this.kept]=[e,null,null,null];let s=e?ny(e):[],{without:r,predicted:o,another:a=r?.length?null:void 0,...l}=e?.plan??{},[c,h,u]=[l.why??[],l.considered??[],l.headings??[]],d=e?Cu(e):NaN,f=rr(e?[...hA(e,t),...lA(s,d),...uA(e,s,d)]:[]);e&&a&&f.append(_("li",{},...this.describeAnother(e,a))),f.append(...rr([...a===null&&(o??0)<1-Wi?["A repetition of a stroke at the end is predicted to gain nothing."]:[],...dA(u),...c]).children),this.element.replaceChildren(f.childElementCount?f:_("p",{class:"w-quiet"},n),...h.length?[this.makeCandidates(h)]:[],...e&&s.length?[this.makeStrokes(e,s)]:[])}publish(){this.round&&this.choose({round:this.round,stroke:this.stroke,rejected:this.rejected})}preview(e){let t=s=>()=>{this.rejected!==s&&(this.rejected=s,this.publish())},n=()=>t(this.kept)();return e?{pointerenter:t(e),pointerleave:n,focusin:t(e),focusout:n}:{}}makeKeeper(e,t){return _("button",{type:"button",class:"w-link","aria-pressed":"false",title:"Show its strokes in the scene",click:({currentTarget:n})=>{this.kept=this.kept===t?null:t;for(let s of this.element.querySelectorAll(".w-link[aria-pressed]"))s.setAttribute("aria-pressed",String(s===n&&this.kept!==null));this.rejected=this.kept,this.publish()}},e)}describeAnother({plan:{strokes:e}},{gain:t,line:n,way:s}){let r=e.findIndex(l=>String(l)===String(n)),o={name:r<0?"One more stroke":`Repetition of stroke ${r+1}`,lines:[n]},a=r<0?"One more stroke":`Stroke ${r+1} once more at the end`;return[_("span",this.preview(o),this.makeKeeper(a,o)),` is predicted to gain ${Fe(100*t,1)} points with ${Fe(s,2)} m in contact.`]}makeCandidates(e){let t=["Strategy","Score","Share","Lost","Contact","Time"],n=[...e].sort((s,r)=>(r.score??-1/0)-(s.score??-1/0)).map(s=>{let{strategy:r,chosen:o,score:a,predicted:l,lost:c,strokes:h,in_contact:u,duration:d,error:f,lines:p}=s,x=!o&&p?.length?{name:`Rejected plan: ${r}, ${p.length} strokes`,lines:p}:null,m=[sn(a,g=>Fe(g,2)),sn(l,_e),sn(c,_e),sn(u,g=>`${Fe(g,2)} m`),sn(d,g=>`${Fe(g,0)} s`)];return _("tr",{"data-chosen":o,title:typeof h=="number"&&`${h} strokes`,...this.preview(x)},_("th",{scope:"row"},o&&"\u2713 ",x?this.makeKeeper(r,x):r,o&&_("span",{class:"w-hidden"}," (chosen)")),...f?[_("td",{class:"w-none-found",colspan:t.length-1},`no plan: ${f}`)]:m.map(g=>_("td",{},g)))});return ly("Candidate plans",Jn(t,n,"Share: predicted performance. Lost: predicted share of lost dirt. Score: predicted share of the dirt that reaches the goal, minus three times the lost share, minus the share at risk in heaps near an edge, minus costs of remaining dirt by its distance, of path length and time."))}makeStrokes(e,t){let n=t.some(({marginal:l})=>l!==null),s=["Stroke","In turn",...n?["Marginal"]:[],"Contact","Time"],r=_("td",{colspan:s.length,class:"w-stroke"}),o=_("tr",{},r),a=t.map(l=>{let{stroke:c,gain:h,marginal:u,way:d,start:f,time:p}=l,x=_("button",{type:"button",class:"w-link","aria-expanded":"false","aria-label":`Stroke ${c+1}`,click:()=>{let g=this.stroke===c;this.stroke=g?null:c;for(let y of a)y.querySelector("button").setAttribute("aria-expanded",String(y===m&&!g));o.remove(),g||(r.replaceChildren(...ry(e,c),rr(sy(e,l))),m.after(o),o.scrollIntoView({block:"nearest"}),this.seek(e.start+f)),this.publish()}},String(c+1)),m=Ml(x,[ay(h),...n?[sn(u,ay)]:[],`${Fe(d,2)} m`,`${Fe(p,1)} s`]);return m});return ly("Strokes",Jn(s,a,`Predicted gain of each stroke in performance, in points. In turn: rise while it is wiped; a stroke without a rise may prepare a later one.${n?" Marginal: the whole plan minus the plan without it.":""} Contact: its way in contact. Time: with the way to it.`))}};var ul=(i,e,...t)=>_("details",{class:"w-section",open:e},_("summary",{},_("h2",{},i)),...t),cy=["performance unknown","undecided by touch","cannot be told","unknowable by touch"],fA="wipe again",Du=({met:i,verdict:e,badge:t})=>({state:i?"met":cy.includes(t??"")||cy.includes(e??"")?"unknown":"unmet",text:t??(e===fA?"not met":e)??(i?"goal met":"stopped")});function Nu({rounds:i,ended:e,live:t}){let n=s=>i.length>0&&i.every(({plan:r})=>r.kind===s);return t?{state:"live",text:"running"}:n("planned")?{state:"planned",text:"planned only"}:n("logged")?{state:"logged",text:"from the log"}:e?Du(e):{state:"broken",text:"ended early"}}function uo({rounds:i,ended:e},{number:t,plan:{kind:n},interpreted:s,over:r}){return n==="planned"?"planned only":n==="logged"?"from the log":s?(i.findLast(a=>a.interpreted)?.number===t?e?.badge:null)??s.verdict:r?"no result":"running"}function Op(i,{round:e,time:t,phase:n}){if(t>=e.length-1e-6&&e.interpreted)return uo(i,e);let s=e.plan.phases[n],r=typeof s?.stroke=="number"?` \xB7 stroke ${s.stroke+1} of ${e.plan.strokes.length}`:"";return`${s?Ts(s.name):"starting"}${r}`}var ho=(i,e)=>[_("dt",{},i),_("dd",{},e)],hy="beside the surface";function dl({height:i,tool:e,contact:t,round:{plan:n}}){return i===null?nn:e&&t!=="contact"&&!vx(n.surface,e)?hy:`${Fe(1e3*i,1)} mm`}var Iu="The episode was kept without a recording: the page shows its telemetry and its events.",kp=300,Lu=class{constructor(e,t,n){this.recording=e;this.clock=t;this.why=new Pu(l=>t.seek(l),n);let{contact:s,force:r,height:o,performance:a}=this.live;this.element=_("aside",{class:"w-words","aria-label":"Details of the run",tabindex:0},_("div",{class:"w-now"},this.headline,this.below,_("dl",{class:"w-values"},_("div",{},_("dt",{},"Contact"),s),_("div",{},_("dt",{},"Force"),r),_("div",{},_("dt",{title:"Height of the tool over the surface as believed"},"Tool height"),o),_("div",{},this.performanceName,a))),this.complaint,ul("Why this plan",!0,this.why.element),ul("Result",!0,this.after),ul("Events",!0,this.events),ul("Numbers",!0,this.numbers),ul("Log",!1,this.logCount,this.log))}recording;clock;element;headline=_("p",{class:"w-headline"});below=_("p",{class:"w-quiet"});live={contact:_("dd"),force:_("dd"),height:_("dd"),performance:_("dd")};performanceName=_("dt",{},"Predicted");why;after=_("div");events=_("div");numbers=_("div");log=_("ol",{class:"w-log"});logCount=_("span",{class:"w-quiet"});complaint=_("p",{class:"w-complaint",hidden:!0});shownEvents=[];show(){let{recording:e,clock:t}=this,n=e.at(t.time);this.showNow(n);let s=n?.round;Mn(this.after,[s?.number,s?.start,e.rounds.length,!!s?.interpreted,!!s?.truth,e.live,e.ended?.badge])&&this.showRound(s??null);let{stages:r,happenings:o,head:a,ended:l,broken:c,unknown:h}=e;Mn(this.events,[r.length,o.length,!!a,!!l,c,h])&&this.showRun();for(let{element:u,start:d,end:f}of this.shownEvents)u.toggleAttribute("data-now",t.time>=d-.05&&t.time<=f+.05)}showNow(e){let{recording:t,clock:n}=this,s=t.live&&(n.following||!e)?t.stages.at(-1):void 0;if(!e){Ve(this.headline,s?.words??(t.live?t.head?"No round has begun.":"The recording is empty so far.":"The recording has no rounds.")),Ve(this.below,"");for(let f of Object.values(this.live))Ve(f,nn);delete this.live.height.dataset.words;return}let{round:r,time:o,normal:a,performance:l,contact:c}=e,h=t.rounds.length;Ve(this.headline,$n(s&&s.stage!=="executing"?s.words:Op(t,e))),Ve(this.below,`Round ${r.number} of ${h}${r.plan.kind==="planned"?" (planned only)":""} \xB7 ${Je(o)} of ${Je(r.length)}`),Ve(this.live.contact,c==="contact"?"yes":c==="pushed"?"pushed":"none"),Ve(this.live.force,sn(a,f=>`${Fe(f,1)} N`));let u=dl(e);Ve(this.live.height,u),this.live.height.toggleAttribute("data-words",u===hy);let d=t.resultAt(n.time)?.interpreted;Ve(this.performanceName,d?"Estimated":"Predicted"),Ve(this.live.performance,d?_e(d.estimate.mean):sn(l,_e))}showRound(e){let{rounds:t}=this.recording;if(this.why.show(e,t[t.indexOf(e)-1]??null,e?e.plan.kind==="logged"?Iu:"The recording states no reasons for this plan.":"No plan yet."),!e?.interpreted){let r=e?e.plan.kind==="planned"?"This plan was not executed.":e.plan.kind==="logged"?Iu:this.recording.live?"The round is not finished.":"The round has no result because the run ended early.":"No round yet.";this.after.replaceChildren(_("p",{class:"w-quiet"},r));return}let{interpreted:n,truth:s}=e;this.after.replaceChildren(_("p",{class:"w-quiet"},`Round ${e.number}, known from ${Je(e.end)} on.`),_("p",{},_("strong",{},uo(this.recording,e)),n.ending?` \xB7 ${n.ending}`:""),_("dl",{class:"w-facts"},...ho("Predicted",sn(e.plan.predicted,_e)),...ho("Estimated",Gt(n.estimate)),...ho("From touch only",Gt(n.by_touch)),...typeof s?.performance=="number"?ho("True",_e(s.performance)):[],...n.found?ho("Surface","not at its believed pose"):[]),rr(n.words))}showRun(){let{recording:e,clock:t}=this,n=e.happenings.slice(0,kp);this.shownEvents=[],this.events.replaceChildren(n.length?_("ul",{class:"w-events"},...n.map(({start:o,end:a,round:l,kind:c,words:h,source:u})=>{let d=_("button",{type:"button","data-source":u,click:()=>t.seek(o)},_("span",{class:"w-when"},Je(o)),_("span",{},_("strong",{},c),` in round ${l}: ${h}`));return this.shownEvents.push({element:d,start:o,end:a}),_("li",{},d)}),e.happenings.length>kp&&_("li",{class:"w-quiet"},`and ${e.happenings.length-kp} more`)):_("p",{class:"w-quiet"},"None.")),this.showNumbers(),this.log.replaceChildren(...e.stages.slice(-500).map(({round:o,stage:a,words:l})=>_("li",{},_("span",{class:"w-when"},`${o} ${a}`),` ${l}`))),Ve(this.logCount,e.stages.length>500?`The list shows the last 500 of ${e.stages.length} entries.`:"");let{broken:s,unknown:r}=e;this.complaint.hidden=!s&&!r,Ve(this.complaint,[s?`${s} ${s===1?"line":"lines"} of this recording could not be read.`:"",r?`${r} ${r===1?"piece":"pieces"} of unknown kind ${r===1?"was":"were"} skipped.`:""].join(" ").trim())}showNumbers(){let{head:e,ended:t,rounds:n}=this.recording;if(!e)return;let{task:s,robot:r}=e,o=[...s?[["Task",`${s.action} ${s.medium} with ${s.tool} on ${s.surface}`],["Strategy",s.strategy],["Target",_e(s.target)],["Seed",String(s.seed)]]:[],...r?[["Robot",`${r.name}, ${r.variables.length} variables`]]:[],["Program",e.program],...e.begun?[["Started",e.begun]]:[],...t?.episode?[["Episode",t.episode]]:[]],a=new Set(o.map(([c])=>c)),l=new Map([[null,o]]);for(let c of t?.facts??[]){if(a.has(c[0]))continue;let h=n.length>1?pA(c,n[0].number):null;l.set(h,[...l.get(h)??[],[c[0],c[1]]])}this.numbers.replaceChildren(...[...l].flatMap(([c,h])=>[...l.size>1?[_("h3",{},c===null?`Whole run, ${n.length} rounds`:`Round ${c}`)]:[],_("dl",{class:"w-facts"},...h.flatMap(([u,d])=>ho(String(u),String(d))))]))}},pA=([i,e,t],n)=>t!==void 0?t:/ in \d+ rounds$/.test(e)||/^(Target performance|Tool held|Maximum path error|Minimum clearance|Distance in contact|Distance in total|Goal|Steps|Links|Joints held at their ready positions)$/.test(i)?null:n;function uy(i,e,t){let{step:n,times:s}=lu(e.from,e.to,Math.max(2,e.span/76)),r=n<.1?2:n<1?1:0;for(let o of s){let a=e.x(o);hn(i,a,t.top+t.height,a,e.height,"grid"),An(i,Je(o,r),Math.min(Math.max(a,e.left+10),e.width-16),t.top+t.height/2,{align:"center"})}}function ku(i,e,t,n=1){if(t<i.from||e>i.to)return null;let s=Math.max(i.x(e),i.left);return[s,Math.max(Math.min(i.x(t),i.width-i.right),s+n)]}function dy(i,e,t,n){for(let s of n.rounds){let r=ku(e,s.start,s.end);if(!r)continue;let[o,a]=r;i.fillStyle=De("round"),i.beginPath(),i.roundRect(o+.5,t.top,Math.max(1,a-o-1),t.height,4),i.fill(),An(i,`${s.number} \xB7 ${uo(n,s)}`,o+7,t.top+t.height/2+.5,{weight:600,name:"ink",room:a-o-12}),s.start>e.from&&hn(i,e.x(s.start),t.top,e.x(s.start),e.height,"rule")}}function fy(i,e,t,n){for(let{start:s,plan:r,length:o}of n.rounds)for(let a of r.phases){let l=ku(e,s+a.start,s+Math.min(a.end,Math.max(o,a.start)));if(!l)continue;let[c,h]=l;li(i,a.contact?"wiping":"lane",c,t.top,Math.max(1,h-c-1),t.height);let u=a.stroke===null?"":String(a.stroke+1),d=u?`${u} ${a.name}`:Ts(a.name),[f,p]=[t.top+t.height/2+.5,{size:10.5,name:a.contact?"ink":"quiet"}];il(i,p),!u||i.measureText(d).width<=h-c-7?An(i,d,c+4,f,{...p,room:h-c-7}):i.measureText(u).width<=h-c-3&&An(i,u,(c+h)/2,f,{...p,align:"center"})}}function py(i,e,{top:t,height:n},s){li(i,"lane",e.left,t,e.span,n);for(let{start:r,contacts:o}of s.rounds)for(let a of["contact","pushed"])for(let[l,c]of o[a]){let h=ku(e,r+l,r+c);if(!h)continue;let u=[h[0],t,h[1]-h[0],n];li(i,a,...u),a==="pushed"&&sl(i,u,()=>{for(let d=h[0]-n;d<h[1];d+=5)hn(i,d,t+n,d+n,t,"paper",1.4)})}}var fo={collision:"M-6 5.5H6L0 -6z",hand:"M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0",event:"M-4 -4h8v8h-8z"},Up=({source:i,kind:e})=>i==="push"?"actual":e===Xs?"collision":e==="hand guiding"?"hand":"event";function my(i,e,t,n){li(i,"lane",e.left,t.top,e.span,t.height);let s=t.top+t.height/2;for(let r of n.happenings){let o=ku(e,r.start,r.end,3);if(!o)continue;let[a,l]=o,c=Up(r);if(i.fillStyle=i.strokeStyle=De(c),c==="actual"){i.lineWidth=1.5,i.setLineDash(nl),i.strokeRect(a+.5,t.top+1.5,Math.max(2,l-a-1),t.height-3),i.setLineDash([]);continue}i.fillRect(a,s-2.5,l-a,5),mA(i,fo[c],a,s)}}function mA(i,e,t,n){let s=new Path2D(e);i.save(),i.translate(t,n),i.fill(s),i.strokeStyle=De("paper"),i.lineWidth=1,i.stroke(s),i.restore()}var gA=13,xA=.006,gy={least:.04,most:.16},xy=.02,yA=1,Fp=["collision","hand","actual"];function vA({t:i,force:e,count:t},n,s){let[r,o]=[-1,yA];for(let a=Math.max(0,ui(i,n));a<t&&i[a]<=s;a++){let l=Math.hypot(e[3*a],e[3*a+1],e[3*a+2]);l>o&&([r,o]=[a,l])}return r}function bA({tool:i,force:e},t,n){let s=new E().fromArray(e,3*t),r=Math.min(gy.most,Math.max(gy.least,xA*s.length())),o=new E().fromArray(i,7*t),a=s.normalize(),l=o.clone().addScaledVector(a,r),c=new E(Math.abs(a.x)<.7?1:0,Math.abs(a.x)<.7?0:1,0).cross(a).normalize(),u=[c,c.clone().negate(),a.clone().cross(c),c.clone().cross(a)].flatMap(f=>[...l.toArray(),...l.clone().addScaledVector(a,-xy).addScaledVector(f,.5*xy).toArray()]),d=[...o.toArray(),...l.toArray()];return[...n?su(d,fp):d,...u]}var Ou=class{group=new rt;points=Zs([],Qh(),gA,{nearer:.985,vertexColors:!0});arrows=new io(4,[]);key="";starts=[];pushes=[];constructor(){this.group.add(this.points,this.arrows.line)}show(e,t,n,s,r){let o=`${t.start} ${t.number} ${e.happenings.length} ${t.count>0} ${r}`;o!==this.key&&(this.key=o,this.arrows.paint(Fp.map(l=>new Ae(De(l)))),this.build(e,t));let a=this.starts.filter(l=>l<=n).length;this.points.visible=s&&a>0,this.points.geometry.setDrawRange(0,a),this.arrows.show(s?this.pushes.filter(l=>l<=n).length:0)}build(e,t){let[n,s]=[[],[]];[this.starts,this.pushes]=[[],[]],this.arrows.clear();for(let r of e.happenings){let[o,a]=[r.start-t.start,r.end-t.start];if(o<0||o>t.length||r.source==="push"&&e.happenings.some(f=>f.source==="event"&&f.start<r.end&&f.end>r.start))continue;let c=t.toolAt((o+a)/2);if(!c)continue;let h=Up(r);this.starts.push(o),n.push(c[0],c[1],c[2]),s.push(...new Ae(De(h)).toArray());let u=Fp.includes(h)?vA(t,o,a):-1;if(u<0)continue;let d=bA(t,u,r.source==="push");for(let f=0;f<d.length;f+=6)this.arrows.push(d.slice(f,f+6),Fp.indexOf(h)),this.pushes.push(o)}this.points.geometry.dispose(),this.points.geometry.setAttribute("position",new Pe(n,3)).setAttribute("color",new Pe(s,3))}};var _A=26e5,yy=[.75,.6,.5],wA=1.5,MA=700,SA=70,TA=6,Uu=class{software=er();renderer;width=0;height=0;ratio=0;coarse=0;moved={last:0,took:0,frames:0};rest;constructor(e){this.renderer=new Nh({canvas:e,stencil:!0,antialias:!this.software,alpha:!this.software,powerPreference:"high-performance"}),this.renderer.debug.checkShaderErrors=!1,Object.assign(this.renderer.shadowMap,{enabled:!0,type:zs,autoUpdate:!this.software})}size(e,t){[this.width,this.height,this.ratio]=[e,t,0]}paint(){this.software&&this.renderer.setClearColor(new Ae(De("scene")))}draw(e,t,n,s){clearTimeout(this.rest),this.software&&!n&&this.keepUp(performance.now()),this.sharpen(n),this.renderer.shadowMap.needsUpdate=n,this.renderer.render(e,t),n||(this.rest=setTimeout(s,MA))}destroy(){clearTimeout(this.rest),this.renderer.dispose(),this.renderer.forceContextLoss()}keepUp(e){let{moved:t}=this,n=e-t.last;t.last=e,!(n>500)&&(t.took+=n,!(++t.frames<TA)&&(t.took/t.frames>SA&&this.coarse+1<yy.length&&this.coarse++,t.took=t.frames=0))}sharpen(e){let t=Math.sqrt(_A/(this.width*this.height)),n=Math.min(devicePixelRatio||1,2,Math.max(1,t)),s=this.software?e?Math.min(Math.max(wA,n),t):yy[this.coarse]:n;s!==this.ratio&&(this.ratio=s,this.renderer.setPixelRatio(s),this.renderer.setSize(this.width,this.height,!1))}};var vy={low:.8,high:1.25},EA=.006,AA=.12,RA=2.2,CA=.15,PA=.5,po=[{colour:"force-little",label:"below 80\u202F%"},{colour:"force-target",label:"on target"},{colour:"force-much",label:"above 125\u202F%"}],IA=po.length;function LA(i,e){return e===null?IA:i<vy.low*e?0:i<=vy.high*e?1:2}var Fu=class{constructor(e,t){this.most=e;this.target=t;let{geometry:n}=this.mesh;this.corners=new yt(new Float32Array(12*e),3),this.colours=new yt(new Float32Array(16*e),4),n.setAttribute("position",this.corners),n.setAttribute("color",this.colours),n.setIndex(Array.from({length:6*e},(s,r)=>4*Math.floor(r/6)+[0,1,2,2,1,3][r%6])),this.mesh.frustumCulled=!1,this.mesh.renderOrder=1,this.paint()}most;target;mesh=new ot(new Ze,new ln({vertexColors:!0,side:yn,transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-8,polygonOffsetUnits:-8}));times=[];degrees=[];corners;colours;end=null;peak=0;selected=null;palette=[];clear(){this.breakOff(),this.times.length=this.degrees.length=0}breakOff(){this.end=null,this.peak=0}push(e,t,n,s,{step:r,reference:o}){this.peak=Math.max(this.peak,s);let a=EA*Math.min(RA,Math.max(AA,this.peak/o)),l=this.end??={place:t,half:a,way:null,corners:null};if(t.distanceTo(l.place)<r||this.times.length===this.most)return;let c=t.clone().sub(l.place).normalize(),h=n.clone().cross(c).normalize(),u=(x,m)=>[x.clone().addScaledVector(h,m),x.clone().addScaledVector(h,-m)],d=l.corners&&l.way.dot(c)>PA?l.corners:u(l.place,l.half),f=u(t,a),p=this.times.length;[...d,...f].forEach(({x,y:m,z:g},y)=>this.corners.setXYZ(4*p+y,x,m,g)),this.corners.needsUpdate=!0,this.times.push(e),this.degrees.push(LA(this.peak,this.target)),this.colour(p),this.end={place:t,half:a,way:c,corners:f},this.peak=0}show(e,t){let n=Math.max(e,this.selected?.[1]??-1/0),s=ui(this.times,n)+1;this.mesh.visible=t&&s>0,this.mesh.geometry.setDrawRange(0,6*s)}select(e){this.selected=e;for(let t=0;t<this.times.length;t++)this.colour(t)}paint(){this.palette=[...po.map(e=>e.colour),"contact"].map(e=>new Ae(De(e)));for(let e=0;e<this.times.length;e++)this.colour(e)}colour(e){let{r:t,g:n,b:s}=this.palette[this.degrees[e]],[r,o]=this.selected??[-1/0,1/0],a=this.times[e]>=r&&this.times[e]<=o?1:CA;for(let l=0;l<4;l++)this.colours.setXYZW(4*e+l,t,n,s,a);this.colours.needsUpdate=!0}};var by=.0015,_y=4e3,DA=5,wy={none:0,contact:1,pushed:2},My=()=>["lifted","contact","pushed"].map(i=>new Ae(De(i))),Bu=class{constructor(e){this.round=e;this.ribbon=new Fu(_y,e.target),this.object.add(this.lines.line,this.ribbon.mesh)}round;object=new rt;ribbon;lines=new io(3,My());times=[];taken=0;step=by;last=null;kind=wy.none;basis="";show(e,t){this.grow();let n=ui(this.times,e)+1;this.lines.show(t.path?n:0),this.ribbon.show(e,t.ribbon)}paint(){this.lines.paint(My()),this.ribbon.paint()}between(e,t){let n=[],{round:s}=this,r=Math.max(1,Math.floor(s.count/2e4)),o=null;for(let a=Math.max(0,s.place(e)[0]);a<s.count&&s.t[a]<=t;a+=r){let{place:l}=this.place(a);o&&n.push(...o.toArray(),...l.toArray()),o=l}return n}nearest(e,t,n,s,r,o){let[a,l]=[r**2,null];for(let c=0;c<this.times.length&&this.times[c]<=s;c++){if(o&&!this.round.isPressed(this.times[c]))continue;let h=e(this.lines.end(c)),u=(h.x-t)**2+(h.y-n)**2;u<=a&&([a,l]=[u,this.times[c]])}return l}place(e){let t=new E().fromArray(this.round.tool,7*e),n=ds(this.round.plan.surface,t);return{place:t.addScaledVector(n,1.5*zn),normal:n}}press(e,{place:t,normal:n}){let{round:s,step:r}=this,o=s.height.data[e],a=Number.isFinite(o)?t.clone().addScaledVector(n,-o):t,l=s.target??Math.max(DA,s.normal.largest);this.ribbon.push(s.t[e],a,n,s.normal.data[e],{step:r,reference:l})}restart(){this.taken=0,this.last=null,this.lines.clear(),this.times.length=0,this.ribbon.clear()}grow(){let{round:e}=this;this.basis!==e.basis&&this.restart(),this.basis=e.basis;let t=e.over||e.interpreted?e.count:e.count-zh+1;for(;this.taken<t;){let n=this.taken++,s=e.t[n],r=this.place(n),{place:o}=r;if(!Number.isFinite(o.x+o.y+o.z))continue;e.isPressed(s)&&Number.isFinite(e.normal.data[n])?this.press(n,r):this.ribbon.breakOff();let a=wy[e.contactAt(s)];this.last&&this.last.distanceToSquared(o)<this.step**2&&(a===this.kind||this.step>2*by)||(this.last&&(this.lines.push([...this.last.toArray(),...o.toArray()],a),this.times.push(s)),this.last=o,this.kind=a,this.lines.count>_y&&(this.step*=2,this.restart()))}}};var mo=8,Sy=i=>Math.min(mo-1,Math.max(0,Math.floor(i*mo))),Ty=()=>_("div",{class:"w-scale w-reach"},_("b",{},"Base poses"),or(Array.from({length:mo},(i,e)=>({colour:`band-${e+1}`,label:`\u2265 ${_e(e/mo,e%2)}`})),"Scale in percent"),_("p",{},"share of the path that is in reach; grey: chosen without being rated; the tip points where the base faces; ringed: chosen, in order"));var Gu=class{group=new rt;lines=["paper","rejected"].map((e,t)=>Bn([],Et(new $t({linewidth:4-2*t,polygonOffset:!0,polygonOffsetFactor:-7-t,polygonOffsetUnits:-7-t}),e)));shown=null;constructor(){this.group.add(...this.lines)}show(e,{pose:t,shape:n}){if(this.group.visible=e!==null,!e||e===this.shown)return;this.shown=e,jt(this.group,t);let s=e.flatMap(r=>ms(fs(n,ro(r,2.5*zn),!1),!1));for(let r of this.lines)Ja(r,s)}},zu=.03,Ey=.006,Vu=[.003,.004,.005],NA=.045;function Ay(i){let e=new ki().absarc(0,0,i,Math.PI/4,7*Math.PI/4,!1);return new Fs(e.lineTo(1.9*i,0),10)}var kA=i=>ps(e=>{e.arc(32,32,30,0,2*Math.PI),e.fillStyle=De("ink"),e.fill(),e.font="bold 38px system-ui, sans-serif",e.textAlign="center",e.textBaseline="middle",e.fillStyle=De("paper"),e.fillText(String(i),32,35)}),Hu=class{group=new rt;shown=null;theme="";get places(){return this.group.visible?this.shown?.poses.map(([e,t])=>new E(e,t,0))??[]:[]}show(e,t){if(this.group.visible=e!==void 0,!e||this.shown===e&&this.theme===t)return;[this.shown,this.theme]=[e,t],Ka(this.group);let{poses:n,chosen:s}=e,r=Array.from({length:mo},(u,d)=>new Ae(De(`band-${d+1}`))),o=new Ae(De("quiet")),a=this.addMarks(Ay(zu+Ey),n.length),l=this.addMarks(Ay(zu),n.length),c=s.map(u=>n[u]).filter(u=>u!==void 0),h=this.addMarks(new Us(2*zu,2*zu+2*Ey,32),c.length);h.material.depthTest=!1,h.renderOrder=8,n.forEach((u,d)=>{a.setMatrixAt(d,Bp(u,Vu[0])),a.setColorAt(d,o),l.setMatrixAt(d,Bp(u,Vu[1])),l.setColorAt(d,u[3]===null?o:r[Sy(u[3])])}),c.forEach((u,d)=>{h.setMatrixAt(d,Bp(u,Vu[2])),h.setColorAt(d,new Ae(De("ink")));let f=new ta(new Ur({map:kA(d+1),sizeAttenuation:!1,depthTest:!1}));f.position.set(u[0],u[1],Vu[2]),f.center.set(.5,-.6),f.scale.setScalar(NA),f.renderOrder=9,this.group.add(f)})}addMarks(e,t){let n=new ia(e,Ys(new ln({toneMapped:!1,transparent:!0}),.998),t);return n.frustumCulled=!1,this.group.add(n),n}},OA=new E(0,0,1),Bp=([i,e,t],n)=>new Ie().compose(new E(i,e,n),new Rt().setFromAxisAngle(OA,t),new E(1,1,1));var fl=new E;function jn(i,e,t,n,s,r){let o=2*Math.PI*s/4,a=Math.max(r-2*s,0),l=Math.PI/4;fl.copy(e),fl[n]=0,fl.normalize();let c=.5*o/(o+a),h=1-fl.angleTo(i)/l;return Math.sign(fl[t])===1?h*c:a/(o+a)+c+c*(1-h)}var Wu=class i extends kn{constructor(e=1,t=1,n=1,s=2,r=.1){let o=s*2+1;if(r=Math.min(e/2,t/2,n/2,r),super(1,1,1,o,o,o),this.type="RoundedBoxGeometry",this.parameters={width:e,height:t,depth:n,segments:s,radius:r},o===1)return;let a=this.toNonIndexed();this.index=null,this.attributes.position=a.attributes.position,this.attributes.normal=a.attributes.normal,this.attributes.uv=a.attributes.uv;let l=new E,c=new E,h=new E(e,t,n).divideScalar(2).subScalar(r),u=this.attributes.position.array,d=this.attributes.normal.array,f=this.attributes.uv.array,p=u.length/6,x=new E,m=.5/o;for(let g=0,y=0;g<u.length;g+=3,y+=2)switch(l.fromArray(u,g),c.copy(l),c.x-=Math.sign(c.x)*m,c.y-=Math.sign(c.y)*m,c.z-=Math.sign(c.z)*m,c.normalize(),u[g+0]=h.x*Math.sign(l.x)+c.x*r,u[g+1]=h.y*Math.sign(l.y)+c.y*r,u[g+2]=h.z*Math.sign(l.z)+c.z*r,d[g+0]=c.x,d[g+1]=c.y,d[g+2]=c.z,Math.floor(g/p)){case 0:x.set(1,0,0),f[y+0]=jn(x,c,"z","y",r,n),f[y+1]=1-jn(x,c,"y","z",r,t);break;case 1:x.set(-1,0,0),f[y+0]=1-jn(x,c,"z","y",r,n),f[y+1]=1-jn(x,c,"y","z",r,t);break;case 2:x.set(0,1,0),f[y+0]=1-jn(x,c,"x","z",r,e),f[y+1]=jn(x,c,"z","x",r,n);break;case 3:x.set(0,-1,0),f[y+0]=1-jn(x,c,"x","z",r,e),f[y+1]=1-jn(x,c,"z","x",r,n);break;case 4:x.set(0,0,1),f[y+0]=1-jn(x,c,"x","y",r,e),f[y+1]=1-jn(x,c,"y","x",r,t);break;case 5:x.set(0,0,-1),f[y+0]=jn(x,c,"x","y",r,e),f[y+1]=1-jn(x,c,"y","x",r,t);break}}static fromJSON(e){return new i(e.width,e.height,e.depth,e.segments,e.radius)}};var go=class{worldFromLink;joints;motion=new Ie;constructor(e){this.joints=e.map(t=>({...t,parentFromJoint:At(t.pose),direction:new E(...t.axis)})),this.worldFromLink=Array.from({length:e.length+1},()=>new Ie)}update(e,t){At(e,this.worldFromLink[0]),this.joints.forEach(({parent:n,parentFromJoint:s,direction:r,kind:o,offset:a,terms:l},c)=>{let h=a;for(let[d,f]of l)h+=f*(t[d]||0);let u=this.worldFromLink[c+1].multiplyMatrices(this.worldFromLink[n],s);o==="revolute"?u.multiply(this.motion.makeRotationAxis(r,h)):o==="prismatic"&&u.multiply(this.motion.makeTranslation(r.x*h,r.y*h,r.z*h))})}};var UA=.56,Ry=.82,Ly=.005,Dy=.03,Cy=.9;function Ny({robot:i,tool:e},t){if(!i)return[];let n=BA(i),s=n.find(r=>r.rods.length>0&&Py(e,t,i,n,r));return i.links.map(({name:r,arm:o,shapes:a},l)=>{let c={casing:[],joint:[],ring:[],handle:[]},h=(m,g,y)=>{if(!g.hasAttribute("position"))return;g.deleteAttribute("uv");let S=g.index?g:ux(g);c[m].push(y?S.applyMatrix4(y):S)},u=n[l],[d]=u.rods,f=Xu(u,u.before?[u.before,...u.after]:u.after),p=Py(e,t,i,n,u),x=a.length===1&&!u.after.length&&(p!==null||FA(u,s));if(d&&!o&&/head/i.test(r))qA(h,d,u.worldFromLink);else if(d&&x)QA(h,d,p,/left/i.test(r));else if(!u.trunk||!XA(h,u))for(let m of u.rods)VA(h,m,f);for(let m of a)m.kind!=="capsule"&&YA(h,m,o?null:u.worldFromLink,t);return u.before&&HA(h,i.joints[l-1],u),Object.fromEntries(Object.entries(c).filter(([,m])=>m.length).map(([m,g])=>[m,hx(g)]))})}function FA(i,e){let t=n=>n?`${n.rods.map(({from:s,to:r,radius:o})=>[s.distanceTo(r),o].map(a=>a.toFixed(3)))} ${t(n.before)}`:"";return e!==void 0&&t(i)===t(e)}var pl=i=>i.clone().invert(),Vp=(i,e)=>i.map(({from:t,to:n,radius:s})=>({from:t.clone().applyMatrix4(e),to:n.clone().applyMatrix4(e),radius:s})),Xu=({worldFromLink:i},e)=>e.flatMap(({rods:t,worldFromLink:n})=>Vp(t,pl(i).multiply(n)));function BA(i){let e=new go(i.joints);e.update([0,0,0,0,0,0,1],[]);let t=[];return i.links.forEach(({arm:n,shapes:s},r)=>{let o=i.joints[r-1],a=o?t[o.parent]:null,l=a&&(a.rods.length?a:a.before),c=e.worldFromLink[r],h=s.flatMap(m=>m.kind==="capsule"?[zA(m)]:[]),u=l?Xu({worldFromLink:c},[l]).flatMap(({from:m,to:g})=>[m,g]):[new E],d=m=>Math.min(...u.map(g=>g.distanceTo(m)));for(let m of h)d(m.to)<d(m.from)-1e-6&&([m.from,m.to]=[m.to,m.from]);let f=new E().setFromMatrixPosition(c),p=a!==null&&l!==a&&f.distanceTo(new E().setFromMatrixPosition(a.worldFromLink))<.001&&!GA(i.joints[a.index-1],a),x={index:r,rods:h,before:l,after:[],worldFromLink:c,trunk:!n&&h.length>0&&(h.length>1||!l),crossed:p};h.length&&l?.after.push(x),t.push(x)}),t}function zA({pose:i,length:e,radius:t}){let n=At(i),[s,r]=[-e/2,e/2].map(o=>new E(0,0,o).applyMatrix4(n));return{from:s,to:r,radius:t}}function Py(i,e,{joints:t},n,s){let r=i.link??0;for(;r>s.index&&t[r-1].kind==="fixed";)r=t[r-1].parent;if(i.link===null||r!==s.index)return null;let o=n[i.link],a=pl(s.worldFromLink).multiply(o.worldFromLink).multiply(At(i.solid.pose)),l=Vi(i.solid,e);l.computeBoundingBox();let c=l.boundingBox,h=c.getSize(new E),u=h.x<=h.y?"x":"y",d=f=>new E().setComponent("xyz".indexOf(f),1).transformDirection(a);return{back:c.getCenter(new E).setZ(c.max.z).applyMatrix4(a),normal:d("z"),side:d(u),sizes:u==="x"?[h.x,h.y]:[h.y,h.x]}}function VA(i,{from:e,to:t,radius:n},s){let r=t.clone().sub(e),o=r.length()/2,a=Ti(o>0?r:new E(0,0,1),e.clone().lerp(t,.5)),l=Math.min(1,2*o/n),c=m=>n*(Ry-(Ry-UA)*l*(1-Math.sin(Math.PI*Math.min(1,Math.max(0,m))**.7)**.8)-.06*m),h=m=>{let[g,y]=m>0?[t,r]:[e,r.clone().negate()],[S]=s.flatMap(b=>[b.from,b.to]).sort((b,A)=>b.distanceTo(g)-A.distanceTo(g));return S!==void 0&&S.clone().sub(g).dot(y)>.3*n*y.length()},u=(m,g)=>Array.from({length:4},(y,S)=>{let b=Math.PI/2*(m<0?S/4:1-(S+1)/4);return[g*Math.sin(b),m*(o+(h(m)?.95*n:.6*g)*Math.cos(b))]}),d=[...u(-1,c(0)),...Array.from({length:15},(m,g)=>[c(g/14),o*(g/7-1)]),...u(1,c(1))];if(i("casing",un(d),a),o<.25*n)return;let[f,p]=[.16,.16+.06*n/(2*o)],x=[f,p].map(m=>[c(m)+.02*n,o*(2*m-1)]);i("ring",un([[c(f),x[0][1]],x[0],x[0],x[1],x[1],[c(p),x[1][1]]]),a)}var GA=({axis:i},e)=>ky(new E(...i),e)!==null;function ky(i,e){let{rods:t,before:n}=e,s=t.find(({from:r,to:o,radius:a})=>Math.abs(o.clone().sub(r).normalize().dot(i))>Cy&&r.clone().cross(i).length()<.3*a);if(s)return{z:s.from.dot(i)+Math.sign(s.to.clone().sub(s.from).dot(i))*-.1*s.radius,radius:.7*s.radius};if(!n||n.trunk)return null;for(let{from:r,to:o,radius:a}of Xu(e,[n])){let l=o.clone().sub(r).normalize().dot(i),[c,h]=o.length()>1.5*a?[-.45,.56]:[.55,.64];if(Math.abs(l)>Cy)return{z:o.dot(i)-Math.sign(l)*c*a,radius:h*a}}return null}function HA(i,e,t){if(e.kind!=="revolute")return;let n=new E(...e.axis).normalize(),s=ky(n,t);if(s){let[u,d]=[s.radius*1.06,.13*s.radius];i("joint",un([[0,-d],[u*.94,-d],[u,-.6*d],[u,.6*d],[u*.94,d],[0,d]]),Ti(n,n.clone().multiplyScalar(s.z)));return}let r=Xu(t,[t.before,...t.rods.length?[]:t.after]),{room:o,along:a}=zp(n,[...r,...t.rods]);if(o<Dy)return;WA(i,n,zp(n,r),zp(n,t.rods));let l=o+Ly,[c,h]=t.crossed?[.6*l,.79*l]:[.76*l,.64*l];Oy(i,Ti(n,n.clone().multiplyScalar(a)),c,h)}function Oy(i,e,t,n){let s=l=>l.map(([c,h])=>[c,-h]),r=[[.66*t,n],[.66*t,n],[.88*t,n],[.88*t,n],[t,n-.12*t],[t,n-.12*t]],o=[[0,n-.1*t],[.5*t,n-.1*t],[.58*t,n-.05*t],[.58*t,n-.05*t],[.6*t,n-.2*t]],a=[[.6*t,n-.2*t],[.6*t,n],[.6*t,n],[.7*t,n+.012*t],[.7*t,n+.012*t],[.72*t,n-.05*t]];i("joint",un([...s(r),...r.toReversed()],28),e);for(let[l,c]of[["casing",o],["ring",a]])i(l,un(s(c)),e),i(l,un(c.toReversed()),e)}function zp(i,e){let t=s=>Math.max(-1,...e.map(r=>-bu(r,s*i.x,s*i.y,s*i.z))),n={room:t(0),along:0};for(let s=-.3;s<=.3;s+=.01)t(s)>n.room/.75+.001&&Object.assign(n,{room:t(s),along:s});return n}function WA(i,e,t,n){let s=Math.abs(t.along-n.along),r=Math.min(t.room,n.room);if(r<Dy||s<r||s>t.room+n.room+Ly)return;let o=.5*r;i("joint",un([[o,-s/2],[o,s/2]]),Ti(e,e.clone().multiplyScalar((t.along+n.along)/2)))}function Uy(i,e,t,n){let s=new Ie().extractRotation(pl(e)),r=Vp(i,pl(s)),o=new Ct;for(let{from:c,to:h,radius:u}of r)for(let d of[c,h])o.expandByPoint(d.clone().addScalar(u)).expandByPoint(d.clone().addScalar(-u));let a=o.getCenter(new E),l=o.getSize(new E).multiplyScalar(.5).multiply(new E(...t));return{linkFromShell:s.clone().setPosition(a.clone().applyMatrix4(s)),box:l,edge:n*Math.min(l.x,l.y,l.z),rods:Vp(r,new Ie().makeTranslation(a.negate()))}}var $u=[-Math.PI,Math.PI],$A=i=>[-i,i],Fy=i=>[i+.04,2*Math.PI-i-.04];function By(i,e,t,n){i("joint",Sp(e,n,$u,[-1,1],Math.PI/12));for(let[s,r]of t)i("casing",Sp(e,0,s,r,Math.PI/15))}function XA(i,{rods:e,worldFromLink:t}){let n=Uy(e,t,[.94,.9,.95],.5);return n.rods.some(s=>bu(s,0,0,0)<-.5*s.radius)?(By(i,n,[[$A(.75),[-.62,.5]],[Fy(.75),[-.62,.5]],[$u,[.53,1]]],.008),!0):!1}function qA(i,e,t){let n=e.radius,s=Uy([e],t,[.84,.72,.8],.62);By(i,s,[[$u,[.5,1]],[Fy(.95),[-.3,.48]],[$u,[-1,-.32]]],.01);for(let r of[-.26,.26]){let o=new E(s.box.x-.012,r*n,.12*n).applyMatrix4(s.linkFromShell);i("ring",un([[.13*n,-.01],[.13*n,0],[.1*n,.008],[0,.009]],18),Ti(new E(1,0,0).transformDirection(s.linkFromShell),o))}}function YA(i,e,t,n){let s=o=>Math.abs(new E().setFromMatrixPosition(At(e.pose)).applyMatrix4(t).z-o)<.1*o;if(e.kind!=="sphere"||!t||!s(e.radius))return i("casing",Vi(e,n).clone(),At(e.pose));let r=new E(0,1,0).transformDirection(pl(t));Oy(i,Ti(r,new E().setFromMatrixPosition(At(e.pose))),.9*e.radius,.42*e.radius)}var ZA=.8,jA=[15,85,155,225],KA=[8,40,72,104],JA=[-30,-95,-160],Gp=(...[i,e,t,n])=>new Wu(i,e,t,2,n);function QA(i,e,t,n){let s=e.to.clone().sub(e.from),r=s.lengthSq()>0?s.normalize():Mp.clone(),o=t?t.back.clone().sub(e.to).dot(r):1/0,a=o>ZA*e.radius,l=t?(a?t.normal:t.side).clone():new E(1,0,0),c=l.addScaledVector(r,-l.dot(r));c.lengthSq()<1e-4&&c.set(r.y,r.z,r.x).cross(r),c.normalize();let h=new Ie().makeBasis(c,r.clone().cross(c),r).setPosition(e.to),u=(f,p,x=new Ie)=>i(f,p,h.clone().multiply(x)),d=e.to.distanceTo(e.from);a?eR(u,e.radius,d,t!==null,n):tR(u,e.radius,d,o,t.sizes[0]/2),t&&nR(u,a,e.radius,t,h)}var xo=(i,e,t)=>new Ie().makeTranslation(i,e,t),zy=(i,e)=>Ti(e.clone().sub(i),i.clone().lerp(e,.5));function eR(i,e,t,n,s){let[r,o]=[-t-1.05*e,-.62*e];i("casing",un([[0,r],[.36*e,r],[.42*e,r+.1*e],[.42*e,r+.3*e],[.33*e,o-.25*e],[.3*e,o],[0,o]],24)),i("joint",un([[.3*e,o-.32*e],[.37*e,o-.3*e],[.37*e,o-.14*e],[.3*e,o-.12*e]],24)),i("ring",un([[.4*e,r+.34*e],[.435*e,r+.34*e],[.43*e,r+.4*e],[.39*e,r+.4*e]],24)),i("casing",Gp(.27*e,1.02*e,1.25*e,.11*e),xo(.29*e,0,-.06*e)),i("joint",Gp(.1*e,.8*e,.8*e,.04*e),xo(.41*e,0,-.1*e));let[a,l]=n?[jA,.25*e]:[KA,.42*e],c=new E(n?0:-.12*e,0,(n?.45:.3)*e);for(let h of[-.385,-.14,.14,.385])Iy(i,a,l,c.clone().setY(h*e),.088*e);Iy(i,JA,l,c.clone().setY((s?-.3:.3)*e),.1*e)}function Iy(i,e,t,n,s){let r=e.map(o=>{let a=o*Math.PI/180;return new E(Math.cos(a),0,Math.sin(a)).multiplyScalar(t).add(n)});r.slice(1).forEach((o,a)=>{let l=r[a],[c,h]=[l.distanceTo(o)/2,s*(1-.06*a)],u=a===r.length-2?c+.6*h:c-.35*h;i("casing",un([[0,-c],[.85*h,.35*h-c],[h,.6*h-c],[h,u-.5*h],[.8*h,u-.1*h],[0,u]],12),zy(l,o)),i("joint",new Oi(.98*h,10,6),xo(l.x,l.y,l.z))})}function tR(i,e,t,n,s){let r=-t-.9*e;i("casing",un([[0,r],[.8*e,r],[.84*e,r+.08*e],[.84*e,-.2*e],[.76*e,-.12*e],[0,-.12*e]],28)),i("ring",un([[.84*e,-.5*e],[.88*e,-.48*e],[.88*e,-.36*e],[.84*e,-.34*e]],28)),i("joint",Gp(1.5*e,.86*e,.42*e,.08*e),xo(0,0,.02*e));let o=.16*e,a=.3*e,l=Math.min(s,.75*e)+o/2,c=Math.sqrt(Math.max(0,(e+.008)**2-(l+o/2)**2-a**2)),h=Math.min(n+.012,c);for(let u of[-l,l])i("casing",new kn(o,2*a,h-.05*e),xo(u,0,(h+.05*e)/2))}function nR(i,e,t,{back:n,normal:s,side:r,sizes:o},a){let l=a.clone().invert(),c=n.clone().applyMatrix4(l),h=new Ie().extractRotation(l),u=new Ie().makeBasis(r.clone().transformDirection(h),s.clone().cross(r).transformDirection(h),s.clone().transformDirection(h)),d=.006;if(i("handle",new kn(.62*o[0],.62*o[1],d),u.setPosition(c)),!e)return;let f=new E(0,0,.45*t);i("handle",new Ds(.12*t,.98*t,4,14),xo(f.x,f.y,f.z)),i("handle",un([[.075*t,-f.distanceTo(c)/2],[.075*t,f.distanceTo(c)/2]],12),zy(f,c))}var iR=i=>({body:i,arm:i,joint:i,ring:i,handle:i,collision:i,tool:i,coloured:()=>i});function Vy(i,e,t,n,s,...r){let o=new ml(i,e,iR(new Un({color:n,transparent:!0,opacity:.22,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-2,stencilWrite:!0,stencilRef:1+s%255,stencilFunc:Sf,stencilZPass:Mf})),t);return o.show(...r),o.order=10+s,o.group}var Wp=i=>!i.links.some(({visual:e})=>e);function sR(i,e){let{robot:t}=i;return t?Wp(t)?Ny(i,e).map(n=>Object.entries(n).map(([s,r])=>({geometry:r,linkFromPart:new Ie,look:s}))):t.links.map(({shapes:n})=>n.map(s=>({geometry:Vi(s,e),linkFromPart:At(s.pose),look:s.color??"casing"}))):[]}function Hp(i,e,t){let n=new ot(i,e);return n.matrixAutoUpdate=!1,n.matrix.copy(t),n}var ml=class{constructor(e,t,n,s){this.head=e;this.meshes=t;this.materials=n;let{robot:r,tool:o}=e;this.tree=r?new go(r.joints):null,this.parts=s?.parts??sR(e,t),this.parts.forEach((a,l)=>{let c=new rt;c.matrixAutoUpdate=!1;let h=r.links[l].arm?n.arm:n.body;for(let{geometry:u,linkFromPart:d,look:f}of a){let p=Hp(u,typeof f!="string"?n.coloured(f):f==="casing"?h:n[f],d);p.castShadow=p.receiveShadow=!s,c.add(p)}this.links.push(c),this.group.add(c)}),this.linkFromTool=At(o.solid.pose),this.tool=Hp(s?.tool.geometry??Vi(o.solid,t),n.tool,this.linkFromTool),this.tool.castShadow=!s,this.group.add(this.tool)}head;meshes;materials;group=new rt;tool;tree;links=[];collision=[];linkFromTool;parts;show(e,t,n){let s=this.tree!==null&&t.length>0;for(let a of this.links)a.visible=s;this.tree&&s&&(this.tree.update(e??[0,0,0,0,0,0,1],t),this.links.forEach((a,l)=>{a.matrix.copy(this.tree.worldFromLink[l]),a.matrixWorldNeedsUpdate=!0}));let{link:r}=this.head.tool,o=r!==null&&s?this.tree.worldFromLink[r]:void 0;this.tool.visible=o!==void 0||n!==null,o?this.tool.matrix.multiplyMatrices(o,this.linkFromTool):n&&At(n,this.tool.matrix).multiply(this.linkFromTool),this.tool.matrixWorldNeedsUpdate=!0}set collisionShown(e){e&&!this.collision.length&&this.head.robot?.links.forEach((t,n)=>{for(let s of $p(t)){let r=Hp(Vi(s,this.meshes),this.materials.collision,At(s.pose));this.collision.push(r),this.links[n].add(r)}});for(let t of this.collision)t.visible=e}set order(e){for(let t of[this.tool,...this.links.flatMap(({children:n})=>n)])t.renderOrder=e}get toolPlace(){return new E().setFromMatrixPosition(this.tool.matrix)}get rootPlace(){return new E().setFromMatrixPosition(this.links.find(e=>e.children.length)?.matrix??new Ie)}},$p=({visual:i,shapes:e,collision:t})=>i?t??[]:e;var Gy=5,Hy=1.5,Wy=.07,rR=.01,qu=class{constructor(e,t,n){this.recording=e;this.robot=t;this.still=n;n.group.updateMatrixWorld(!0)}recording;robot;still;direction=null;get from(){let{count:e,over:t}=this.still.round;return(!this.direction||!t&&this.direction.samples!==e)&&(this.direction={samples:e,from:this.findDirection()}),this.direction.from}all(e){return this.move(e),oR(so([...this.robot?[this.robot.group]:[],this.still.bodies]))}surface(){let{corners:e}=this.still;if(!e.length)return this.all(0);let t=this.contacts.flatMap(n=>(this.move(n),this.robot?so([this.robot.tool]):[]));return[...e,...t]}at(e){let{round:t}=this.still,n=t.plan.phases.filter(({contact:d})=>d),s=n.findIndex(({end:d})=>d>e),[r,o]=[n.at(s<0?-1:s-1),s<0?void 0:n[s]],a=s===0?0:r?.end??0,l=o?.start??t.length,c=(a+l)/2;if(o&&e>=Math.max(l-Hy,Math.min(c,l)))return this.stroke(o);if(r&&s!==0&&e<Math.min(a+Hy,c))return this.stroke(r);let h=[a,c,l].filter(d=>t.over||d<=t.t.at(-1)),u=[r,o].flatMap(d=>d?$y(t,d):[]);return{key:`${t.number} free ${a}`,points:[...(h.length?h:[e]).flatMap(d=>this.all(d)),...u]}}stroke(e){let t=$y(this.still.round,e);return{key:`${this.still.round.number} stroke ${e.start}`,points:t.length?t:this.surface()}}get contacts(){let{count:e,t,plan:n}=this.still.round,s=n.phases.filter(({contact:o,end:a})=>o&&e>0&&a<=t.at(-1)).map(({start:o,end:a})=>(o+a)/2),r=Math.max(1,s.length/Gy);return Array.from({length:Math.min(Gy,s.length)},(o,a)=>s[Math.floor(a*r)])}move(e){let{round:t}=this.still,n=this.recording.at(t.start+Math.min(e,t.length));n&&this.robot&&(this.robot.show(t.plan.root,n.q,n.tool),this.robot.group.updateMatrixWorld(!0))}findDirection(){let{plan:e}=this.still.round,t=this.contacts.map(a=>(this.move(a),{blocks:this.robot?cu(this.robot.links):[],tool:this.robot?[this.robot.toolPlace,...so([this.robot.tool])]:[]})),n=this.still.pointsOver(rR),s=n[0],r=ds(e.surface,s),o=this.robot&&t.length?s.clone().sub(this.robot.rootPlace):new E(.75,-1,0);return o.setZ(0).length()<.001&&o.set(1,0,0),Ox(t,n,r,o.normalize().setZ(.6).normalize())}};function $y({plan:{strokes:i,surface:e}},{stroke:t}){let n=fs(e.shape,ro(i[t??-1]??[]),!1),s=At(e.pose);return n.flatMap(r=>{let o=new Ct().expandByPoint(new E(...r).applyMatrix4(s)).expandByScalar(Wy);return o.min.z+=Wy,up(o)})}var oR=i=>i.length?i:[new E(-.5,-.5,0),new E(.5,.5,.5)];var Zu={believed:!0,estimated:!0,actual:!0,seen:!1,path:!0,ribbon:!0,strokes:!1,rejected:!0,bases:!1,force:!0,events:!0,found:!0,actualSurface:!0,collision:!1},nr={trajectories:[],ghosts:[],frames:[],particles:[],intervals:[]},aR=9,lR=6,Xp=new E(.9,.5,1.9),Xy=1.7,qy=1.4,cR=Math.PI-qy-Xy*Xp.z/Xp.length(),hR={body:"body-1",arm:"arm-1",joint:"joint",ring:"ring",handle:"joint",collision:"quiet",tool:"tool"},Yu=class{constructor(e,t,n){this.canvas=e;this.recording=t;this.left=n;this.painter=new Uu(e);let s=a=>this.painter.software?new Un:new _a({roughness:a,metalness:.05}),r=new Map,o=a=>{let[l,c,h,u]=a,d=r.get(a.join());if(d)return d;let f=Object.assign(s(.5),u<1?{depthWrite:!1}:{});return f.userData.opacity=u,f.color.setRGB(l,c,h,Zt),this.clear(f),r.set(a.join(),f),f};this.materials={body:s(.6),arm:s(.5),joint:s(.45),ring:s(.4),handle:s(.4),collision:new ln({wireframe:!0,transparent:!0,opacity:.35}),tool:new Un,coloured:o,own:r},this.scene.add(this.dirt.group,this.map.mesh,this.force.group,this.marks.group,this.queried,this.highlights,this.ghosts,this.rejected.group,this.bases.group),this.camera=new vu(e,()=>this.ask(),()=>this.leave()),e.addEventListener("webglcontextrestored",()=>this.ask()),this.paint()}canvas;recording;left;layers={...Zu};camera;painter;scene=new Jo;materials;seeThrough=0;ground=new ot(new Os(1,1),new ba({opacity:.14}));sun=null;grid=null;robot=null;ghosts=new rt;current=null;entered=new Map;shown=nr;selected=null;highlights=Bn([],Et(new $t({linewidth:8,transparent:!0,opacity:.75,depthWrite:!1}),"highlight"));queried=new rt;dirt=new Su;map=new du;force=new Eu;marks=new Ou;rejected=new Gu;bases=new Hu;choice=null;begun=!1;chosen=!1;shot=null;sized=!1;apply=()=>{};first=null;moved=()=>this.draw();time=0;drawn=0;onDrawn=null;show(e){this.time=e,this.ask()}ask(){Rn.draw(this.moved)}resize(e,t,n){if(!(!e||!t)){if(this.apply=()=>this.applySize(e,t,n),this.sized||!this.painter.software)return this.apply();this.first??=requestAnimationFrame(()=>setTimeout(()=>{this.canvas.isConnected&&this.apply()}))}}applySize(e,t,n){this.painter.size(e,t),this.camera.shape(e,t,n),this.chosen||(this.begun=!1),this.sized=!0,this.draw()}look(e){let t=this.recording.at(this.time),n=this.current?.shots;if(!n||!t)return;this.shot=null,this.chosen=!0;let s=e==="all"?[...n.all(t.time),...this.bases.places]:n.surface();this.camera.look(hu(s,e==="above"?new E(0,-.001,1):n.from,this.camera.angles),!0),this.ask()}timeAt(e,t){let n=this.current?.path;if(!n||!(this.layers.path||this.layers.ribbon))return null;let{clientWidth:s,clientHeight:r}=this.canvas,o=n.nearest(a=>(a.project(this.camera.lens),{x:(a.x+1)/2*s,y:(1-a.y)/2*r}),e,t,this.time-n.round.start,aR,!this.layers.path);return o===null?null:n.round.start+o}get follow(){return this.shot!==null}set follow(e){this.shot=e?"":null,this.chosen=!0,this.ask()}set xray(e){this.seeThrough=e;let{body:t,arm:n,joint:s,ring:r,handle:o,own:a}=this.materials;for(let l of[t,n,s,r,o,...a.values()])this.clear(l);this.robot&&(this.robot.order=e>0?9:0),this.ask()}choose(e){this.choice=e,this.ask()}get chosenNow(){return this.choice&&this.choice.round===this.current?.still.round?this.choice:null}select(e){this.selected=e,this.lightRibbon(),this.ask()}showData(e){this.shown=e,Ka(this.queried);for(let t of[...Bx(e.trajectories),...Fx(e.particles),...zx(e.frames)])this.queried.add(t);this.makeGhosts(),this.drawHighlights(),this.ask()}makeGhosts(){Ka(this.ghosts);let{head:e,meshes:t}=this.recording;if(!(!e||!this.robot))for(let[n,{time:s,color:r}]of this.shown.ghosts.entries()){let o=this.recording.at(s);o&&this.ghosts.add(Vy(e,t,this.robot,ys(r,De("ghost")),n,o.round.plan.root,o.q,o.tool))}}paint(){for(let[e,t]of Object.entries(hR))this.materials[e].color.set(De(t));this.painter.paint(),this.showData(this.shown),tp(this.scene),this.dirt.paint();for(let{still:e,path:t}of this.entered.values())tp(e.group),t.paint();this.ask()}picture(){return this.draw(!0),this.canvas.toDataURL("image/png")}destroy(){Rn.drop(this.moved),this.camera.controls.dispose();for(let{still:e,path:t}of this.entered.values())for(let n of[e.group,t.object])Zh(n);this.painter.destroy()}draw(e=!this.painter.software){let t=this.recording.at(this.time);this.sized&&(t&&this.place(t),this.sun&&(this.sun.castShadow=this.ground.visible=e||!this.painter.software),this.painter.draw(this.scene,this.camera.lens,e,()=>this.draw(!0)),this.drawn++,this.onDrawn?.())}place(e){let{head:t,meshes:n}=this.recording,{round:s,time:r}=e;!this.robot&&t&&(this.robot=new ml(t,n,this.materials),this.scene.add(this.robot.group),this.makeGhosts()),this.current?.still.round!==s&&this.enter(s);let{still:o,path:a}=this.current;this.aim(r),this.robot?.show(s.plan.root,e.q,e.tool);let l=e.phase>=0?s.plan.phases[e.phase].stroke:null,c=this.chosenNow;this.rejected.show(this.layers.rejected&&c?.rejected?c.rejected.lines:null,s.plan.surface),this.bases.show(this.layers.bases?s.plan.bases:void 0,us()),o.show({strokes:this.layers.strokes,found:this.layers.found,actual:this.layers.actualSurface},l,this.recording.foundAt(this.time),c?.stroke??null),this.robot&&(this.robot.collisionShown=this.layers.collision),o.fade(this.camera.lens.position),a.show(r,this.layers),this.dirt.show(this.recording,this.time,e,this.layers,this.camera.pixelsPerMetre(o.surface,this.canvas.clientHeight)),this.map.show(ou(this.recording,this.time,s,this.layers),us()),this.marks.show(this.recording,s,r,this.layers.events,us()),this.robot&&this.force.show(e,this.robot.toolPlace,this.camera.lens.position,this.layers.force)}enter(e){this.current&&this.scene.remove(this.current.still.group,this.current.path.object);let t=this.entered.get(e);if(!t){let n=new uu(e,this.recording);t={still:n,path:new Bu(e),shots:new qu(this.recording,this.robot,n)}}this.entered.delete(e),this.entered.set(e,t);for(let[n,{still:s,path:r}]of this.entered){if(this.entered.size<=lR)break;this.entered.delete(n);for(let o of[s.group,r.object])Zh(o)}this.current=t,this.scene.add(t.still.group,t.path.object),this.drawHighlights(),this.lightRibbon()}aim(e){let t=this.current.shots;if(this.begun||(this.begun=!0,this.camera.look(hu(t.surface(),t.from,this.camera.angles)),this.grid||this.build(new Ct().setFromPoints(t.all(e)).getBoundingSphere(new an))),this.shot!==null){let{key:n,points:s}=t.at(e);n!==this.shot&&this.camera.look(hu(s,t.from,this.camera.angles),!0),this.shot=n}this.camera.step()&&this.ask()}leave(){this.chosen=!0,this.shot!==null&&(this.shot=null,this.left())}clear(e){let t=(e.userData.opacity??1)*(1-this.seeThrough);e.opacity=t,e.transparent=t<1}lightRibbon(){if(!this.current)return;let{ribbon:e,round:{start:t}}=this.current.path;e.select(this.selected&&[this.selected[0]-t,this.selected[1]-t])}drawHighlights(){let e=this.current?.path;Ja(this.highlights,e?this.shown.intervals.flatMap(({start:t,end:n})=>e.between(t-e.round.start,n-e.round.start)):[])}build({center:e,radius:t}){let n=2*Math.min(60,Math.max(6,Math.ceil(3*t)));this.grid=new Ia(n/2,n),this.grid.rotation.x=Math.PI/2,this.grid.position.set(Math.round(e.x),Math.round(e.y),0),Et(Object.assign(this.grid.material,{vertexColors:!1,transparent:!0,opacity:.7}),"rule"),this.ground.scale.setScalar(n/2),this.ground.position.set(this.grid.position.x,this.grid.position.y,-.001),this.ground.receiveShadow=!0;let s=new Aa(16777215,Xy);s.position.copy(e).addScaledVector(Xp,2*t),s.target.position.copy(e),this.sun=s,s.shadow.mapSize.setScalar(this.painter.software?512:1024),Object.assign(s.shadow,{bias:-5e-4,normalBias:.01,intensity:.4,radius:4}),Object.assign(s.shadow.camera,{left:-1.4*t,right:1.4*t,top:1.4*t,bottom:-1.4*t,near:.1,far:9*t});let r=new Sa(16777215,9080728,qy);r.position.set(0,0,1),this.scene.add(this.grid,this.ground,s,s.target,r,new Ra(16777215,cR));for(let[o,a]of[[[1,0,0],"axis-x"],[[0,1,0],"axis-y"],[[0,0,1],"axis-z"]])this.scene.add(Bn([0,0,.002,...o.map(l=>.25*l)],Et(new $t({linewidth:2.5}),a)))}};var uR=.95,dR=([i,e],[t,n])=>i<=n+$h&&e>=t-$h;function ir({about:i,view:e},t){let n=new Map,s=o=>n.set(o,(n.get(o)??0)+1),r=t===null?i:[i[t]??[]];for(let o of r)for(let a of new Set(o.map(({episode:l})=>l)))s(a);if(t===null&&e)for(let{episode:o}of[...e.tracks,...e.bodies,...e.particles])s(o);return[...n].sort((o,a)=>a[1]-o[1]).map(([o])=>o)}function Yy(i,e,t,n){let s=i.view,r=s?.episodes.find(h=>h.id===t),o={...structuredClone(nr),since:[]};if(!s||!r)return o;let a=h=>mR(n,r.rounds??[r.interval[0]],h),l=pR(e===null?i.about.flat():i.about[e]??[],t,r.interval);for(let{interval:h,class:u}of l)h&&o.intervals.push({start:a(h[0]),end:a(h[1]),label:fR(u)});let c=h=>e===null||!l.length||l.some(u=>u.interval&&dR(u.interval,h));for(let{episode:h,thing:u,interval:d,path:f,samples:p,strong:x,colour:m}of s.tracks){if(h!==t||!c(d))continue;let g=`${Yp(u)} ${Je(a(d[0]))} to ${Je(a(d[1]))}`,y=p.map(([,S,b,A])=>[S,b,A]);o.trajectories.push({name:g,points:f.length>1?f:y,samples:y,...qp(x,m)})}for(let{episode:h,thing:u,kind:d,time:f,pose:p,strong:x,colour:m}of s.bodies)h!==t||!c([f,f])||(d==="robot"||d==="tool"?o.ghosts.push({time:a(f),...qp(x,m)}):o.frames.push({name:`${Yp(u)} at ${Je(a(f))}`,time:a(f),pose:p,...qp(x,m)}));for(let{episode:h,round:u,state:d,positions:f,colour:p}of s.particles){let x=n.rounds.find(b=>b.number===u),m=r.rounds?.[u-1]??r.interval[0];if(h!==t||!x||!c([m,m+x.length]))continue;let g=d==="before",y=`${g?"dirt before":"estimated dirt after"} round ${u}, as queried`,S=(g?null:x.interpreted?.found)??x.plan.surface.pose;o.particles.push({name:y,state:d,pose:S,shape:x.plan.surface.shape,places:f,...p?{color:p}:{}}),o.since.push(g?x.start:x.end)}if(o.ghosts=[...new Map(o.ghosts.map(h=>[h.time,h])).values()].sort((h,u)=>h.time-u.time),!o.intervals.length)for(let[h,u]of r.shown)o.intervals.push({start:a(h),end:a(u),label:"shown"});return o}var qp=(i,e)=>e?{color:e}:i?{color:De("highlight")}:{},fR=i=>qa(i.replace(/([a-z])(?=[A-Z])/g,"$1 ")).toLowerCase();function pR(i,e,[t,n]){let s=new Set;return i.filter(({episode:r,interval:o,class:a})=>{if(r!==e||!o)return!1;let l=`${a} ${o.join()}`;return s.has(l)||o[1]-o[0]>uR*(n-t)?!1:(s.add(l),!0)})}function mR(i,e,t){let n=e.findLastIndex(r=>r<=t+$h);n=Math.max(0,n);let s=i.rounds.find(({number:r})=>r===n+1)??i.rounds.at(-1);return s?Math.min(s.end,Math.max(s.start,s.start+t-e[n])):0}function Zy(i,e){i.show(e);let{ghosts:t,frames:n,intervals:s,since:r}=e,o=[[...t,...n].map(({time:a})=>a),s.map(({start:a})=>a),r].find(a=>a.length);o&&i.seek(Math.min(...o))}var Yp=i=>i.replace(/^[a-z]+:/,""),Zp=i=>/\d{8}-\d{6}-[0-9a-f]{4}/.exec(i)?.[0]??null,gR=i=>/(?:^|, )(?:human )?collision(?: \d+)?$/i.test(i)?qa(i):i,jp=({names:i},e)=>Object.hasOwn(i,e)?gR(i[e]):Yp(e).replace(/_(\d{8}-\d{6}-[0-9a-f]{4})-(\d+)$/," $2"),Kp=i=>new Date(1e3*i).toLocaleString("en-GB",{day:"numeric",month:"short",hour:"2-digit",minute:"2-digit"}),Jp=({task:i,begun:e})=>`${i}, ${Kp(e)}`;var Qp=200,xR=8,yR=3,vR=1e9,bR=1e10,jy={share:["%",100],rad:["\xB0",180/Math.PI],m:["mm",1e3],"m per episode":["mm per episode",1e3]};function gl(i){let{view:e,about:t}=i;return!!e&&ir(i,null).length>0&&(e.tracks.length>0||e.bodies.length>0||e.particles.length>0||t.some(n=>n.some(({interval:s})=>s)))}function ju(i,e){let{rows:t,columns:n,holds:s,more:r,seconds:o,printed:a,remarks:l,view:c,about:h}=i,u=s?`${t.length}${r?" or more":""} ${t.length===1?"answer":"answers"}`:"No answer: false",d=[_("p",{class:"s-count"},_("b",{},u),o===void 0?"":` in ${Fe(o,2)} s`)];if(gl(i)){d.push(_("div",{class:"s-row"},_("button",{class:"w-button",type:"button",click:()=>e.show(i,null,null)},"Show all"),_("button",{class:"w-button",type:"button",click:()=>e.clear()},"Clear")));let p=ir(i,null);p.length>1&&d.push(_("div",{class:"s-in"},_("span",{class:"w-quiet"},"in "),...p.slice(0,xR).map(x=>_("button",{class:"s-chip",type:"button",title:x,click:()=>e.show(i,null,x)},_R(i,x)))))}let f=c?.left_out??0;f&&d.push(_("p",{class:"w-quiet s-remark"},`The picture is full: ${f} more queried ${f===1?"object is":"objects are"} not drawn.`));for(let p of l)d.push(_("p",{class:"w-quiet s-remark"},p));a&&d.push(_("pre",{class:"s-printed"},a));for(let p of c?.plots??[])d.push(Hx(p,wR(i,p)));return t.length&&n.length?d.push(MR(i,e)):t.length&&h.every(p=>!p.length)&&d.push(_("p",{},"True.")),t.length>Qp&&d.push(_("p",{class:"w-quiet"},`The table lists the first ${Qp} of ${t.length} answers.`)),d}var Ky=({about:i},e)=>i.flat().find(({episode:t})=>t===e),_R=(i,e)=>{let t=Ky(i,e);return t?Jp(t):e};function wR(i,{amounts:e=[],spans:t=[]}){let n=new Set([...e,...t].map(([s])=>Zp(s)).filter(s=>s!==null));return s=>{let[r,o]=[Zp(s),jp(i,s)];if(r===null||n.size<2)return o;let a=Ky(i,r);return`${o}
${a?`${Kp(a.begun)}, ${a.task}`:r}`}}function MR(i,e){let{rows:t,columns:n,units:s,about:r}=i,o=n.map((h,u)=>s[u]?`${h} [${jy[s[u]]?.[0]??s[u]}]`:h),a=r.some(h=>h.length>0),l=[_("span",{class:"w-hidden"},"show"),...o,...a?["Episode"]:[]],c=t.slice(0,Qp).map((h,u)=>{let d=r[u]??[],f=[...h.map((p,x)=>TR(i,p,s[x]??null)),...a?[SR(d)]:[]];return f.forEach((p,x)=>p.setAttribute("data-title",o[x]??"Episode")),_("tr",{},_("td",{},d.length?_("button",{class:"w-button s-show",type:"button","data-row":u,"aria-label":`Show answer ${u+1}`,click:()=>e.show(i,u,null)},"Show"):""),...f)});return _("div",{class:`s-table${n.length>yR?" s-stacks":""}`,tabindex:0,role:"group","aria-label":"Answers"},Jn(l,c))}function SR(i){let e=new Map(i.map(t=>[t.episode,Jp(t)]));return _("td",{title:[...e.keys()].join(", ")},[...e.values()].join("; "))}function TR(i,e,t){if(typeof e=="number"){let s=!t&&e>=vR&&e<bR,[,r]=jy[t??""]??["",1],o=s?ER(e):Number.isInteger(e)&&!t?String(e):t==="share"?Fe(r*e,1):String(Number((r*e).toPrecision(t?3:5)));return _("td",{class:"s-number",title:`${e}${t&&t!=="share"?` ${t}`:""}`},o.replace("-","\u2212"))}if(e===null)return _("td",{class:"w-quiet"},"_");let n=Jy(i,e);return _("td",{title:typeof e=="string"?e:n},n)}var Jy=(i,e)=>e===null?"_":Array.isArray(e)?`[${e.map(t=>Jy(i,t)).join(", ")}]`:typeof e=="number"?String(Number(e.toPrecision(6))):jp(i,e),ER=i=>{let e=new Date(1e3*i);return`${e.toLocaleTimeString("en-GB")}.${String(e.getMilliseconds()).padStart(3,"0")}`};var yo=[.1,.25,.5,1,2,5,10],AR=1.15,em={least:.12,most:.8},RR=3,CR=300;function Ku(i,e){let t,n=i.subscribe(({playing:s,following:r})=>{clearTimeout(t),!s&&!r&&(t=setTimeout(()=>e(i.time),CR))});return()=>{clearTimeout(t),n()}}var vo=class{constructor(e=Rn){this.pictures=e}pictures;time=0;playing=!1;following=!1;speed=1;spans=new Set;callbacks=new Set;frame=null;before=0;late=0;known={edge:0,since:0,every:em.least,pace:0};join(e){return this.spans.add(e),()=>{this.spans.delete(e)}}get duration(){return Math.max(0,...[...this.spans].map(e=>e.duration))}get end(){return Math.max(0,...[...this.spans].map(e=>e.now))}get edge(){let e=[...this.spans].filter(t=>t.live);return e.length?Math.max(0,...e.map(t=>t.now)):this.end}get isLate(){return this.playing&&this.late>1}get live(){return[...this.spans].some(e=>e.live)}subscribe(e){return this.callbacks.add(e),()=>this.callbacks.delete(e)}onGrowth(){this.following&&!this.live&&(this.following=!1,this.time=this.end),this.following&&(this.keepPace(),this.run()),this.notify()}seek(e){this.following=!1,this.time=Math.min(this.duration,Math.max(0,Number.isFinite(e)?e:0)),this.notify()}play(){if(this.time>=this.end-1e-6){if(this.live)return this.follow();this.time=0}this.playing=!0,this.following=!1,this.run(),this.notify()}pause(){this.playing=!1,this.following=!1,this.notify()}toggle(){this.playing||this.following?this.pause():this.play()}follow(){this.following=!0,this.playing=!1,this.known={edge:-1,since:this.pictures.now(),every:em.least,pace:0},this.keepPace(),this.run(),this.notify()}setSpeed(e){this.speed=Math.min(10,Math.max(.1,e)),this.notify()}faster(e){let t=yo.reduce((n,s,r)=>Math.abs(s-this.speed)<Math.abs(yo[n]-this.speed)?r:n,0);this.setSpeed(yo[Math.min(yo.length-1,Math.max(0,t+e))])}destroy(){this.frame!==null&&this.pictures.cancel(this.frame),this.frame=null,this.callbacks.clear()}run(){this.frame===null&&(this.before=this.pictures.now(),this.late=0,this.frame=this.pictures.request(e=>this.step(e)))}step(e){this.frame=null;let t=Math.max(0,(e-this.before)/1e3);this.late=t>RR?this.late+1:0;let n=this.late?.25:t;if(this.before=Math.max(this.before,e),this.following){let{edge:r}=this,o=r-this.time,a=n*this.known.pace;this.time=Math.abs(o)<=Math.max(.001,a)?r:this.time+Math.sign(o)*a}else this.playing&&(this.time=Math.min(this.end,this.time+n*this.speed),this.time>=this.end&&(this.playing=!1,this.live&&this.follow()));(this.playing||this.following&&this.edge!==this.time)&&(this.frame=this.pictures.request(r=>this.step(r))),this.notify()}keepPace(){let{edge:e,known:t}=this;if(e===t.edge)return;let n=this.pictures.now(),{least:s,most:r}=em,o=Math.min(r,Math.max(s,(n-t.since)/1e3)),a=t.edge<0?s:t.every+.3*(o-t.every);this.known={edge:e,since:n,every:a,pace:Math.abs(e-this.time)/(AR*a)}}notify(){for(let e of this.callbacks)e(this)}};var PR=.9;function Ju(i){let{plan:{treatment:e},interpreted:t,truth:n}=i;return _n(i)?!!(bn(e,t?.treated)&&bn(e,n?.treated)):!!(t&&n?.particles)}function IR(i){let e=i.filter(r=>r>0).sort((r,o)=>o-r),t=PR*e.reduce((r,o)=>r+o,0),n=0;return e.findIndex(r=>(n+=r)>=t-1e-9)+1}function LR(i,{cell:e,places:t}){let n=new Map,s=(r,o)=>Math.round((r-(t[o]??0))/(Zf*e));for(let r=0;r+1<i.length;r+=2){let o=`${s(i[r],0)} ${s(i[r+1],1)}`;n.set(o,(n.get(o)??0)+1)}return[...n.values()]}function tm(i,e,t){let n=Math.abs(Math.round(e)-t);return[i,String(Math.round(e)),String(t),i.endsWith("(sample)")?"":`${n} ${n===1?"particle":"particles"}`]}function DR({plan:{goal:i},interpreted:e,truth:t}){let{particles:n,density:s}=e,r=t.particles,o=s?"":" (sample)",a=s?s.remaining??s.expected.reduce((d,f)=>d+f,0):n.length/2,l=t.remaining??r.length/2,c=r.length/2!==l||t.remaining===void 0&&r.length/2>=Lp,h=[];if(i?.kind==="collected"&&!c&&(!s||s.goal!==void 0)){let d=s?.goal??Xa(pt(n),i),f=Xa(pt(r),i);h.push(tm(`In the goal area${o}`,d,f),tm(`Elsewhere on the surface${o}`,Math.max(0,a-d),l-f))}else(t.remaining!==void 0||!c)&&h.push(tm(`Left on the surface${o}`,a,l));let u=d=>`${Math.round(IR(d)*s.cell**2*1e4)} cm\xB2`;return s&&!c&&a>0&&l>0&&h.push(["Area that holds 90\u202F% of the dirt",u(s.expected),u(LR(r,s)),""]),h}function NR(i){let{plan:{treatment:e},interpreted:t,truth:n}=i,s=e,r=[bn(s,t.treated),bn(s,n.treated)],{length:o}=r[0],[a,l]=[el(s,r[0]),el(s,r[1])],c=r.map(d=>d.reduce((f,p)=>f+p,0)/Math.max(1,o)),h=d=>s.unit==="passes"?Fe(d,2):`${Fe(d,1)} ${s.unit}`,u=a.filter((d,f)=>d!==l[f]).length;return[[`Mean ${Mi(i)}`,h(c[0]),h(c[1]),h(Math.abs(c[0]-c[1]))],["Places whose mean is in the band",_e(tl(a,"allowed"),1),_e(tl(l,"allowed"),1),`${u} of ${o} places`]]}function nm({interpreted:i,truth:e}){let t=e?.performance??null;return!!(i&&t!==null&&(t<i.estimate.low||t>i.estimate.high))}function im(i){let{mean:e}=i.interpreted.estimate,t=i.truth.performance??null,n=_n(i)?NR(i):DR(i);if(t===null)return n;let s=o=>Number(Fe(100*o,1)),r=`${Fe(Math.abs(s(e)-s(t)),1)} points, ${nm(i)?"outside":"inside"} the interval`;return[...n,["Performance",_e(e,1),_e(t,1),r]]}var kR={play:"M4 2.5v11l9.5-5.5z",pause:"M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z",before:"M3 3h2v10H3zM13 3v10L6 8z",after:"M11 3h2v10h-2zM3 3v10l7-5z"},sm=i=>ie("svg",{viewBox:"0 0 16 16",width:14,height:14,"aria-hidden":"true",fill:"currentColor"},ie("path",{d:kR[i]})),OR={believed:()=>ie("circle",{cx:8,cy:8,r:3.2,fill:"var(--believed)"}),estimated:()=>ie("circle",{cx:8,cy:8,r:4.6,fill:"none",stroke:"var(--estimated)","stroke-width":2.4}),actual:()=>ie("path",{d:"M4 4l8 8M12 4l-8 8",fill:"none",stroke:"var(--actual)","stroke-width":2.6}),seen:()=>ie("rect",{x:3,y:3,width:10,height:10,fill:"none",stroke:"var(--seen)","stroke-width":1.8}),map:()=>ie("g",{},...["little-3","allowed-2","much-1"].map((i,e)=>ie("rect",{x:1+5*e,y:3,width:5,height:10,fill:`var(--${i})`}))),path:()=>ie("path",{d:"M1 11h6l8-6",fill:"none",stroke:"var(--contact)","stroke-width":2.4}),ribbon:()=>ie("g",{class:"w-forces"},...po.map(({colour:i},e)=>ie("rect",{x:1+5*e,y:7-2*e,width:5,height:2+4*e,fill:`var(--${i})`}))),strokes:()=>ie("path",{d:"M1 11h6l8-6",fill:"none",stroke:"var(--stroke)","stroke-width":2}),rejected:()=>ie("path",{d:"M1 11h6l8-6",fill:"none",stroke:"var(--rejected)","stroke-width":1.2}),bases:()=>ie("path",{d:"M14.5 8L9 11.5A4.5 4.5 0 1 1 9 4.5z",fill:"var(--band-6)",stroke:"var(--quiet)","stroke-width":1.2}),force:()=>ie("path",{d:"M8 15V6M8 1l4 6H4z",fill:"var(--force)",stroke:"var(--force)","stroke-width":2}),events:()=>ie("circle",{cx:8,cy:8,r:4.5,fill:"var(--collision)",stroke:"var(--ink)","stroke-width":1.2}),found:()=>ie("path",{d:"M2 12l3-8h9l-3 8z",fill:"var(--found)","fill-opacity":.3,stroke:"var(--found)","stroke-width":2}),actualSurface:()=>ie("path",{d:"M2 12l3-8h9l-3 8z",fill:"none",stroke:"var(--actual)","stroke-width":1.6,"stroke-dasharray":"3 2"}),collision:()=>ie("path",{d:"M5 2h6l3 6-3 6H5L2 8zM5 2l6 12M11 2L5 14",fill:"none",stroke:"var(--quiet)","stroke-width":1}),"by-touch":()=>ie("path",{d:"M8 1v14M5 1h6M5 15h6",fill:"none",stroke:"var(--by-touch)","stroke-width":1.6}),interval:()=>ie("path",{d:"M8 1v14M4 1h8M4 15h8",fill:"none",stroke:"var(--estimated)","stroke-width":2.2}),target:()=>ie("path",{d:"M0 8h16",fill:"none",stroke:"var(--target)","stroke-width":2,"stroke-dasharray":"4 3"}),goal:()=>ie("circle",{cx:8,cy:8,r:5.5,fill:"var(--goal)","fill-opacity":.35,stroke:"var(--goal-line)","stroke-width":1.6})},bo=i=>ie("svg",{viewBox:"0 0 16 16",width:15,height:15,"aria-hidden":"true"},OR[i]?.()),Qy=(i,e)=>ie("svg",{viewBox:"0 0 16 16",width:15,height:15,"aria-hidden":"true"},ie("path",{d:`M8 1l7 7-7 7-7-7z${e?"M8 5l3 3-3 3-3-3z":""}`,"fill-rule":"evenodd",fill:i,stroke:"#000","stroke-width":1.4}));var rm=[1,3,10],ev=[.15,.85],UR=.03,tv=i=>Math.max(0,rm.findLastIndex(e=>i>=e));function FR({cell:i,places:e,expected:t}){let n=pt(e),s=rm.map(()=>"");return t.forEach((r,o)=>{if(!(r>0))return;let a=500*i*Math.sqrt(Math.min(1,r)),[l,c]=[1e3*n[2*o],-1e3*n[2*o+1]];s[tv(r)]+=`M${(l-a).toFixed(1)} ${(c-a).toFixed(1)}h${(2*a).toFixed(1)}v${(2*a).toFixed(1)}h${(-2*a).toFixed(1)}z`}),s.map((r,o)=>ie("path",{d:r,class:`w-density-${o+1}`}))}function nv({cell:i}){let e=t=>{let n=14*Math.sqrt(Math.min(1,t));return ie("svg",{viewBox:"0 0 14 14",width:14,height:14,"aria-hidden":"true"},ie("rect",{x:7-n/2,y:7-n/2,width:n,height:n,class:`w-density-${tv(t)+1}`}))};return _("li",{},`estimate: expected particles per ${Math.round(1e3*i)} mm cell:`,...[.1,.5,...rm].map((t,n,s)=>_("span",{},e(t),`${n===s.length-1?"\u2265\u202F":""}${t}`)))}var Qu=class{element=_("figure",{class:"w-seam"});table=_("div",{class:"w-compared"});share=null;chosen=null;rounds=[];show(e){this.rounds=e.filter(Ju);let t=this.rounds.find(({number:n})=>n===this.chosen)??this.rounds.at(-1);return this.table.replaceChildren(this.makeTable(t)),this.element.replaceChildren(...this.draw(t)),this.element}draw(e){let{interpreted:t,truth:n,number:s}=e,r=_n(e)?e.plan.treatment:null,[o,a,l]=[hi(),hi(),hi()],c=(P,...k)=>ie("g",{"clip-path":`url(#${P})`,class:"w-map"},...k),h=r?null:t.density??null,u=(...P)=>ie("g",{"clip-path":`url(#${o})`},...P),d=r?[c(a,...Ru(r,bn(r,t.treated))),c(l,...Ru(r,bn(r,n.treated)))]:[],f=r?[]:[...h?[]:[{mark:"estimated",places:pt(t.particles)}],{mark:"actual",places:pt(n.particles)}],p=im(e).map(([P,k,O])=>`${P}: ${k} estimated, ${O} true.`),x=`${$n(co(e))} at the end of round ${s}: estimated left of the seam, true right of it. ${p.join(" ")}`,m=Hi(e,f,x,{id:o,map:u(...d)});h&&m.querySelector(".w-dots")?.before(u(c(a,...FR(h)))),m.querySelector(".w-dots-estimated")?.setAttribute("clip-path",`url(#${a})`),m.querySelector(".w-dots-actual")?.setAttribute("clip-path",`url(#${l})`);let[g,y,S,b]=m.getAttribute("viewBox").split(" ").map(Number);this.share??=r?.5:BR(pt(n.particles),g/1e3,S/1e3);let[A,R]=[a,l].map(P=>ie("clipPath",{id:P},ie("rect",{y,height:b}))),v=ie("path",{class:"w-seam-line","vector-effect":"non-scaling-stroke"});m.append(A,R,v);let T=_("input",{type:"range",min:0,max:1,step:.01,"aria-label":"Seam between estimate and truth",input:()=>D(Number(T.value))}),D=P=>{this.share=P;let k=g+P*S;for(let[O,V,I]of[[A,g,k],[R,k,g+S]])O.firstElementChild.setAttribute("x",String(V)),O.firstElementChild.setAttribute("width",String(I-V));v.setAttribute("d",`M${k} ${y}v${b}`),T.setAttribute("aria-valuetext",`${_e(P)} of the width shows the estimate, the rest the truth`)};return this.element.style.setProperty("--ratio",(S/b).toFixed(4)),T.value=String(this.share),D(Number(T.value)),[_("div",{class:"w-seam-picture"},m,T),_("figcaption",{},_("span",{},`\u25C2 Estimated${r?" mean":""}`),_("span",{},"True \u25B8"),this.makeChoice(e))]}makeChoice(e){let t="End of round";return this.rounds.length===1?_("p",{class:"w-rounds"},`${t} ${e.number}`):_("div",{class:"w-rounds",role:"group","aria-label":t},t,...this.rounds.map(({number:n})=>_("button",{type:"button",class:"w-button","aria-pressed":String(n===e.number),click:()=>{this.chosen=n,this.show(this.rounds),this.element.querySelector("[aria-pressed=true]")?.focus()}},String(n))))}makeTable(e){return Jn([`End of round ${e.number}`,"Estimated","True","Off by"],im(e).map(([t,...n])=>Ml(t,n)))}};function BR(i,e,t){let n=Array.from({length:i.length/2},(r,o)=>i[2*o]).sort((r,o)=>r-o),s=n[n.length>>1];return s===void 0?.5:Math.min(ev[1],Math.max(ev[0],(s-e)/t-UR))}var om={believed:"believed before",estimated:"estimated after",actual:"true after",seen:"observed",sample:"estimated after: a typical sample",interval:"90\u202F% interval","by-touch":"from touch only",target:"target",goal:"goal area"},iv=(i,e=om)=>_("ul",{class:"w-legend"},...i.map(t=>_("li",{},bo(t==="sample"?"estimated":t),e[t]))),sv=i=>i.replaceAll(/(?<=\d) %/g,"\u202F%"),zR=6,VR=i=>i===null?"":` Predicted performance: ${_e(i)}.`;function GR(i){let e=_("button",{type:"button",class:"w-button",click:()=>{(navigator.clipboard?navigator.clipboard.writeText(i):Promise.reject()).then(()=>Ve(e,"Copied"),()=>Ve(e,"Not copied"))}},"Copy");return _("div",{class:"w-command"},_("code",{},i),e)}function HR(i){let e=(i.interpreted?.incidents??[]).map(t=>({...t,title:qa(t.title)}));return nm(i)?[...e,{time:null,title:"The ground truth lies outside the interval of the estimate",evidence:`Estimated ${Gt(i.interpreted.estimate,1)}, true ${_e(i.truth.performance,1)}.`,effect:"A correct 90\u202F% interval misses the ground truth in one of ten rounds. The ground truth is known only in simulation.",advice:""}]:e}var _o=class{constructor(e,t,n){this.recording=e;this.seek=t;this.element=_("header",{class:"w-story"},n&&_("div",{class:"w-top"},this.title,this.badge,n),_("div",{class:"w-told"},this.pictures,this.texts,this.incidents)),this.destroy=mu(e,()=>this.show()),this.show()}recording;seek;element;title=_("h1",{});badge=_("p",{class:"w-badge"});pictures=_("div",{class:"w-pictures"});texts=_("div",{class:"w-texts"});seam=new Qu;comparison=_("div",{class:"w-comparison"});incidents=_("section",{class:"w-incidents","aria-label":"Incidents"});destroy;show(){let{head:e,ended:t,rounds:n,stages:s,live:r}=this.recording,o=n.findLast(p=>p.interpreted)??null;Ve(this.title,e?.title||"Recording");let{state:a,text:l}=Nu(this.recording),[c,h]=[a==="planned",a==="logged"];this.badge.dataset.state=a,Ve(this.badge,l);let u=t?.story,d=u?.happened??(r?s.at(-1)?.words??"The run is starting.":o?`The run ended early after round ${o.number}: ${o.interpreted.verdict}.`:c?`Planned, not executed.${VR(n.at(-1).plan.predicted)}`:h?Iu:n.length?"The recording ends before the first round has a result.":"The recording has no rounds."),f=n.map(({number:p,interpreted:x,truth:m})=>[p,x?.estimate,x?.by_touch,m?.performance]);Mn(this.texts,[e?.task,u,r,d,a,f])&&this.texts.replaceChildren(...this.makePart("Task",u?.asked??e?.task?.asked??""),...this.makePart(r?"Now":"Result",d),...this.makePart("Confidence",u?.sure??(o||c||h?"":"No round has a result yet."),this.drawBars()),this.comparison,...this.makePart("More certainty",u?.surer??""),...this.makePart("Next",u?.next?.words??"",u?.next?.command?GR(u.next.command):null)),this.drawPictures(),this.showIncidents()}showIncidents(){let e=this.recording.rounds.flatMap(o=>HR(o).map(a=>({round:o,incident:a}))),t=this.recording.rounds.some(o=>o.interpreted?.incidents),n=e.slice(0,zR),s=e.length-n.length;this.incidents.hidden=!t&&!e.length;let r=[s,n.map(({round:{number:o,start:a},incident:l})=>[o,a,l])];Mn(this.incidents,r)&&this.incidents.replaceChildren(_("h2",{},"What did not go as planned"),...e.length?[_("ul",{},...n.map(({round:o,incident:a})=>this.makeCard(o,a))),...s?[_("p",{class:"w-quiet"},`and ${s} more`)]:[]]:[_("p",{class:"w-quiet"},"Nothing unusual was detected.")])}makeCard(e,{time:t,title:n,evidence:s,effect:r,advice:o}){let a=`Round ${e.number}${t===null?"":` \xB7 ${Je(e.start+t)}`}`;return _("li",{"data-round":e.number},_("button",{type:"button",class:"w-when w-link",title:"Show this time",click:()=>this.seek(e.start+(t??0))},a),_("h3",{},n),...[s,r].filter(l=>l).map(l=>_("p",{},sv(l))),o?_("p",{class:"w-advice"},o):null)}makePart(e,t,n=null){let s=[...t?[_("p",{},sv(t))]:[],...n?[n]:[]];return s.length?[_("h2",{},e),...s]:[]}drawPictures(){let{rounds:e,before:t}=this.recording,n=e[0],s=e.findLast(a=>a.interpreted??a.truth)??null,r=e.map(({plan:a,interpreted:l,truth:c,observed:h})=>[a.round,a.predicted,a.duration,!!l,!!c,!!h]);if(!Mn(this.pictures,[r,!!t.observed]))return;let o=s&&Ju(s)?this.seam.show(e):null;this.comparison.replaceChildren(...o?this.makePart("Ground truth","",this.seam.table):[]),this.pictures.toggleAttribute("data-maps",!!(n&&_n(n))),this.pictures.replaceChildren(...n?_n(n)?ty(this.recording,o):this.makeDirtFigures(n,s,o):[])}makeDirtFigures(e,t,n){let{surface:s,kind:r,goal:o}=e.plan,a=(m,g)=>g?[{mark:m,places:pt(g)}]:[],l=(m,g,y)=>tr(Hi(g,y,`${m}: ${co(g)} with ${y.map(({places:S,mark:b})=>`${S.length/2} particles ${om[b]}`).join(", ")}`),s.shape?`${m}, surface unrolled`:m),c=[{mark:"believed",places:e.particles.first},...a("seen",this.recording.before.observed?.detections)],h=t?[...a("estimated",t.interpreted?.particles),...a("actual",t.truth?.particles),...a("seen",t.observed?.detections)]:r==="planned"?[{mark:"believed",places:e.particles.last}]:[],u=n??(t?l(`After ${t.number} ${t.number===1?"round":"rounds"}`,t,h):h.length?l("Predicted",e,h):null),d=n&&t?.interpreted?.density,f=n?d?["actual"]:["sample","actual"]:h.map(({mark:m})=>m),p=iv([...new Set([...c.map(({mark:m})=>m),...f]),...o?.kind==="collected"?["goal"]:[]]);d&&p.append(nv(d));let x=ie("svg",{viewBox:"0 0 24 24",class:"w-arrow","aria-hidden":"true"},ie("path",{d:"M3 12h16M13 6l6 6-6 6"}));return[l(u?"Before":"Believed before",e,c),...u?[x,u]:[],p]}drawBars(){let{rounds:e,head:t}=this.recording,n=e.filter(h=>h.interpreted).slice(-8);if(!n.length)return null;let s=t?.task?.target??null,r=({estimate:h,by_touch:u})=>u.low!==h.low||u.high!==h.high,o=n.map(({number:h,interpreted:u,truth:d})=>{let{estimate:f,by_touch:p}=u,x=d?.performance??null,m=b=>`${(1.5+97*Math.min(1,Math.max(0,b))).toFixed(2)}%`,g=(b,A)=>`${Math.max(.6,97*(Math.min(1,A)-Math.max(0,b))).toFixed(2)}%`,y=(b,A,R,v)=>ie("line",{x1:m(b),x2:m(b),y1:A,y2:R,...v}),S=`Round ${h}: estimated ${_e(f.mean)}, 90 % interval ${_e(f.low)} to ${_e(f.high)}; from touch only ${Gt(p)}${x===null?"":`; true ${_e(x)}`}${s===null?"":`; target ${_e(s)}`}`;return _("div",{class:"w-bar"},_("span",{},`Round ${h}`),ie("svg",{role:"img","aria-label":S},ie("rect",{x:m(0),y:8,width:"97%",height:10,rx:5,fill:"var(--lane)"}),r(u)&&ie("rect",{x:m(p.low),y:21.5,width:g(p.low,p.high),height:2,fill:"var(--by-touch)"}),ie("rect",{x:m(f.low),y:6,width:g(f.low,f.high),height:14,rx:4,fill:"var(--estimated)","fill-opacity":.35,stroke:"var(--estimated)","stroke-width":1.6}),y(f.mean,4,22,{stroke:"var(--estimated)","stroke-width":3}),s!==null&&y(s,0,26,{stroke:"var(--target)","stroke-width":2,"stroke-dasharray":"4 3"}),x!==null&&ie("svg",{x:m(x),y:13,overflow:"visible"},ie("path",{d:"M-5 -5L5 5M5 -5L-5 5",stroke:"var(--actual)","stroke-width":2.6,fill:"none"}))),_("b",{},_e(f.mean)))}),a=n.some(({truth:h})=>typeof h?.performance=="number"),l={...om,actual:"true",target:`target ${_e(s??NaN)}`},c=n.some(h=>r(h.interpreted));return _("div",{class:"w-bars"},...o,iv(["interval",...c?["by-touch"]:[],...a?["actual"]:[],...s===null?[]:["target"]],l))}};var ov=["video/webm;codecs=vp8","video/webm"],WR=5e6,$R=1500,XR=100,qR=3.1,YR=.05,ed=34,rv=15;function ZR(){return typeof MediaRecorder>"u"||!("captureStream"in HTMLCanvasElement.prototype)?"This browser cannot record video: it has no MediaRecorder for a canvas.":ov.some(i=>MediaRecorder.isTypeSupported(i))?null:"This browser cannot record WebM video."}var am=class{constructor(e,t,n,s,r,o){this.stage=e;this.recording=t;this.clock=n;this.from=s;this.to=r;this.speed=o;let{clientWidth:a,clientHeight:l}=e.canvas,c=u=>2*Math.round(u*this.ratio/2);Object.assign(this.canvas,{width:c(a),height:c(l+2*ed)});let h=this.canvas.captureStream(0);this.track=h.getVideoTracks()[0],this.recorder=new MediaRecorder(h,{mimeType:ov.find(u=>MediaRecorder.isTypeSupported(u)),videoBitsPerSecond:WR}),this.recorder.addEventListener("dataavailable",({data:u})=>this.chunks.push(u))}stage;recording;clock;from;to;speed;canvas=_("canvas");pen=this.canvas.getContext("2d");ratio=Math.min(2,devicePixelRatio||1);chunks=[];recorder;track;begun=0;isRunning=!1;start(e){this.recorder.addEventListener("start",()=>{this.begun=performance.now(),this.isRunning=!0,e()}),this.recorder.start(1e3),this.draw()}draw(){let{canvas:e,pen:t,clock:n,recording:s,ratio:r}=this,o=s.at(n.time),a=ed*r;t.fillStyle=De("scene"),t.fillRect(0,0,e.width,e.height),t.drawImage(this.stage.canvas,0,a,e.width,e.height-2*a);let l=s.resultAt(n.time)?.interpreted,c=l?`Estimated ${Gt(l.estimate)}`:typeof o?.performance=="number"?`Predicted ${_e(o.performance)}`:"",h=`${Je(n.time)} / ${Je(n.duration)}${this.speed===1?"":` \xB7 ${this.speed}\xD7`}`;this.write(0,s.head?.title||"Recording",h),this.write(e.height-a,o?`Round ${o.round.number} of ${s.rounds.length} \xB7 ${Op(s,o)}`:"",c),this.track.requestFrame()}write(e,t,n){let{canvas:s,pen:r,ratio:o}=this,[a,l]=[12*o,e+(ed/2+.36*rv)*o];r.fillStyle=De("paper"),r.fillRect(0,e,s.width,ed*o),r.fillStyle=De("ink"),r.font=`600 ${rv*o}px system-ui, sans-serif`;let c=Math.min(r.measureText(n).width,s.width/2);r.fillText(n,s.width-a-c,l,c),r.fillText(t,a,l,s.width-c-3*a)}async finish(){let e=(performance.now()-this.begun)/1e3;this.pen.fillStyle=De("paper");for(let t=performance.now()+$R;performance.now()<t;)await new Promise(n=>setTimeout(()=>requestAnimationFrame(n),XR)),this.pen.fillRect(0,0,1,1),this.track.requestFrame();return await this.stop(),{clip:new Blob(this.chunks,{type:"video/webm"}),took:e}}stop(){if(this.recorder.state==="inactive")return Promise.resolve();let e=new Promise(t=>this.recorder.addEventListener("stop",()=>{this.track.stop(),t()}));return this.recorder.stop(),e}},jR=5e-7;function av(i,e,t){let n=ZR(),s=null,r=0,o=_("select",{class:"w-select","aria-label":"Part of the run"}),a=_("button",{class:"w-button",type:"button",click:()=>f()}),l=_("button",{class:"w-button",type:"button",hidden:!0,click:()=>d("The recording was cancelled.")},"Cancel"),c=_("progress",{max:1,value:0,hidden:!0,"aria-label":"Progress of the recording"}),h=_("p",{role:"status"},n??"The clip shows the current view, with title, clock and result."),u=_("a",{class:"w-button",hidden:!0},"Save the clip");a.disabled=n!==null;let d=y=>{s?.stop(),s=null,i.onDrawn=null;for(let S of[l,c])S.hidden=!0;Ve(h,y),t.playing&&t.pause(),g()},f=()=>{let y=e.rounds[Number(o.value)-1],[S,b]=y?[y.start,Math.min(y.end-(y===e.rounds.at(-1)?0:jR),t.end)]:[0,t.end];if(!(b>S))return d("Nothing to record: this part takes no time.");let A=Math.max(1,t.speed);t.pause(),t.setSpeed(A),t.seek(S);try{s=new am(i,e,t,S,b,A)}catch(v){return d(`The recording cannot start: ${v.message}`)}for(let v of[l,c])v.hidden=!1;u.hidden=!0,Ve(h,`Recording ${Je(b-S,0)} at ${A}\xD7.`);let R=s;r=S,i.onDrawn=()=>{i.onDrawn=()=>R.draw(),R.start(()=>{s===R&&t.play()})},i.ask(),g()},p=async y=>{y.isRunning=!1,t.pause(),t.seek(y.to);let{clip:S,took:b}=await y.finish();if(s!==y)return;let A=(y.to-y.from)/y.speed,R=Math.abs(b-A)<=YR*A+.2;URL.revokeObjectURL(u.href),Object.assign(u,{href:URL.createObjectURL(S),hidden:!1,download:`${(e.head?.title||"recording").replace(/[^\p{L}\p{N}]+/gu,"-")}.webm`}),d(`${Je(b)} at ${y.speed}\xD7, ${(S.size/1e6).toFixed(1)} MB.${R?"":` The clip is not of this speed: it should take ${Je(A)}. This machine draws too slowly.`}`)},x=t.subscribe(()=>{if(!s?.isRunning)return;let{from:y,to:S,speed:b}=s,A=t.time-r;r=t.time,c.value=(t.time-y)/(S-y),t.time>=S-1e-6?p(s):(!t.playing||t.speed!==b||A<0||A>qR*b)&&d("The recording was cancelled, because the clock was changed.")}),m=()=>{document.hidden&&s&&d("The recording was cancelled, because the page was hidden.")};document.addEventListener("visibilitychange",m);let g=()=>{let{rounds:y,live:S}=e;if(o.length!==y.length+1){let b=o.value;o.replaceChildren(_("option",{value:0},"Whole run"),...y.map(({number:A},R)=>_("option",{value:R+1},`Round ${A}`))),b&&(o.value=b)}a.disabled=n!==null||S||s!==null||!y.length,S&&!n&&Ve(h,"A live run can be recorded once it has ended."),Ve(a,`Record at ${Math.max(1,t.speed)}\xD7`)};return g(),{element:_("details",{class:"w-film",name:"w-menu"},_("summary",{},"Film"),_("div",{},o,a,l,c,u,h)),show:g,destroy:()=>{document.removeEventListener("visibilitychange",m),x(),s&&d(""),URL.revokeObjectURL(u.href)}}}var lv=[["Space","play, pause"],["\u2190 \u2192","0.1 s back, forward (with Shift: 1 s)"],["[ ]","previous, next event or stroke"],["Home End","start, end"],["+ \u2212","faster, slower"],["L","follow a live run"],["F","fit view"],["T","follow the work: wide in free motion, close at strokes"],["V","view from above"],["W A S D","turn the scene (while it has the focus)"],["Z X","zoom in, out (while the scene has the focus)"],["I O","start (I) or end (O) the selected part of the path at the shown time (or drag on the plot of forces)"],["Esc","end the selection; close a menu"]];function nd(i,e,t){return(t>0?i.find(s=>s>e+.05):i.findLast(s=>s<e-.05))??(t>0?i.at(-1)??e:i[0]??e)}var td=[],KR=(i,e)=>!(i instanceof HTMLElement)||e==="Escape"?!1:i.isContentEditable||/^(TEXTAREA|SELECT)$/.test(i.tagName)?!0:i instanceof HTMLInputElement&&i.type==="range"?/^(Arrow|Page|Home$|End$)/.test(e):i instanceof HTMLInputElement?!(i.type==="checkbox"&&e!==" "):e===" "&&/^(BUTTON|A|SUMMARY)$/.test(i.tagName);function cv(i,e,t,n){td.push(i);let s=a=>{e.playing&&e.pause(),e.seek(e.time+a)},r={...n," ":()=>e.toggle(),ArrowLeft:a=>s(a?-1:-.1),ArrowRight:a=>s(a?1:.1),"[":()=>e.seek(nd(t.stops,e.time,-1)),"]":()=>e.seek(nd(t.stops,e.time,1)),Home:()=>e.seek(0),End:()=>e.seek(e.end),"+":()=>e.faster(1),"=":()=>e.faster(1),"-":()=>e.faster(-1)},o=a=>{if(a.ctrlKey||a.metaKey||a.altKey||a.defaultPrevented||KR(a.target,a.key))return;let l=a.target,c=l===document.body||l===document.documentElement;if(!i.contains(l)&&!(c&&td[0]===i))return;let h=r[a.key]??r[a.key.toLowerCase()];h&&h(a.shiftKey)!==!1&&a.preventDefault()};return document.addEventListener("keydown",o),()=>{document.removeEventListener("keydown",o),td.splice(td.indexOf(i),1)}}var hv={believed:["Believed and predicted dirt",({rounds:i})=>i.some(e=>_n(e)?e.treated!==null:e.plan.particles.length>0)],estimated:["Estimated dirt after the round",({rounds:i})=>i.some(e=>(_n(e)?e.interpreted?.treated:e.interpreted)!=null)],actual:["True dirt after the round",({rounds:i})=>i.some(e=>(_n(e)?e.truth?.treated:e.truth?.particles)!=null)],seen:["Observed dirt",({rounds:i,before:e})=>e.observed??i.some(({observed:t})=>t)],path:["Tool path",({rounds:i})=>i.some(({count:e})=>e)],ribbon:["Force along the path",({rounds:i})=>i.some(({count:e})=>e)],strokes:["Planned strokes",({rounds:i})=>i.some(({plan:e})=>e.strokes.length)],rejected:["Rejected plan, chosen in its table",({rounds:i})=>i.some(({plan:e})=>e.another||e.considered?.some(({lines:t})=>t?.length))],bases:["Rated base poses",({rounds:i})=>i.some(({plan:e})=>e.bases?.poses.length)],force:["Force",({rounds:i})=>i.some(({count:e})=>e)],events:["Events, force at pushes or collisions",({happenings:i})=>i.length],found:["Surface found by touch",({rounds:i})=>i.some(({interpreted:e})=>e?.found)],actualSurface:["True surface",({rounds:i})=>i.some(({truth:e})=>e?.surface)],collision:["Collision shapes",({head:i})=>i?.robot?.links.some(e=>$p(e).length)]},id=24,sd=class{constructor(e,t,n){this.recording=e;let s=_("canvas",{class:"w-canvas",tabindex:0,role:"application","aria-label":"Robot, tool and surface in 3-D. W A S D turn the scene, Z and X zoom."});this.stage=JR(s,e,()=>this.follow.setAttribute("aria-pressed","false"));let r=(f,p,x)=>_("button",{class:"w-button",type:"button",title:p,click:x},f);this.follow=r("Follow","Follow the work: wide in free motion, close at strokes  T",()=>this.toggleFollow()),this.follow.setAttribute("aria-pressed","false");let o=_("input",{type:"range",min:0,max:.95,step:.05,value:0,"aria-label":"Transparency of the robot",input:()=>{this.stage&&(this.stage.xray=Number(o.value))}}),a=_("div",{class:"w-views",role:"group","aria-label":"View"},r("Fit","Show all of robot and surface  F",()=>this.look("all")),r("Surface","Close view of the surface",()=>this.look("surface")),r("Above","View from above  V",()=>this.look("above")),this.follow,_("label",{class:"w-button w-xray",title:"Look through the robot"},"X-ray",o));if(this.element=_("section",{class:"w-scene","aria-label":"Scene"},this.stage?s:_("p",{class:"w-none"},"This browser cannot draw 3-D graphics. The other panels still work."),this.stage&&a,this.stage&&this.legend(t),_("div",{class:"w-scene-scale"},this.forceScale,this.reach,this.mapScale),this.extra,this.point,this.still),!this.stage)return;let{stage:l}=this,c=!1,h=()=>{let{clientWidth:f,clientHeight:p}=s,x=this.element.querySelector(".w-layers");!c&&f&&f<=640&&x&&(x.open=!1),c||=f>0,l.resize(f,p,x?.open&&f>640?x.offsetWidth:0)},u=new ResizeObserver(h);u.observe(s),this.element.addEventListener("toggle",h,!0);let d={x:0,y:0};s.addEventListener("pointerdown",({offsetX:f,offsetY:p})=>{d={x:f,y:p}}),s.addEventListener("click",({offsetX:f,offsetY:p})=>{if(Math.hypot(f-d.x,p-d.y)>3)return;let x=l.timeAt(f,p);x!==null&&n(x)}),s.addEventListener("pointermove",({offsetX:f,offsetY:p,buttons:x})=>this.explain(x?null:[f,p])),s.addEventListener("pointerleave",()=>this.explain(null)),this.stop.push(()=>u.disconnect(),to(()=>{l.paint(),this.listNamed(),no()&&(this.still.src=l.picture())}))}recording;element;stage;boxes=new Map;extra=_("ul",{class:"w-named"});follow;still=_("img",{class:"w-still",alt:"The robot and the surface at the shown time"});stop=[];mapTitle=_("strong");mapScale=_("div",{class:"w-map-scale",hidden:!0},this.mapTitle);forceTitle=_("strong");forceScale=_("div",{class:"w-force-scale",hidden:!0},this.forceTitle,or(po));point=_("div",{class:"w-point",hidden:!0});reach=Ty();shown=nr;choice=null;scaleOf=null;treats=!1;version=-1;time=0;show(e){if(this.stage?.show(e),this.time=e,this.showScale(),this.version===this.recording.version)return;this.version=this.recording.version;let{rounds:t,head:n}=this.recording,s=n?.robot;s&&Wp(s)&&this.boxes.get("collision")?.querySelector("label").replaceChildren(bo("collision"),"Collision shapes (the robot's shell is drawn from them)");let r=t.find(_n);this.stage&&r&&!this.treats&&this.nameMaps(r),this.element.toggleAttribute("data-target",t.some(({target:a})=>a!==null));for(let[a,l]of this.boxes)l.hidden=!hv[a][1](this.recording);let o=this.element.querySelector(".w-layers");o&&(o.hidden=[...this.boxes.values()].every(({hidden:a})=>a))}explain(e){let t=e&&this.stage.timeAt(...e),n=t===null?null:this.recording.at(t);if(this.point.hidden=n?.normal==null,!e||n?.normal==null)return;let{normal:s,height:r,round:o}=n,a=o.isPressed(n.time)?o.target:null;Ve(this.point,[`${Fe(s,1)} N${a===null?"":`, ${_e(s/a)} of the target of ${Fe(a,1)} N`}`,r===null?"":`tool height ${dl(n)}`,`${Je(t,2)} (click to go there)`].filter(f=>f).join(`
`));let[l,c]=e,{offsetWidth:h,offsetHeight:u}=this.point,d=l+h+id>this.element.clientWidth;Object.assign(this.point.style,{left:`${d?l-h-id:l+id}px`,top:`${Math.max(2,c-u-id)}px`})}showScale(){let e=this.stage&&this.recording.roundAt(this.time);this.forceScale.hidden=!e?.target||!e.count||!this.stage.layers.ribbon,e?.target&&Ve(this.forceTitle,`Force along the path, target ${Fe(e.target,1)}\u202FN`);let t=e&&ou(this.recording,this.time,e,this.stage.layers);this.reach.hidden=!e?.plan.bases||!this.stage.layers.bases,this.mapScale.hidden=!t,t&&(Ve(this.mapTitle,t.title),this.scaleOf!==t.record&&(this.scaleOf=t.record,this.mapScale.replaceChildren(this.mapTitle,hl(t.record))))}nameMaps(e){this.treats=!0;let t=Mi(e),n={believed:`Predicted ${t}`,estimated:`Estimated ${t} after the round`,actual:`True ${t} after the round`};for(let[s,r]of Object.entries(n))this.boxes.get(s)?.querySelector("label").replaceChildren(bo("map"),r);for(let s of["actual","ribbon"])this.stage.layers[s]=!1,this.boxes.get(s).querySelector("input").checked=!1}look(e){this.follow.setAttribute("aria-pressed","false"),this.stage?.look(e)}toggleFollow(){this.stage&&(this.stage.follow=!this.stage.follow,this.follow.setAttribute("aria-pressed",String(this.stage.follow)))}showData(e){this.shown=e,this.stage?.showData(e),this.listNamed()}get queried(){let{trajectories:e,ghosts:t,frames:n,particles:s}=this.shown;return[...e.map(({name:r,color:o},a)=>({name:r,colour:fu(o,a)})),...t.map(({time:r,color:o})=>({name:`${this.recording.head?.robot?"robot":"tool"} at ${Je(r)}`,colour:ys(o,De("ghost"))})),...n.map(({name:r,color:o})=>({name:r,colour:ys(o,De("axis-z"))})),...s.map(({name:r,color:o,state:a})=>({name:r,colour:mp(o),form:a}))]}choose(e){this.choice=e,this.stage?.choose(e),this.listNamed()}listNamed(){let{stroke:e=null,rejected:t=null}=this.choice??{},n=[...e===null?[]:[{name:`Stroke ${e+1}`,colour:"var(--chosen)"}],...t&&this.stage?.layers.rejected?[{name:t.name,colour:"var(--rejected)"}]:[]];this.extra.replaceChildren(...[...n,...this.queried].map(({name:s,colour:r,form:o})=>{if(o)return _("li",{},Qy(r,o==="estimated"),s);let a=_("i",{"aria-hidden":"true"});return a.style.background=r,_("li",{},a,s)}))}destroy(){for(let e of this.stop)e();this.stage?.destroy()}legend(e){let t=Object.keys(Zu).map(n=>{let s=hi(),r=_("input",{type:"checkbox",id:s,checked:Zu[n],change:()=>{this.stage&&(this.stage.layers[n]=r.checked,this.stage.ask(),this.showScale(),this.listNamed())}}),o=_("li",{},r,_("label",{for:s},bo(n),hv[n][0]));return this.boxes.set(n,o),o});return _("details",{class:"w-layers",open:!e},_("summary",{},"Layers"),_("ul",{},...t))}};function JR(i,e,t){try{return new Yu(i,e,t)}catch{return null}}var QR=170,lm=15,uv=8,cm=3,eC=3;function tC(i,e,t){let n=({label:l,count:c})=>Math.min(QR,e(dv(l,c))),s=[],r=new Map;for(let{x:l,label:c}of[...i].sort((h,u)=>h.x-u.x)){let h=r.get(c);if(h&&l<h.x+n(h)+uv){h.count++;continue}let u={x:l,label:c,count:1};s.push(u),r.set(c,u)}let o=Array.from({length:eC},()=>-1/0),a=[];for(let l of s){let c=n(l),h=Math.min(l.x,t-c),u=o.findIndex(d=>d+uv<=h);u<0||(o[u]=h+c,a.push({text:dv(l.label,l.count),x:h,width:c,row:u}))}return a}var dv=(i,e)=>e>1?`${i} \xD7${e}`:i;function fv(i,e,t){let n=e.lane("rounds")?.top??0,s=e.width-e.right,r=[];i.fillStyle=De("highlight");for(let{start:a,end:l,label:c}of t){if(l<e.from||a>e.to)continue;let h=Math.max(e.left,e.x(a)),u=Math.max(h+2,Math.min(s,e.x(l)));i.globalAlpha=.28,i.fillRect(h,n,u-h,e.height-n),i.globalAlpha=1,i.fillRect(h,n-3,u-h,3),c&&r.push({x:h+cm,label:c})}let o={size:10,weight:600,name:"ink"};il(i,o);for(let{text:a,x:l,width:c,row:h}of tC(r,u=>i.measureText(u).width,s)){let u=e.height-4-(h+.5)*lm;i.globalAlpha=.85,i.fillStyle=De("paper"),i.beginPath(),i.roundRect(l-cm,u-lm/2+1,c+2*cm,lm-2,3),i.fill(),i.globalAlpha=1,An(i,a,l,u+.5,{...o,room:c+1})}}function pv(i,e,{top:t,height:n},[s,r],o){if(r<e.from||s>e.to)return;let a=e.width-e.right,[l,c]=[s,r].map(h=>Math.min(a,Math.max(e.left,e.x(h))));i.globalAlpha=.65,li(i,"paper",e.left,t-2,l-e.left,n+4),li(i,"paper",c,t-2,a-c,n+4),i.globalAlpha=1,i.strokeStyle=De("accent"),i.lineWidth=1.5,i.strokeRect(l,t-1,c-l,n+2),An(i,o,l+5,t+7,{size:10,name:"ink",room:c-l-10})}function mv(i,e,t,n,s,r,o){let a=l=>t.top+t.height-(l-n)/(s-n)*t.height;for(let l of Dx(n,s,r))hn(i,e.left,a(l),e.width-e.right,a(l),Math.abs(l)<1e-12?"rule":"grid"),An(i,o(l),e.left-5,Math.min(Math.max(a(l),t.top+4),t.top+t.height-3),{size:10,align:"right"});return a}var gv=(i,{top:e,height:t})=>[i.left-1,e-2,i.span+2,t+4];function hm(i,e,t,n,s,r){let[o,a]=[0,r.least];for(let u of n.rounds){let{least:d,largest:f}=s(u);d<=f&&([o,a]=[Math.min(o,d*r.unit),Math.max(a,f*r.unit,r.target?.(u)??0)])}r.bounds&&([o,a]=[Math.max(o,r.bounds[0]),Math.min(a,r.bounds[1])]);let l=.06*(a-o),c=mv(i,e,t,o<0?o-l:0,a+l,3,u=>String(Number(u.toPrecision(3))).replace("-","\u2212")),h=null;sl(i,gv(e,t),()=>{for(let u of n.rounds){if(u.end<e.from||u.start>e.to||!u.count)continue;i.strokeStyle=De(r.name),i.lineWidth=1.5,i.lineJoin="round";let d=u.count*((e.to-e.from)/Math.max(u.length,1e-9))>4*e.span;xv(i,(d?iC:nC)(e,u,s(u),p=>c(p*r.unit)));let f=r.target?.(u)??null;f!==null&&vv(i,[Math.max(e.left,e.x(u.start)),e.x(u.end)],c(f),e.narrow||f===h?"":`target ${Fe(f,1)}\u202FN`,!0),h=f}})}function xv(i,e){i.beginPath(),e.forEach((t,n)=>{t&&(e[n-1]?i.lineTo(...t):i.moveTo(...t))}),i.stroke()}function nC(i,e,{data:t},n){let s=e.place(i.from-e.start)[0],r=Math.min(e.count,e.place(i.to-e.start)[0]+2);return t.slice(s,r).map((o,a)=>Number.isFinite(o)?[i.x(e.start+e.t[s+a]),n(o)]:null)}function iC(i,e,t,n){let s=[],r=Math.min(i.width-i.right,i.x(e.start+e.t.at(-1)));for(let o=Math.max(Math.floor(i.left),Math.floor(i.x(e.start)));o<=r;o++){let[a,l]=[o,o+1].map(d=>e.place(i.t(d)-e.start)[0]),c=t.range(a,Math.max(l,a+1)+1),[h,u]=c?[n(c[1]),n(c[0])]:[];s.push(...c?[[o,u],[o,Math.min(h,u-.7)]]:[null])}return s}var sC=14;function yv(i,e,t,n){let s=mv(i,e,t,0,1,2,a=>Fe(100*a,0)),r=n.head?.task?.target,o=e.width-e.right;sl(i,gv(e,t),()=>{r!==void 0&&vv(i,[e.left,o],s(r),`target ${_e(r)}`,r<=.8);for(let a of n.rounds)a.end<e.from||a.start>e.to||rC(i,e,a,s)}),n.rounds.forEach((a,l)=>{if(!a.interpreted||a.end>e.to+1e-9)return;let c=oC(e,a,n.rounds[l+1]);c&&aC(i,c,a.interpreted.estimate,s),a.end>=e.from&&lC(i,e,a,s)})}function vv(i,[e,t],n,s,r){i.setLineDash([6,4]),hn(i,e,n,t,n,"target",1.5),i.setLineDash([]),An(i,s,e+5,n+(r?-2:3),{size:10,base:r?"bottom":"top",name:"target",halo:!0})}function rC(i,e,t,n){let s=t.plan.growth;s.length&&(i.strokeStyle=De("believed"),i.lineWidth=2.2,i.lineCap="round",i.setLineDash(Ix),xv(i,[...s,[1/0,s.at(-1)[1]]].map(([r,o])=>[e.x(t.start+Math.min(r,t.length)),n(o)])),i.setLineDash([]),i.lineCap="butt")}function oC(i,e,t){let n=i.x(e.end),s=t?i.x(t.start+t.firstContact):0,[r,o]=[Math.max(n,i.left),Math.min(Math.max(n+sC,s),i.width-4)];return o>r?[r,o]:null}function aC(i,[e,t],{mean:n,low:s,high:r},o){li(i,"interval",e,o(r),t-e,Math.max(1,o(s)-o(r)));for(let a of[s,r])hn(i,e,o(a),t,o(a),"estimated",1);hn(i,e,o(n),t,o(n),"estimated",2.4)}function lC(i,e,t,n){let{estimate:s,by_touch:r}=t.interpreted,o=e.x(t.end),a=t.growthAt(t.length);a!==null&&cC(i,o,n(a),n(s.mean)),(r.low!==s.low||r.high!==s.high)&&hC(i,o-13,n,r);let l=t.truth?.performance??null;if(l===null)return;let c=n(l);for(let[h,u]of[[5,"paper"],[2.4,"actual"]])hn(i,o+3,c-4.5,o+12,c+4.5,u,h),hn(i,o+12,c-4.5,o+3,c+4.5,u,h)}function cC(i,e,t,n){if(hn(i,e,t,e,n,"ink",1.4),Math.abs(n-t)<8)return;let s=6*Math.sign(t-n);hn(i,e-3.5,n+s,e,n,"ink",1.4),hn(i,e+3.5,n+s,e,n,"ink",1.4)}function hC(i,e,t,{mean:n,low:s,high:r}){hn(i,e,t(s),e,t(r),"by-touch",1.4);for(let o of[s,r])hn(i,e-3,t(o),e+3,t(o),"by-touch",1.4);li(i,"by-touch",e-2.2,t(n)-2.2,4.4,4.4)}function bv(i,e){let t=new Map,n=!1,s=null,r=l=>{let{left:c,width:h}=i.getBoundingClientRect();return(l.clientX-c)*(i.clientWidth/h||1)},o=()=>{let[l=0,c=0]=[...t.values()];return{middle:(l+c)/2,distance:Math.max(10,Math.abs(l-c))}};i.addEventListener("pointerdown",l=>{if(!(l.button!==0||l.target instanceof HTMLButtonElement))if(t.set(l.pointerId,r(l)),i.setPointerCapture(l.pointerId),i.focus({preventScroll:!0}),t.size===1){n=!1;let{top:c,height:h}=i.getBoundingClientRect();s=l.pointerType!=="touch"&&e.selectsAt((l.clientY-c)*(i.clientHeight/h||1))?r(l):null,e.select(null),e.seek(r(l))}else n=!0}),i.addEventListener("pointermove",l=>{if(!t.has(l.pointerId)){e.hover(r(l));return}let c=o();if(t.set(l.pointerId,r(l)),t.size===2){let h=o();e.zoom(c.middle,c.distance/h.distance,h.middle-c.middle)}else n||(s===null?e.seek(r(l)):Math.abs(r(l)-s)>4&&e.select([s,r(l)]),e.hover(r(l)))});let a=l=>{t.delete(l.pointerId),l.pointerType!=="mouse"&&e.hover(null)};i.addEventListener("pointerup",a),i.addEventListener("pointercancel",a),i.addEventListener("pointerleave",()=>e.hover(null)),i.addEventListener("dblclick",()=>e.reset()),i.addEventListener("wheel",l=>{let{scrollHeight:c,clientHeight:h}=document.documentElement,u=Math.abs(l.deltaX)>Math.abs(l.deltaY)||l.shiftKey;if(!(l.ctrlKey||u||i.contains(document.activeElement)||c<=h+1))return;l.preventDefault();let f=l.shiftKey&&!l.deltaX?l.deltaY:u?l.deltaX:l.deltaY;u?e.zoom(r(l),1,-f):e.zoom(r(l),Math.exp(Math.max(-1,Math.min(1,f*.002))),0)},{passive:!1})}var uC=[-20,80],Sv={axis:uy,rounds:dy,phases:fy,contact:py,events:my,force:(...i)=>hm(...i,e=>e.normal,{name:"force",unit:1,least:5,target:e=>e.target}),height:(...i)=>hm(...i,e=>e.height,{name:"height",unit:1e3,least:10,bounds:uC}),performance:yv},Tv=Object.keys(Sv),dC=Tv.slice(0,-2),fC=700,_v=700,wv={card:60,software:250},Mv=.2,rd=class{constructor(e,t,n,s){this.recording=e;this.clock=t;this.selected=s;this.frame=new au(n?dC:Tv),this.element=_("div",{class:"w-timeline",role:"slider",tabindex:0,"aria-label":"Time in the run","aria-valuemin":0,"aria-describedby":this.description.id,"aria-keyshortcuts":"Space ArrowLeft ArrowRight [ ] Home End I O Escape"},this.base,this.veil,this.hair,this.cursor,this.whole,this.tip,this.description),bv(this.element,{seek:a=>{t.playing&&t.pause(),t.seek(this.timeAt(a))},selectsAt:a=>{let l=this.frame.lane("force");return l!==void 0&&a>=l.top&&a<=l.top+l.height},select:a=>this.select(a&&[this.timeAt(Math.min(...a)),this.timeAt(Math.max(...a))]),hover:a=>this.hover(a),zoom:(a,l,c)=>this.zoom(a,l,c),reset:()=>this.reset()});let r=new ResizeObserver(()=>this.resize());r.observe(this.element),requestAnimationFrame(()=>{let a=this.element.closest(".w-view");a&&r.observe(a)});let o=ao(er()?wv.software:wv.card,()=>this.redraw());this.stop.push(()=>r.disconnect(),o.stop,t.subscribe(()=>this.ask()),e.onChange(()=>e.live?o.ask():this.redraw()),to(()=>this.resize()))}recording;clock;selected;element;base=_("canvas",{"aria-hidden":"true"});cursor=_("i",{class:"w-cursor","aria-hidden":"true"});hair=_("i",{class:"w-hair","aria-hidden":"true",hidden:!0});veil=_("i",{class:"w-veil","aria-hidden":"true",hidden:!0});whole=_("button",{class:"w-button w-whole",type:"button",hidden:!0,title:"Show the whole run  (double-click)",click:()=>this.reset()},"Whole run");tip=_("div",{class:"w-tip",hidden:!0});description=_("p",{class:"w-hidden",id:hi()});frame;stop=[];highlights=[];selection=null;zoomed=!1;moved=()=>this.draw();stale=!0;drawnDuration=-1;hovered=null;highlight(e){this.highlights=e,this.redraw()}timeAt(e){return this.frame.t(Math.min(Math.max(e,this.frame.left),this.frame.width-this.frame.right))}select(e){return!e&&!this.selection?!1:(this.selection=e,this.selected(e),this.redraw(),!0)}selectTo(e){let{time:t,duration:n}=this.clock,[s,r]=this.selection??[0,n],o=e?[s<t?s:0,t]:[t,r>t?r:n];o[0]<o[1]&&this.select(o)}redraw(){this.stale=!0,this.ask()}destroy(){Rn.drop(this.moved);for(let e of this.stop)e()}ask(){Rn.draw(this.moved)}resize(){let e=no()?fC:this.element.clientWidth;if(!e)return;this.frame.layOut(e,no()||(this.element.closest(".w-view")?.clientHeight??_v)<_v);let t=this.element.currentCSSZoom??1,n=no()?3:Math.min((devicePixelRatio||1)*t,2);Object.assign(this.base,{width:Math.round(e*n),height:Math.round(this.frame.height*n)}),Object.assign(this.base.style,{width:`${e}px`,height:`${this.frame.height}px`}),this.element.style.height=this.base.style.height,this.stale=!0,Rn.drop(this.moved),this.draw()}reset(){this.zoomed=!1,this.redraw()}zoom(e,t,n){let{frame:s}=this,r=Math.max(this.clock.duration,Mv),o=s.t(e),a=Math.min(r,Math.max(Mv,(s.to-s.from)*t)),l=(o-s.from)/(s.to-s.from),c=o-l*a-n/s.span*a;c=Math.min(Math.max(0,c),r-a),[s.from,s.to]=[c,c+a],this.zoomed=a<r*.999,this.redraw()}pen(){let e=this.base.getContext("2d",{willReadFrequently:er()}),t=this.base.width/(parseFloat(this.base.style.width)||1);return e.setTransform(t,0,0,t,0,0),e.clearRect(0,0,this.frame.width,this.frame.height),e}draw(){let{recording:e,clock:t,frame:n}=this,{duration:s}=t;this.zoomed?(t.playing||t.following)&&this.scrollToCursor():[n.from,n.to]=[0,Math.max(s,.001)],(this.stale||this.drawnDuration!==s)&&(this.drawBase(),Ve(this.description,e.rounds.map(l=>pC(e,l)).join(" ")),this.drawnDuration=s,this.stale=!1),this.whole.hidden=!this.zoomed,this.moveOverlays();let{element:r}=this;r.setAttribute("aria-valuemax",s.toFixed(1)),r.setAttribute("aria-valuenow",t.time.toFixed(2));let o=e.at(t.time),a=o?.round.plan.phases[o.phase]?.name;r.setAttribute("aria-valuetext",`${Je(t.time)}${o?`, round ${o.round.number}`:""}${a?`, ${Ts(a)}`:""}${this.selection?`, ${um(e,this.selection)}`:""}`)}scrollToCursor(){let{frame:e,clock:t}=this,n=e.to-e.from;if(t.time>=e.from&&t.time<=e.to-.03*n)return;let s=Math.min(Math.max(0,t.time-.1*n),Math.max(0,t.duration-n));Math.abs(s-e.from)<1e-9||([e.from,e.to]=[s,s+n],this.stale=!0)}drawBase(){let{frame:e,recording:t}=this,n=this.pen();for(let r of e.lanes){let{name:o,label:a,plot:l,top:c,height:h}=r;Sv[o](n,e,r,t),e.narrow?l&&An(n,a,2,c-8):a.split(`
`).forEach((u,d)=>An(n,u,2,c+(l?8+13*d:h/2),{room:e.left-(l?26:6)}))}fv(n,e,this.highlights);let s=e.lane("force");s&&this.selection&&pv(n,e,s,this.selection,um(this.recording,this.selection)),this.drawVeil()}moveOverlays(){let{frame:e,clock:t}=this,n=e.width-e.right,s=e.x(t.time);this.cursor.hidden=s<e.left-1||s>n+1,this.cursor.style.transform=`translateX(${s.toFixed(1)}px)`,this.hair.hidden=this.hovered===null,this.hovered!==null&&(this.hair.style.transform=`translateX(${this.hovered}px)`)}drawVeil(){let{frame:e,recording:t}=this,n=e.width-e.right,s=Math.min(n,Math.max(e.left,e.x(t.now)));this.veil.hidden=!t.live||s>=n,Object.assign(this.veil.style,{left:`${s}px`,width:`${n-s}px`})}hover(e){let{frame:t}=this,n=e!==null&&e>=t.left&&e<=t.width-t.right;this.hovered=n?e:null,this.tip.hidden=!n,n&&(Ve(this.tip,this.describe(t.t(e)).join(`
`)),this.tip.style.left=`${Math.max(2,Math.min(e-this.tip.offsetWidth/2,t.width-this.tip.offsetWidth-2))}px`),this.ask()}describe(e){let t=this.recording.at(e);if(!t)return[Je(e,2)];let{round:n,normal:s,height:r,performance:o,phase:a,contact:l}=t,c=4*((this.frame.to-this.frame.from)/this.frame.span),h=this.recording.happenings.filter(({start:f,end:p})=>e>=f-c&&e<=p+c),u=this.highlights.filter(({start:f,end:p,label:x})=>x&&e>=f-c&&e<=p+c).map(({label:f})=>f),d=this.recording.rounds.findLast(f=>f.interpreted&&Math.abs(e-f.end)<4*c)??this.recording.resultAt(e);return[`${Je(e,2)} \xB7 round ${n.number}`,Ts(n.plan.phases[a]?.name??""),s===null?"":`force ${Fe(s,1)} N${l==="none"||n.target===null?"":`, target ${Fe(n.target,1)} N`}`,r===null?"":`tool height ${dl(t)}`,l==="none"?"":l==="pushed"?`pushed by somebody or something${r!==null&&r>Jf?", not on the surface":""}`:"contact with the surface",o===null?"":`performance ${_e(o)} predicted`,...d?mC(d):[],this.selection&&e>=this.selection[0]&&e<=this.selection[1]?um(this.recording,this.selection):"",...new Set(u),...h.map(({kind:f,words:p})=>`${f}: ${p}`)].filter(f=>f!=="")}};function pC(i,e){let{number:t,start:n,end:s,plan:r,contacts:{contact:o,pushed:a},normal:l,interpreted:c,events:h}=e,u=x=>Je(x.reduce((m,[g,y])=>m+y-g,0)),d=r.kind==="logged",f=e.count>0&&l.least<=l.largest,p=(x,m)=>`${x} ${m}${x===1?"":"s"}`;return`${[`Round ${t}, ${Je(n)} to ${Je(s)}`,d?"":p(r.strokes.length,"stroke"),f?`in contact for ${u(o)}`:d?"":`planned contact for ${u(o)}`,a.length?`pushed for ${u(a)}`:"",h.length?p(h.length,"detected event"):"",l.largest>0?`force at most ${Fe(l.largest,1)} N`:"",r.predicted===null?"":`predicted ${_e(r.predicted)}`,c?`estimated ${Gt(c.estimate)}`:"",uo(i,e)].filter(x=>x).join(", ")}.`}function mC(i){let{estimate:e}=i.interpreted,t=i.growthAt(i.length);return[`performance after round ${i.number}: ${Gt(e)} estimated`,t===null?"":`the estimate after round ${i.number} replaces the prediction of ${_e(t)}`,typeof i.truth?.performance=="number"?`true performance after round ${i.number}: ${_e(i.truth.performance)}`:""]}function um({rounds:i},[e,t]){let n=i.filter(o=>o.count&&o.start<=t&&o.end>=e).map(o=>o.normal.range(o.place(e-o.start)[0],o.place(t-o.start)[0]+1)).filter(o=>o!==null),[s,r]=[Math.min(...n.map(o=>o[0])),Math.max(...n.map(o=>o[1]))];return`selected: ${Je(e,2)} to ${Je(t,2)}${n.length?`, force ${Fe(s,1)} to ${Fe(r,1)} N`:""}`}var gC=150;function xC(i){let e=i.querySelector("details[name=w-menu][open]");return e?(e.open=!1,e.querySelector("summary").focus(),!0):!1}function yC(i,e,t){let n=_("button",{class:"w-button w-play",type:"button",click:()=>i.toggle()}),s=(u,d,f)=>_("button",{class:"w-button w-icon",type:"button","aria-label":d,title:`${d}  ${f}`,click:()=>i.seek(nd(e.stops,i.time,u))},sm(u<0?"before":"after")),r=_("button",{class:"w-button w-live",type:"button",title:"Follow the live run  L",click:()=>i.follow()},"LIVE"),o=_("output",{class:"w-time","aria-live":"off"}),a=_("select",{class:"w-select","aria-label":"Playback speed",change:()=>i.setSpeed(Number(a.value))},...yo.map(u=>_("option",{value:u},`${u}\xD7`))),l=_("details",{class:"w-keys",name:"w-menu"},_("summary",{},"Keys"),_("dl",{},...lv.flatMap(([u,d])=>[_("dt",{},u),_("dd",{},d)]))),c=null,h=()=>{let u=i.playing||i.following;u!==c&&(c=u,n.replaceChildren(sm(u?"pause":"play"),_("span",{},u?"Pause":"Play")),n.setAttribute("aria-label",u?"Pause":"Play")),r.hidden=!i.live,r.setAttribute("aria-pressed",String(i.following)),Ve(o,`${Je(i.time)} / ${Je(i.duration)}${i.isLate?" (slower than real time)":""}`),Number(a.value)!==i.speed&&(a.value=String(i.speed))};return h(),{element:_("div",{class:"w-transport",role:"group","aria-label":"Playback"},n,s(-1,"Previous event or stroke","["),s(1,"Next event or stroke","]"),r,o,a,t,l),show:h}}function xl(i,e,{compact:t=!1,clock:n}={}){let s=n??new vo,r=s.join(e),o=new sd(e,t,m=>{s.playing&&s.pause(),s.seek(m)}),a=new rd(e,s,t,m=>o.stage?.select(m)),l=t?null:new Lu(e,s,m=>o.choose(m)),c=o.stage&&!t?av(o.stage,e,s):null,h=yC(s,e,c?.element??null),u=_("div",{class:`w-view${t?" w-compact":""}`},_("div",{class:"w-grid"},o.element,l?.element,_("div",{class:"w-below"},h.element,a.element)));i.append(u);let d=ao(er()?gC:0,()=>{l?.show(),h.show(),c?.show()}),f=()=>{o.show(s.time),d.ask()},p=()=>Rn.draw(f),x=[r,s.subscribe(p),e.onChange(()=>{s.onGrowth(),p()}),cv(u,s,e,{f:()=>o.look("all"),v:()=>o.look("above"),t:()=>o.toggleFollow(),l:()=>s.live&&s.follow(),i:()=>a.selectTo(!1),o:()=>a.selectTo(!0),Escape:()=>xC(u)||a.select(null)})];return e.live&&s.follow(),f(),{element:u,clock:s,stage:o.stage,seek:m=>s.seek(m),show:(m={})=>{let g={...nr,...m};a.highlight(g.intervals),o.showData(g)},destroy:()=>{Rn.drop(f),d.stop(),c?.destroy();for(let m of x)m();o.destroy(),a.destroy(),n||s.destroy(),u.remove()}}}function wo(i){let e=new URLSearchParams(i.replace(/^#/,"")),t=Number.parseFloat(e.get("t")??""),n={time:Number.isFinite(t)&&t>=0?t:null,query:e.get("q")||null};for(let r of["episode","run"]){let o=e.get(r);if(o)return{kind:r,ids:[o],...n}}let s=(e.get("compare")??"").split(",").filter(r=>r);return s.length===2?{kind:"compare",ids:s,...n}:{kind:"home",ids:[],...n}}function _s({kind:i,ids:e,time:t,query:n}){let s=[];return i!=="home"&&s.push(`${i}=${e.map(encodeURIComponent).join(",")}`),t!==null&&i!=="home"&&s.push(`t=${t.toFixed(1)}`),n&&s.push(`q=${encodeURIComponent(n)}`),s.length?`#${s.join("&")}`:""}var Ev=(i,e)=>i.kind===e.kind&&i.ids.join()===e.ids.join();function Av(i){let e=_s(i);e!==location.hash&&history.replaceState(null,"",e||location.pathname)}var Mo=["A","B"],vC=500,[sr,dm,Rv]=[52,14,18],od={force:96,performance:110},bC=30,yl=(i,e,t=1)=>n=>{let s=Fe(t*n,e);return`${n>0?"+":""}${s}${i&&`\u202F${i}`}`},ad=yl("points",0,100);function _C({rounds:i}){if(!i.some(({count:t})=>t))return null;let e=0;for(let t of i){let{tool:n}=t;for(let s=1;s<t.count;s++){let r=Math.hypot(...[0,1,2].map(o=>n[7*s+o]-n[7*s-7+o]));Number.isFinite(r)&&t.contactAt(t.t[s])==="contact"&&(e+=r)}}return e}function Cv(i){let{head:e,rounds:t,ended:n}=i,{state:s,text:r}=Nu(i),o=e?.task,a=t.flatMap(({plan:m})=>m.considered?.find(g=>g.chosen)?.strategy??[]),l=t.findLast(({interpreted:m})=>m)??t.at(-1),c=l?.interpreted,h=s==="unknown",u=l?.plan.predicted??null,d=l?.truth?.performance??null,f=Math.max(...t.map(({normal:m})=>m.largest)),p=_C(i),x=c?Gt(c.estimate,0,h?n.verdict:void 0):nn;return[["Task",o?`${o.action} on ${o.surface}`:nn],["Medium",o?.medium??nn],["Tool",o?.tool??nn],["Strategy",o?[o.strategy,...a.length?[`chosen: ${a.join(", ")}`]:[]].join("; "):nn],["Target",sn(o?.target,_e),o?.target??null,ad],["Rounds",String(t.length),t.length,yl("",0)],["Predicted, last round",sn(u,_e),u,ad],["Estimated, last round",x,h?null:c?.estimate.mean??null,ad],["True, last round",sn(d,_e),d,ad],["Way in contact",sn(p,m=>`${Fe(m,2)} m`),p,yl("m",2)],["Duration",Je(i.duration),i.duration,yl("s",1)],["Largest force",f>0?`${Fe(f,1)} N`:nn,f>0?f:null,yl("N",1)],["Events",Sl(i.happenings.flatMap(({source:m,kind:g})=>m==="event"?[g]:[]))||"none"],["Result",r]]}function wC(i,e){let t=Cv(e);return Cv(i).map(([n,s,r,o],a)=>{let[,l,c]=t[a],h=typeof r=="number"&&typeof c=="number"?c-r:null;return{label:n,texts:[s,l],by:s===l?(o?h!==null:s!==nn)?"":nn:o&&h!==null?o(h):"differs"}})}function MC(i,e,t,n){return Array.from({length:n},(s,r)=>{let[o,a]=[r*t/n,(r+1)*t/n],l=i.roundAt(o);if(!l?.count||o>l.start+l.t.at(-1))return null;let c=l.place(o-l.start)[0];return e(l).range(c,Math.max(c,l.place(a-l.start)[0])+1)})}var fm=(i,e,t,n)=>Yt(i,e,t,n,{"font-size":11,fill:"var(--quiet)"}),Pv=i=>i?{"stroke-width":1.2}:{"stroke-width":3,"stroke-opacity":.7},Iv=i=>`var(--${i?"second":"first"})`,ld=class{constructor(e,t,n){this.pair=e;this.clock=n;let s=e.map(({head:l},c)=>_("li",{},pm(c),[l?.title,t[c]].filter(h=>h).join(" \xB7 "))),r="Line: predicted performance. Bar and dot: estimate with its 90\u202F% interval after a round. Cross: true.";this.element=_("section",{class:"s-compare","aria-label":"Comparison"},_("div",{},_("ul",{class:"w-legend"},...s),this.plots,_("p",{class:"w-quiet s-remark"},r)),this.table);let o=ao(vC,()=>this.draw()),a=new ResizeObserver(()=>o.ask());a.observe(this.plots),this.stops.push(()=>a.disconnect(),o.stop,n.subscribe(()=>this.move()),...e.map(l=>l.onChange(()=>o.ask())))}pair;clock;element;plots=_("div",{class:"s-curves"});table=_("div",{class:"s-table",tabindex:0,role:"group","aria-label":"Differences"});stops=[];cursor=null;x=()=>0;destroy(){for(let e of this.stops)e()}draw(){let{clock:e,pair:t}=this,n=this.plots.clientWidth;if(!n)return;let s=Math.max(1,n-sr-dm);this.x=c=>sr+c/Math.max(e.duration,.001)*s;let r={force:20,performance:20+od.force+bC},o=r.performance+od.performance+Rv;this.cursor=ie("line",{y1:0,y2:o-Rv,stroke:"var(--ink)","stroke-width":1.5});let{times:a}=lu(0,e.duration,Math.max(2,s/90)),l=ie("svg",{width:n,height:o,role:"img","aria-label":"Force and performance of both recordings over time",click:({offsetX:c})=>e.seek((c-sr)/s*e.duration)},...this.drawForce(r.force,n,Math.round(s)),...this.drawPerformance(r.performance,n),...a.map(c=>fm(this.x(c),o-3,Je(c,0),"middle")),this.cursor);this.plots.replaceChildren(l),this.move(),this.table.replaceChildren(SC(wC(...t)))}move(){let e=this.x(this.clock.time).toFixed(1);this.cursor?.setAttribute("x1",e),this.cursor?.setAttribute("x2",e)}drawForce(e,t,n){let{clock:s,pair:r}=this,o=r.map(d=>MC(d,({normal:f})=>f,s.duration,n)),a=o.flat().filter(d=>d!==null),[l,c]=[Math.min(0,...a.map(([d])=>d)),Math.max(5,...a.map(([,d])=>d))],h=d=>e+od.force*(1-(d-l)/(c-l)),u=o.map((d,f)=>{let p="";return d.forEach((x,m)=>{x&&(p+=`${p&&d[m-1]?"L":"M"}${sr+m} ${h(x[0]).toFixed(1)}V${h(x[1]).toFixed(1)}`)}),ie("path",{d:p,fill:"none",stroke:Iv(f),...Pv(f),"data-curve":`force-${Mo[f]}`})});return[...Lv("Force [N]",e,t,h,[0,c/2,c].map(Math.round),String),...u]}drawPerformance(e,t){let n=a=>e+od.performance*(1-a),s=this.pair.flatMap((a,l)=>a.rounds.flatMap(c=>this.drawRound(c,l,n))),o=[...new Set(this.pair.map(({head:a})=>a?.task?.target).filter(a=>a!==void 0))].map(a=>ie("line",{x1:sr,x2:t-dm,y1:n(a),y2:n(a),stroke:"var(--target)","stroke-dasharray":"6 4"}));return[...Lv("Performance [%]",e,t,n,[0,.5,1],a=>String(100*a)),...o,...s]}drawRound({plan:e,start:t,end:n,length:s,interpreted:r,truth:o},a,l){let c=Iv(a),h=[];if(e.growth.length){let d=e.growth.map(([f,p])=>`${this.x(t+Math.min(f,s)).toFixed(1)} ${l(p).toFixed(1)}`);h.push(ie("path",{d:`M${d.join("L")}H${this.x(n).toFixed(1)}`,fill:"none",stroke:c,...Pv(a),"data-curve":`predicted-${Mo[a]}`}))}let u=this.x(n)-4-9*(1-a);if(r){let{mean:d,low:f,high:p}=r.estimate;h.push(ie("rect",{x:u-3,y:l(p),width:6,height:Math.max(1,l(f)-l(p)),fill:c,"fill-opacity":.3,stroke:c},ie("title",{},`${Mo[a]}: estimated ${Gt(r.estimate)}`)),ie("circle",{cx:u,cy:l(d),r:3,fill:c}))}if(typeof o?.performance=="number"){let d=l(o.performance);h.push(ie("path",{d:`M${u-4} ${d-4}l8 8m0 -8l-8 8`,stroke:c,"stroke-width":2,fill:"none"},ie("title",{},`${Mo[a]}: true ${_e(o.performance)}`)))}return h}};function Lv(i,e,t,n,s,r){return[fm(0,e-8,i,"start"),...s.flatMap(o=>[ie("line",{x1:sr,x2:t-dm,y1:n(o),y2:n(o),stroke:"var(--rule)","stroke-width":.6}),fm(sr-6,n(o)+4,r(o),"end")])]}function pm(i){return _("i",{class:`s-letter s-letter-${i?"second":"first"}`},Mo[i]??"")}var SC=i=>Jn(["",...Mo,"B \u2212 A"],i.map(({label:e,texts:t,by:n})=>_("tr",{"data-differs":String(n!==""&&n!==nn)},_("th",{scope:"row"},e),...t.map(s=>_("td",{title:s},s)),_("td",{},n||"same"))));var Pn=class extends Error{constructor(t,n){super(t.message);this.fault=t;this.status=n}fault;status},TC="The studio does not respond. If it has ended, start it again: wisch studio.";async function vl(i,e){let t=await fetch(i,{...e,cache:"no-store"}).catch(()=>{throw new Pn({message:TC},0)});if(t.ok)return t;let{status:n}=t,s=await t.json().catch(()=>null);throw new Pn(s?.error??{message:`The studio refused the request with HTTP status ${n}.`},n)}var hd=async(i,e,t)=>await(await vl(i,{method:"POST",headers:{"content-type":"application/json"},body:JSON.stringify(e),signal:t??null})).json(),Dv=async i=>await(await vl(`api/overview?find=${encodeURIComponent(i)}`)).json(),Nv=async()=>await(await vl("api/vocabulary")).json(),kv=async()=>(await(await vl("api/health")).json()).words;async function EC(i,e){let t=await vl(`api/episodes/${encodeURIComponent(i)}/recording`);try{let n=new TextDecoder,s=t.body.getReader(),r="";for(let o=await s.read();!o.done;o=await s.read()){let a=n.decode(o.value,{stream:!0}),l=a.lastIndexOf(`
`);if(l>=0){for(let c of(r+a.slice(0,l)).split(`
`))e(c);r=""}r+=a.slice(l+1)}e(r+n.decode())}catch{throw new Pn({message:"The recording of this episode is damaged: it cannot be decompressed. To list damaged files, run: wisch memory verify."},0)}}var Ov=async(i,e,t)=>{let n={task:i,...e===null?{}:{seed:e},...t?{strategy:t}:{}};return(await hd("api/runs",n)).run},Uv=i=>hd(`api/runs/${encodeURIComponent(i)}/stop`,{}),Fv=i=>hd(`api/runs/${encodeURIComponent(i)}/clear`,{});async function Bv(i,e){let t=await hd("api/ask",{query:i},e);if("error"in t)throw new Pn(t.error,200);return t}function mm(i,e){let t=new EventSource("api/overview/events");t.addEventListener("changed",i);let n=!1;t.addEventListener("open",()=>{e(!0),n&&i(),n=!1}),t.addEventListener("error",()=>{n=!0,e(!1),t.readyState===EventSource.CLOSED&&setTimeout(()=>mm(i,e),2e3)})}var AC=4,RC=1e3,So=new Map;async function zv(i){let e=So.get(i);So.delete(i);let t=e??new vi;return e||await EC(i,n=>t.applyLine(n)),e||t.close(),Vv(i,t),t}function Vv(i,e){So.set(i,e);let[t]=So.keys();So.size>AC&&t!==void 0&&So.delete(t)}var cd=class{constructor(e,t){this.id=e;this.changed=t;this.open()}id;changed;recording=new vi;connection="connecting";message="";lines=0;events=null;later;failures=0;open(){let e=new EventSource(`api/runs/${encodeURIComponent(this.id)}/stream?after=${this.lines}`);this.events=e,e.addEventListener("open",()=>{this.failures=0,this.set("live")}),e.addEventListener("message",({data:t,lastEventId:n})=>{let s=Number(n);s<=this.lines||(this.lines=s,this.recording.applyLine(t))}),e.addEventListener("end",({data:t})=>this.end(t)),e.addEventListener("error",()=>{if(this.set("reconnecting"),e.readyState===EventSource.CLOSED){if(this.failures++,this.failures>3){this.recording.close(),this.set("gone");return}this.later=setTimeout(()=>this.open(),RC*this.failures)}})}end(e){this.close();let t=JSON.parse(e);this.message=t.message,this.recording.close();let n=t.state==="ended";n&&this.recording.ended&&Vv(this.episode,this.recording),this.set(n?"ended":"lost")}get episode(){return this.recording.ended?.episode??this.id}set(e){this.connection=e,this.changed()}close(){clearTimeout(this.later),this.events?.close(),this.events=null}};var To=class{constructor(e){this.actions=e}actions;element=_("section",{class:"s-stage","aria-label":"Recording"});panes=[];clock=null;stops=[];get shown(){return this.panes}get time(){return this.panes[0]?.view.clock.time??0}say(e,t,...n){this.clear(),this.element.append(_("div",{class:`s-said s-${e}`,role:e==="fault"?"alert":"status"},_("p",{},t),...n))}show(e,t){this.clear();let n=e.length>1;this.element.classList.toggle("s-two",n);let s=n?new vo:void 0;this.clock=s??null,this.panes=e.map((o,a)=>this.makePane(o,s,a)),s&&this.compare(s);let r=this.panes[0].view.clock;t!==null&&r.seek(t),this.stops.push(Ku(r,this.actions.rests))}compare(e){let[t,n]=this.panes;if(!t||!n)return;let s=new ld([t.recording,n.recording],[t.id,n.id],e);this.element.append(s.element),this.stops.push(()=>s.destroy(),CC(this.panes))}makePane(e,t,n){let{recording:s}=e,r=new gm(e,!t,this.actions,l=>a.seek(l));t&&r.element.prepend(pm(n));let o=_("div",{class:"s-view"});this.element.append(_("div",{class:"s-pane"},r.element,r.story,o));let a=xl(o,s,t?{compact:!0,clock:t}:{});return{...e,view:a,head:r}}async answer(e,t,n,s,r){let o=ir(e,t),a=n??this.panes.find(h=>o.includes(h.id))?.id??s(o);if(!a)return;let l=()=>this.panes.find(h=>h.id===a);l()||await r(a);let c=l();if(c){for(let{head:h}of this.panes)h.toggle(!1);Zy(c.view,Yy(e,t,a,c.recording))}}focus(){let e=this.panes[0]?.view.element;e&&(e.tabIndex=-1,e.focus({preventScroll:!0}))}onConnectionChanged(){for(let{head:e}of this.panes)e.show()}clear(){for(let e of this.stops)e();this.stops=[];for(let{view:e,head:t}of this.panes)t.destroy(),e.destroy();this.clock?.destroy(),this.clock=null,this.panes=[],this.element.classList.remove("s-two"),this.element.replaceChildren()}},Gv=({rounds:i})=>new E(...i[0]?.plan.surface.pose.slice(0,3)??[]);function CC(i){let e=!1,t=i.map(({view:{stage:n},recording:s})=>{let r=()=>{if(!(e||!n)){e=!0;for(let o of i){if(!o.view.stage||o.view.stage===n)continue;let a=Gv(o.recording).sub(Gv(s)),{target:l,eye:c}=n.camera.view;o.view.stage.camera.followLinked({target:l.add(a),eye:c.add(a)},n.camera.asked)}e=!1}};return n?.camera.controls.addEventListener("change",r),()=>n?.camera.controls.removeEventListener("change",r)});return()=>{for(let n of t)n()}}var PC={connecting:"connecting \u2026",live:"live",reconnecting:"connection lost, reconnecting \u2026",ended:"",lost:"the run ended unexpectedly",gone:"the run no longer exists"},gm=class{constructor(e,t,n,s){this.source=e;this.whole=t;this.actions=n;let{recording:r,id:o}=e;this.wasLive=e.live!==null,this.summary=new _o(r,s),this.story=_("div",{class:"s-story",hidden:!0},this.summary.element),this.stopButton=_("button",{class:"w-button s-stop",type:"button",hidden:!0,click:()=>this.stopIt(o)},"Stop"),this.storyButton=_("button",{class:"w-button",type:"button","aria-pressed":"false",click:()=>this.toggle(this.story.hidden)},"Summary"),this.element=_("header",{class:"s-head"},this.summary.title,_("span",{class:"s-result"},this.result,this.summary.badge),this.connection,this.kept,_("span",{class:"s-actions"},this.stopButton,this.storyButton,t&&n.compare&&_("button",{class:"w-button",type:"button",click:()=>n.compare?.()},"Compare"))),this.stop=mu(r,()=>this.show()),this.show()}source;whole;actions;element;story;result=_("b",{title:"estimated performance, 90 % interval"});connection=_("span",{class:"s-connection",role:"status"});kept=_("span",{class:"s-kept w-quiet"});stopButton;storyButton;summary;wasLive;stop;toggle(e){this.story.hidden=!e,this.storyButton.setAttribute("aria-pressed",String(e))}stopIt(e){this.stopButton.disabled=!0,Ve(this.stopButton,"Stopping \u2026"),Uv(e).catch(t=>{this.stopButton.disabled=!1,Ve(this.stopButton,"Stop"),Ve(this.connection,t.message)})}show(){let{recording:e,live:t,id:n}=this.source,s=e.rounds.findLast(a=>a.interpreted)?.interpreted?.estimate;s&&this.result.replaceChildren(_e(s.mean),_("small",{},` ${_e(s.low)} \u2013 ${_e(s.high)}`)),this.summary.badge.hidden=e.live;let r=t?.connection??"ended";this.connection.dataset.state=r,Ve(this.connection,[PC[r],t?.message??""].filter(a=>a).join(": ")),this.stopButton.hidden=!t||r==="ended"||r==="lost"||r==="gone";let o=t?.episode??n;this.summary.title.title=n,t&&r==="ended"&&this.kept.replaceChildren(this.actions.isKept(o)?_("a",{href:_s({kind:"episode",ids:[o],time:null,query:null}),title:o},"kept as an episode"):"not kept as an episode"),this.wasLive&&e.ended&&(this.wasLive=!1,this.whole&&this.toggle(!0))}destroy(){this.stop(),this.summary.destroy()}};async function IC(i){let e=Uint8Array.from(atob(i),n=>n.charCodeAt(0)),t=new Blob([e]).stream().pipeThrough(new DecompressionStream("gzip"));return vi.parse(await new Response(t).text())}function Hv(i,e){let t=u=>document.getElementById(u)?.textContent??"",n=new Map([...document.querySelectorAll("script[data-episode]")].map(u=>[u.dataset.episode,u.textContent??""])),s=JSON.parse(t("answers")),r=new To({rests:()=>{},compare:null,isKept:()=>!0}),o=new Map,a=0,l=(u,d)=>{let f=++a;return r.answer(s,u,d,p=>p.find(x=>n.has(x))??p[0],async p=>{let x=n.get(p);if(x===void 0)return r.say("note",`This page holds no recording of episode ${p}.`);r.say("wait","Loading \u2026");let m=o.get(p)??IC(x);o.set(p,m);try{let g=await m;f===a&&r.show([{id:p,recording:g,live:null}],null)}catch(g){f===a&&r.say("fault",`The recording of episode ${p} cannot be decompressed: ${String(g)}`)}})},c=ju(s,{show:(u,d,f)=>{l(d,f)},clear:()=>{for(let{view:u}of r.shown)u.show()}});i.classList.add("s-studio"),i.append(_("aside",{class:"s-side s-asked"},_("header",{class:"s-top"},_("h2",{class:"s-name"},"Answers of the memory"),e),_("section",{class:"s-ask"},_("pre",{class:"s-printed"},t("query")),_("div",{class:"s-answers"},...c))),r.element),Object.assign(window,{wisch:{stage:r}});let h=[...ir(s,null),...n.keys()].find(u=>n.has(u));h||gl(s)?l(null,h??null):r.say("note","The answers name no episode that the page could show.")}var LC=12,DC=/(?:([a-z]+):)?('?)([A-Za-z_][A-Za-z0-9_]*)$/;function NC(i){let e=[],t=new Set;for(let{name:s,arity:r,meaning:o}of i.predicates){let a=/^([^:]*?\)|[^:]*?): /.exec(o)?.[1]??"",l=a.startsWith(`${s}(`)?a:r?`${s}(`:s;t.has(l)||(t.add(l),e.push({name:`${s}/${r}`,kind:"predicate",meaning:o,text:l}))}let n=s=>({name:r,label:o,comment:a})=>({name:r,kind:s,meaning:a||o,text:kC(r)});e.push(...i.classes.map(n("class")),...i.properties.map(n("property")),...i.individuals.map(n("individual")));for(let s of i.builtins)e.push({name:s,kind:"Prolog",meaning:"predicate of standard Prolog",text:s.replace(/\/\d+$/,/\/0$/.test(s)?"":"(")});return e}function kC(i){let[e,t]=i.split(":");return/^[a-z][A-Za-z0-9_]*$/.test(t)?i:`${e}:'${t}'`}function OC(i,e,t){let n=DC.exec(e.slice(0,t));if(!n||/^[A-Z_]/.test(n[0])&&!n[1]&&!n[2]&&n[0].length<2)return null;let[s,r,,o]=n,a=o.toLowerCase(),l=i.flatMap(h=>{let[u,d]=h.name.includes(":")?h.name.split(":"):["",h.name];if(r&&u!==r)return[];let f=d.toLowerCase().indexOf(a);return f<0?[]:[{proposal:h,place:f?1:0,length:d.length}]});l.sort((h,u)=>h.place-u.place||Wv(h.proposal)-Wv(u.proposal)||h.length-u.length);let c=l.slice(0,LC).map(({proposal:h})=>h);return c.length?{from:t-s.length,found:c}:null}var Wv=({kind:i})=>["predicate","class","property","individual","Prolog"].indexOf(i),xm=class{constructor(e){this.field=e;e.addEventListener("input",()=>this.updateProposals()),e.addEventListener("blur",()=>this.close()),e.addEventListener("keydown",t=>this.onKey(t))}field;list=_("ul",{class:"s-proposals",id:"s-proposals",role:"listbox","aria-label":"Completions",hidden:!0});all=[];now=null;chosen=0;setVocabulary(e){this.all=NC(e)}close(){this.now=null,this.list.hidden=!0,this.field.setAttribute("aria-expanded","false"),this.field.removeAttribute("aria-activedescendant")}updateProposals(){let{value:e,selectionStart:t,selectionEnd:n}=this.field,s=/^[A-Za-z0-9_]/.test(e.slice(t));if(this.now=t===n&&!s?OC(this.all,e,t):null,!this.now)return this.close();this.chosen=0,this.draw()}draw(){let e=this.now.found.map(({name:t,kind:n,meaning:s},r)=>_("li",{id:`s-proposal-${r}`,role:"option","aria-selected":String(r===this.chosen),pointerdown:o=>{o.preventDefault(),this.chosen=r,this.accept()}},_("b",{},t),_("i",{},n),_("span",{},s)));this.list.replaceChildren(...e),this.list.hidden=!1,this.field.setAttribute("aria-expanded","true"),this.field.setAttribute("aria-activedescendant",`s-proposal-${this.chosen}`),e[this.chosen]?.scrollIntoView({block:"nearest"})}onKey(e){if(!this.now)return;let t=this.now.found.length;if(e.key==="ArrowDown")this.chosen=(this.chosen+1)%t;else if(e.key==="ArrowUp")this.chosen=(this.chosen+t-1)%t;else return e.key==="Tab"?this.accept(e):e.key==="Escape"?(e.preventDefault(),e.stopPropagation(),this.close()):void 0;e.preventDefault(),this.draw()}accept(e){e?.preventDefault();let{from:t,found:n}=this.now,{text:s}=n[this.chosen],{value:r,selectionStart:o}=this.field;this.field.setRangeText(s,t,o,"end");let a=this.field.selectionStart,l=r.slice(o);s.endsWith("(")&&l.startsWith("(")&&this.field.setRangeText("",a-1,a,"end"),this.close()}},ud=class{constructor(e){this.actions=e;this.button=_("button",{class:"w-button s-primary",type:"button",click:()=>this.asking?this.asking.abort():void this.ask()},"Ask"),this.element=_("section",{class:"s-ask",hidden:!0},_("div",{class:"s-field"},this.field,this.completer.list),_("div",{class:"s-row"},this.button,_("span",{class:"w-quiet"},"Enter: ask; Shift + Enter: new line; Tab: complete")),this.fault,this.examples,this.result),this.field.addEventListener("input",()=>{this.fault.hidden=!0}),this.loadVocabulary()}actions;element;field=_("textarea",{class:"s-query",rows:3,spellcheck:"false",autocomplete:"off","aria-label":"Query in Prolog",placeholder:"low_performance_round(Round, P)",role:"combobox","aria-autocomplete":"list","aria-controls":"s-proposals","aria-expanded":"false",keydown:e=>{e.key!=="Enter"||e.shiftKey||e.isComposing||(e.preventDefault(),this.ask())}});completer=new xm(this.field);fault=_("div",{class:"w-complaint s-fault",role:"alert",hidden:!0});chips=_("div",{class:"s-chips"});examples=_("details",{class:"s-examples",open:!0},_("summary",{},_("h2",{},"Example questions")),this.chips);result=_("div",{class:"s-answers","aria-live":"polite"});button;asking=null;async loadVocabulary(){try{let e=await Nv();this.completer.setVocabulary(e),this.chips.replaceChildren(...e.examples.map(({title:t,query:n},s)=>_("button",{class:"s-chip",type:"button",title:n,"data-example":s,click:()=>{this.field.value=n,this.ask()}},t)))}catch(e){this.complain({message:e.message})}}propose(e){this.asking?.abort(),this.asking=null,Ve(this.button,"Ask"),this.completer.close(),this.field.value=e,this.fault.hidden=!0,this.examples.open=!1,this.actions.clear(),this.result.replaceChildren(_("p",{class:"s-remark"},"This query comes from the page's address. Press Ask to run it."))}async ask(){let e=this.field.value.trim();if(!e||this.asking)return;this.completer.close(),this.fault.hidden=!0;let t=new AbortController;this.asking=t,this.examples.open=!1,Ve(this.button,"Cancel"),this.result.replaceChildren(_("p",{class:"w-quiet"},"Asking \u2026")),this.actions.asked(e);try{let n=await Bv(e,t.signal);this.result.replaceChildren(...ju(n,this.actions)),gl(n)?this.actions.show(n,null,null):this.actions.clear()}catch(n){if(this.asking!==t)return;this.result.replaceChildren(),t.signal.aborted||this.complain(n instanceof Pn?n.fault:{message:String(n)})}finally{this.asking===t&&(this.asking=null,Ve(this.button,"Ask"))}}complain({message:e,offset:t,length:n,line:s,column:r}){let o=this.field.value.trim(),a=[_("p",{},e)];if(t!==void 0&&n!==void 0){let l=t+n;a.push(_("pre",{},o.slice(0,t),_("mark",{},o.slice(t,l)||"\u2038"),o.slice(l))),o.includes(`
`)&&a.push(_("p",{class:"w-quiet"},`line ${s}, column ${r}`)),this.field.value=o,document.activeElement===this.field&&this.field.setSelectionRange(t,l)}this.fault.replaceChildren(...a),this.fault.hidden=!1}};var ym=["Channel","Finding","Now","Per run (95\u202F% interval)","p","Runs"],dd=class{element=_("section",{class:"s-health",hidden:!0,"aria-label":"Health of the memory"});async load(){this.element.children.length||this.element.replaceChildren(_("p",{class:"w-quiet"},"Assessing the memory \u2026"));try{let e=await kv();Mn(this.element,e)&&this.element.replaceChildren(...UC(e))}catch(e){let{message:t}=e;Mn(this.element,t)&&this.element.replaceChildren(_("p",{class:"w-complaint",role:"alert"},t))}}},$v=({needs_attention:i,too_few:e})=>i?0:e?2:1;function UC({groups:i,summary:e,remarks:t}){let n=[...i].sort((s,r)=>$v(s)-$v(r));return[_("p",{class:"s-count"},_("b",{},$n(e))),...n.map(FC),...t.map(s=>_("p",{class:"w-quiet s-remark"},s))]}function FC({things:i,runs:e,too_few:t,needs_attention:n,channels:s}){let[r,o]=n?["unmet","needs attention"]:["none",t?"too few runs":"nothing found"],a=[...s].sort((l,c)=>Number(c.needs_attention)-Number(l.needs_attention));return _("article",{class:"s-group"},_("h3",{},_("span",{},i),_("span",{class:"s-badge","data-state":r},o)),_("p",{class:"s-what"},e),t?_("p",{},`${$n(t)}. A drift cannot be assessed.`):_("div",{class:"s-table s-stacks",tabindex:0,role:"group","aria-label":`Channels of ${i}`},Jn(ym,a.flatMap(BC))))}function BC({channel:i,recorded:e,now:t,per_run:n,p:s,unknown:r,finding:o,needs_attention:a,sentences:l}){let c=r===void 0?[t,n,s]:[r],h=a?_("span",{"aria-hidden":"true"},"\u25B2 "):null,u=[_("td",{class:"s-finding"},_("span",{},h,o??nn)),...c.map(f=>_("td",r===void 0?{}:{class:"s-unknown",colspan:3},f)),_("td",{},String(e))];u.forEach((f,p)=>f.setAttribute("data-title",p===u.length-1?"Runs":ym[p+1]));let d=[_("tr",{"data-attention":String(a)},_("th",{scope:"row"},i),...u)];return l.length&&d.push(_("tr",{class:"s-sentences","data-attention":String(a)},_("td",{colspan:ym.length},...l.map(f=>_("p",{},$n(f)))))),d}var vm="M-2 -8h4v16h-4z",fd={HumanCollision:{name:Xs,shape:fo.collision,colour:"collision"},HandGuiding:{name:"hand guiding",shape:fo.hand,colour:"hand"},ContactLoss:{name:"contact loss",shape:fo.event,colour:"event",hollow:!0},Overload:{name:"overload",shape:fo.event,colour:"event"},ProtectiveStop:{name:"protective stop",shape:vm,colour:"bad"},Stopped:{name:"stop on request or by an error",shape:vm,colour:"bad"},EndedEarly:{name:"early end",shape:vm,colour:"bad"}},Xv=({events:i})=>Sl(i.flatMap(({class:e,count:t})=>Array.from({length:fd[e]?t:0},()=>fd[e].name)));function zC(i){let{seconds:e,round_starts:t}=i,n=c=>`${(100*Math.min(1,Math.max(0,c/e))).toFixed(2)}%`,s=(c,h)=>`${(100*Math.max(0,h-c)/e).toFixed(2)}%`,r=t.map((c,h)=>ie("rect",{x:n(c),y:3,width:s(c,t[h+1]??e),height:12,rx:2,class:"s-round"})),o=i.events.flatMap(c=>fd[c.class]?[{...c,...fd[c.class]}]:[]),a=o.map(({start:c,end:h,colour:u})=>ie("rect",{x:n(c),y:7.5,width:s(c,h),height:3,fill:`var(--${u})`})),l=o.map(({start:c,end:h,count:u,name:d,shape:f,colour:p,hollow:x})=>{let m=x?{fill:"var(--paper)",stroke:`var(--${p})`,"stroke-width":2}:{fill:`var(--${p})`,stroke:"var(--paper)"},g=`${u>1?`${u} \xD7 `:""}${d}, ${Je(c)} to ${Je(h)}`;return ie("svg",{x:n(c),y:9,overflow:"visible"},ie("path",{d:f,...m},ie("title",{},g)))});return ie("svg",{class:"s-time","aria-hidden":"true"},...r,...a,...l)}function VC({performance:i,low:e,high:t,target:n}){if(i===null)return null;let s=c=>`${(100*Math.min(1,Math.max(0,c))).toFixed(2)}%`,[r,o]=[e??i,t??i],a=`estimated ${Gt({mean:i,low:r,high:o})}${n===null?"":`, target ${_e(n)}`}`,l=(c,h,u,d)=>ie("line",{x1:s(c),x2:s(c),y1:h,y2:u,...d});return ie("svg",{class:"s-estimate",role:"img","aria-label":a},ie("title",{},a),ie("rect",{y:6,width:"100%",height:6,rx:3,class:"s-round"}),ie("rect",{x:s(r),y:4,width:s(o-r),height:10,rx:2,fill:"var(--estimated)","fill-opacity":.4}),l(i,2,16,{stroke:"var(--estimated)","stroke-width":2.5}),n!==null&&l(n,0,18,{stroke:"var(--target)","stroke-width":1.5,"stroke-dasharray":"3 2"}))}var qv=i=>i.seconds>0?_("span",{class:"s-strip"},zC(i),VC(i)):null;var GC=200,pd=class{constructor(e){this.actions=e;let t;this.search=_("input",{class:"s-search",type:"search",placeholder:"Search episodes","aria-label":"Search episodes",autocomplete:"off",input:()=>{clearTimeout(t),t=setTimeout(()=>e.find(this.words),GC)}}),this.element=_("section",{class:"s-runs"},_("button",{class:"w-button s-primary",type:"button",click:()=>e.start()},"Start a task"),this.search,this.note,this.list,this.where)}actions;element;list=_("div",{class:"s-list"});search;where=_("p",{class:"s-where w-quiet"});note=_("div",{class:"s-picking",hidden:!0,role:"status"});overview=null;current=[];picking=null;get words(){return this.search.value.trim()}show(e){this.overview=e,this.draw()}mark(e){this.current=e,this.draw()}compareWith(e){this.picking=e,this.note.hidden=!e,this.note.replaceChildren(...e?[_("p",{},"Choose a run or episode to compare with."),_("button",{class:"w-button",type:"button",click:()=>this.compareWith(null)},"Cancel")]:[])}draw(){if(!this.overview)return;let{list:e,runs:t,memory:n}=this.overview;if(!Mn(this.list,[e,t,this.current]))return;let s=document.activeElement?.dataset.key,r=[],o=t.filter(({state:a})=>a!=="ended");o.length&&r.push(_("h2",{},"Now"),_("ul",{},...o.map(a=>this.makeRun(a))));for(let[a,l]of $C(e.episodes))r.push(_("h2",{},a),_("ul",{},...l.map(c=>this.makeEpisode(c))));!e.episodes.length&&(this.words||!o.length)&&r.push(_("p",{class:"w-quiet"},this.words?"No matching episodes.":"There are no episodes yet. Start a task.")),e.total>e.episodes.length&&r.push(_("p",{class:"w-quiet"},`The list shows the newest ${e.episodes.length} of ${e.total} episodes. Use the search for older ones.`)),e.broken.length&&r.push(_("details",{class:"s-broken"},_("summary",{},`${e.broken.length} unreadable ${e.broken.length===1?"episode":"episodes"}`),...e.broken.map(a=>_("p",{},a)))),this.list.replaceChildren(...r),Ve(this.where,`Memory: ${n}`),s&&this.list.querySelector(`[data-key="${CSS.escape(s)}"]`)?.focus()}makeLink(e,t,...n){let s=this.current.includes(t);return _("a",{href:_s({kind:e,ids:[t],time:null,query:null}),"data-key":t,"aria-current":s?"true":null,click:r=>{!this.picking||r.ctrlKey||r.metaKey||r.shiftKey||(r.preventDefault(),this.actions.pick(t))}},...n)}makeRun({id:e,task:t,begun:n,state:s,message:r}){let o=s==="lost",a=o?"ended unexpectedly":`running${n?` since ${WC(n)}`:""}`;return _("li",{},this.makeLink("run",e,_("span",{class:"s-title"},_("i",{class:`s-dot${o?" s-dot-lost":""}`,"aria-hidden":"true"}),t),_("span",{class:"s-what"},_("span",{},a)),o&&r?_("span",{class:"s-what s-bad"},r):null),o&&_("button",{class:"w-button s-clear",type:"button",title:"Remove from the list","aria-label":`Remove ${t} from the list`,click:()=>{Fv(e).catch(()=>{})}},"\xD7"))}makeEpisode(e){let{performance:t,low:n,high:s,rounds:r}=e,o=[Yv(new Date(1e3*e.begun)),`${r} ${r===1?"round":"rounds"}`,`${Fe(e.seconds,0)} s`];e.events.length&&o.push(Xv(e)),e.has_recording||o.push("no recording"),e.verdict&&!e.met&&o.push(Du(e).text);let a=n!==null&&s!==null?`, 90\u202F% interval ${_e(n)} to ${_e(s)}`:"";return _("li",{},this.makeLink("episode",e.id,_("span",{class:"s-title"},_("span",{},e.title),t===null?null:_("b",{title:`estimated performance${a}`},_e(t)),HC(e)),qv(e),_("span",{class:"s-what"},o.join(" \xB7 "))))}};function HC(i){let{state:e,text:t}=Du(i),n=e==="unmet"&&i.performance===null?"none":e;return _("span",{class:"s-badge","data-state":n,title:t},{met:"met",unmet:"not met",unknown:"unknown",none:"\u2013"}[n])}var Yv=i=>i.toLocaleTimeString([],{hour:"2-digit",minute:"2-digit"});function WC(i){let e=new Date(`${i.replace(" ","T").replace(/Z$/,"")}Z`);return Number.isNaN(e.getTime())?i:Yv(e)}function $C(i){let e=new Map,t=s=>s.toLocaleDateString([],{weekday:"short",year:"numeric",month:"short",day:"numeric"}),n=t(new Date);for(let s of i){let r=t(new Date(1e3*s.begun));r===n&&(r="Today"),e.set(r,[...e.get(r)??[],s])}return e}var XC=["best","adaptive","grid","rrt","kde"],md=class{constructor(e){this.begun=e;let t=_("form",{class:"s-own",submit:n=>{n.preventDefault(),this.start(this.path.value.trim())}},_("label",{},"Your own task file",this.path),_("button",{class:"w-button",type:"submit"},"Start"));this.element=_("dialog",{class:"s-dialog","aria-labelledby":"s-start-title"},_("header",{},_("h1",{id:"s-start-title"},"Start a task"),_("button",{class:"w-button",type:"button","aria-label":"Close",click:()=>this.element.close()},"\xD7")),this.fault,this.list,t,_("div",{class:"s-options"},_("label",{},"Seed",this.seed),_("label",{},"Strategy",this.strategy))),this.list.append(_("li",{},"Loading \u2026")),this.element.addEventListener("click",n=>{n.target===this.element&&this.element.close()}),this.element.addEventListener("input",()=>{this.fault.hidden=!0})}begun;element;list=_("ul",{class:"s-scenarios"});seed=_("input",{type:"number",min:0,step:1,placeholder:"from the task","aria-label":"Seed"});strategy=_("select",{class:"w-select","aria-label":"Strategy"},_("option",{value:""},"from the task"),...XC.map(e=>_("option",{value:e},e)));path=_("input",{type:"text",placeholder:"/path/to/task.toml","aria-label":"Task file on this machine",autocomplete:"off",spellcheck:"false"});fault=_("p",{class:"w-complaint",role:"alert",hidden:!0});busy=!1;open(){this.fault.hidden=!0,this.element.showModal()}setScenarios(e){Mn(this.list,e)&&(this.list.replaceChildren(...e.map(({name:t,about:n})=>_("li",{},_("div",{},_("b",{},t),_("p",{},n)),_("button",{class:"w-button s-primary",type:"button","data-task":t,"aria-label":`Start ${t}`,click:()=>{this.start(t)}},"Start")))),e.length||this.list.append(_("li",{},"No shipped tasks were found.")))}async start(e){if(this.busy)return;let t=this.seed.value.trim();if(!e)return this.complain("The path is empty. Enter the path of a task file.");if(t&&!/^\d+$/.test(t))return this.complain("The seed must be a whole number, 0 or greater.");this.fault.hidden=!0,this.setBusy(!0);try{let n=await Ov(e,t?Number(t):null,this.strategy.value||null);this.element.close(),this.begun(n)}catch(n){this.complain(n instanceof Pn?n.message:String(n))}finally{this.setBusy(!1)}}setBusy(e){this.busy=e,this.element.toggleAttribute("data-busy",e);for(let t of this.element.querySelectorAll("button"))t.disabled=e}complain(e){this.fault.hidden=!1,Ve(this.fault,e),this.fault.scrollIntoView({block:"nearest"})}};var bl={kind:"home",ids:[],time:null,query:null},bm=class{side;stage;ask;health=new dd;dialog;tabs;offline=_("p",{class:"s-offline",role:"status",hidden:!0},"The studio does not respond. If it has ended, start it again: wisch studio.");aside;known=null;place=bl;live=[];waits=!1;opened=0;constructor(e,t){this.side=new pd({find:()=>{this.refresh()},start:()=>this.dialog.open(),pick:s=>this.compare(s)}),this.ask=new ud({show:(s,r,o)=>{this.show(s,r,o)},clear:()=>{for(let{view:s}of this.stage.shown)s.show()},asked:s=>this.keep({query:s})}),this.stage=new To({rests:s=>this.keep({time:s}),compare:()=>{this.open("runs"),this.side.compareWith(this.place.ids[0]??null)},isKept:s=>this.isKept(s)}),this.dialog=new md(s=>{this.go({...bl,kind:"run",ids:[s]}).then(()=>this.stage.focus())});let n=(s,r,o)=>_("button",{class:"w-button",type:"button","aria-pressed":"false",title:o,click:()=>this.isNarrow&&this.aside.dataset.open===s?this.open(null):this.open(s)},r);this.tabs={runs:n("runs","Runs","Runs and episodes"),ask:n("ask","Ask","Ask the memory ( / )"),health:n("health","Health","What changes from run to run")},this.aside=_("aside",{class:"s-side"},_("header",{class:"s-top"},_("h2",{class:"s-name"},"wisch studio"),this.tabs.runs,this.tabs.ask,this.tabs.health,t),this.offline,this.side.element,this.ask.element,this.health.element),e.classList.add("s-studio"),e.append(this.aside,this.stage.element,this.dialog.element),this.open("runs")}async begin(){addEventListener("hashchange",()=>{this.route()}),document.addEventListener("keydown",t=>{let n=t.target;t.key!=="/"||t.ctrlKey||t.metaKey||t.altKey||/^(INPUT|TEXTAREA|SELECT)$/.test(n.tagName)||(t.preventDefault(),this.open("ask"),this.ask.field.focus())}),mm(()=>{this.refresh()},t=>{this.offline.hidden=t}),Object.assign(window,{wisch:{studio:this,stage:this.stage}});let e=this.refresh();wo(location.hash).kind!=="episode"&&await e,await this.route()}get isNarrow(){return matchMedia("(max-width: 760px)").matches}open(e){this.aside.dataset.open=e??"",this.side.element.hidden=e!=="runs",this.ask.element.hidden=e!=="ask",this.health.element.hidden=e!=="health",e==="health"&&this.health.load();for(let t of["runs","ask","health"])this.tabs[t].setAttribute("aria-pressed",String(e===t))}async refresh(){try{this.known=await Dv(this.side.words),this.side.show(this.known),this.dialog.setScenarios(this.known.scenarios),this.stage.onConnectionChanged(),this.health.element.hidden||this.health.load(),this.waits&&this.route()}catch(e){this.known||this.stage.say("fault",e.message)}}isKept(e){return this.known?.list.episodes.some(t=>t.id===e)??!1}async go(e){history.pushState(null,"",_s(e)||location.pathname),await this.route()}keep(e){this.place={...this.place,...e},Av(this.place)}async route(){let e=wo(location.hash),{query:t}=e;e.kind==="home"&&(e={...this.first(),query:t});let n=this.place;this.place=e,!Ev(n,e)||!this.stage.shown.length?await this.load(e):e.time!==null&&Math.abs(e.time-this.stage.time)>.06&&this.stage.shown[0].view.seek(e.time),t&&t!==n.query&&(this.open("ask"),this.ask.propose(t))}first(){let e=this.known?.runs.find(({state:n})=>n==="running");if(e)return{...bl,kind:"run",ids:[e.id]};let t=this.known?.list.episodes.find(({has_recording:n})=>n);return t?{...bl,kind:"episode",ids:[t.id]}:bl}async load(e){let t=++this.opened;for(let n of this.live)n.close();if(this.live=[],this.side.compareWith(null),this.side.mark(e.ids),this.isNarrow&&e.kind!=="home"&&this.open(null),this.waits=e.kind==="home"&&!this.known,!this.waits){if(e.kind==="home"){this.stage.say("note","This memory has no runs yet.",_("button",{class:"w-button s-primary",type:"button",click:()=>this.dialog.open()},"Start a task"));return}this.stage.say("wait","Loading \u2026");try{let n=[];for(let s of e.ids)n.push(await this.source(s,e.kind==="run"));if(t!==this.opened)return;this.stage.show(n,e.time),document.title=`${n.map(({id:s,recording:r})=>r.head?.title??s).join(" | ")} \u2013 wisch studio`}catch(n){if(t!==this.opened)return;let s=n instanceof Pn?n.message:`The recording cannot be shown: ${String(n)}`;this.stage.say("fault",s,_("p",{class:"w-quiet"},"Queries about this episode still work."))}}}async source(e,t){if(t&&!this.isRun(e)&&await this.refresh(),this.isRun(e))return this.liveSource(e);try{return{id:e,recording:await zv(e),live:null}}catch(n){if(!(n instanceof Pn)||n.status!==404)throw n;if(await this.refresh(),this.isRun(e))return this.liveSource(e);throw this.known&&!this.isKept(e)?new Pn({message:`There is no run or episode ${e}. A run that is stopped before its first motion is not kept.`},404):n}}isRun(e){return this.known?.runs.some(t=>t.id===e)??!1}liveSource(e){let t=new cd(e,()=>this.liveChanged(t));return this.live.push(t),{id:e,recording:t.recording,live:t}}liveChanged(e){this.stage.onConnectionChanged(),e.connection==="ended"&&this.refresh().then(()=>{this.place.kind!=="run"||this.place.ids[0]!==e.id||!this.isKept(e.episode)||(this.keep({kind:"episode",ids:[e.episode]}),this.side.mark(this.place.ids))})}compare(e){let t=this.place.ids[0];this.side.compareWith(null),!(!t||t===e)&&this.go({kind:"compare",ids:[t,e],time:this.stage.time,query:null})}async show(e,t,n){await this.stage.answer(e,t,n,([s])=>s,async s=>{let r={kind:"episode",ids:[s],time:null,query:this.place.query};history.pushState(null,"",_s(r)),this.place=r,await this.load(r)}),this.isNarrow&&this.open(null)}};function Zv(i,e){new bm(i,e).begin()}function _m(){let i=_("button",{class:"w-button w-theme",type:"button",click:()=>ox(us()==="dark"?"light":"dark")}),e=()=>Ve(i,us()==="dark"?"Light":"Dark");return to(e),e(),i}function qC({clock:i}){Ku(i,e=>{let t=`#t=${e.toFixed(1)}`;if(!(location.hash===t||!location.hash&&e===0))try{history.replaceState(null,"",t)}catch{}}),addEventListener("hashchange",()=>{let{time:e}=wo(location.hash);e!==null&&Math.abs(e-i.time)>.06&&i.seek(e)})}function YC(i){let e=vi.parse(document.getElementById("recording")?.textContent??"");i.classList.add("w-report");let t=new _o(e,s=>{n.seek(s),n.element.scrollIntoView({block:"start"})},_m());i.append(t.element);let n=xl(i,e);n.seek(wo(location.hash).time??0),qC(n),Object.assign(window,{wisch:{recording:e,view:n,Recording:vi,mountView:xl}})}ax();var Eo=document.getElementById("app"),{page:jv}=document.documentElement.dataset;Eo&&jv==="report"?YC(Eo):Eo&&jv==="answers"?Hv(Eo,_m()):Eo&&Zv(Eo,_m());})();
